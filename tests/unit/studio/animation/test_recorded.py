"""Recorded motion as rows of wires: windows over several wires of a kind."""

from typing import Any, cast

import numpy as np
import pytest

from arcless.dataset.plain_dataset import Plain
from arcless.errors import OutputError
from arcless.studio.animation.recorded import recorded
from arcless.studio.at_rest.plain_geometry import Geometry

NODES = 6


def geometry() -> Geometry:
    """Return two contact wires with six nodes each, and a messenger wire that has no motion."""
    rest: Any = {"x": list(range(NODES)), "y": [0.0] * NODES, "z": [5.0] * NODES}
    wires = [("contact", 0), ("contact", NODES), ("messenger", 0)]
    found: Any = {
        "name": "", "spatial": False, "height_m": 5.0, "spans": [], "droppers": [], "supports": [],
        "wires": [{"name": kind, "kind": kind, "first": first, **rest} for kind, first in wires],
    }  # fmt: skip
    return cast(Geometry, found)


def dataset(first: list[int], width: int) -> Plain:
    """Return a motion in which each value is the number of its node, and a tenth of the row."""
    rows = np.arange(len(first))
    values = np.add.outer(np.array(first), np.arange(width)) + 0.1 * rows[:, None]
    data: Any = {
        "contact_wire_motion": (("motion_time", "place"), values.astype("f4"), {}),
        "contact_wire_motion_first": (("motion_time",), np.array(first), {}),
    }
    return Plain(data, {"motion_time": (("motion_time",), 0.01 * rows, {})}, {})


def test_a_window_over_two_wires_is_a_window_of_each() -> None:
    motion = recorded(dataset([1, 4, 8], 4), geometry())
    assert motion.times == pytest.approx([0.0, 0.01, 0.02])
    one, two = motion.wires
    assert (one.wire, two.wire) == (0, 1)
    assert one.count.tolist() == [4, 2, 0]
    assert two.count.tolist() == [0, 2, 4]
    for rows in motion.wires:
        begin = geometry()["wires"][rows.wire]["first"]
        for row, (first, count) in enumerate(zip(rows.first, rows.count, strict=True)):
            expected = begin + first + np.arange(count) + 0.1 * row
            assert rows.up[row, :count] == pytest.approx(expected)


def test_a_run_without_motion_says_how_to_record_it() -> None:
    with pytest.raises(OutputError, match=r"no recorded motion; hint: .*--set output\.motion=true"):
        recorded(Plain({}, {}, {}), geometry())
