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
    """Return a motion of two contact wires, recorded as two.

    Each value is the number of its node among all contact wires, and a tenth of the row.
    """
    rows = np.arange(len(first))
    own = np.array(first)[:, None] + [0, 0]  # both windows begin at the same node of their wires
    nodes = np.concatenate([own[:, :1], own[:, 1:] + NODES], axis=1)
    values = (nodes[:, :, None] + np.arange(width)).reshape(len(first), -1) + 0.1 * rows[:, None]
    data: Any = {
        "motion_up": (("motion_time", "motion_node"), values.astype("f4"), {}),
        "motion_first": (("motion_time", "motion_wire"), own, {}),
        "motion_count": (("motion_wire",), np.array([width, width]), {}),
        "contact_wire_node_lane": (("contact_wire_node",), np.repeat([1, 2], NODES), {}),
    }
    names = np.array(["contact_wire 1", "contact_wire 2"])
    coords: Any = {
        "motion_time": (("motion_time",), 0.01 * rows, {}),
        "motion_wire": (("motion_wire",), names, {}),
    }
    return Plain(data, coords, {})


def test_each_wire_has_its_window() -> None:
    motion = recorded(dataset([0, 1, 2], 4), geometry())
    assert motion.times == pytest.approx([0.0, 0.01, 0.02])
    assert [rows.wire for rows in motion.wires] == [0, 1]
    for rows in motion.wires:
        assert rows.first.tolist() == [0, 1, 2]
        assert rows.count.tolist() == [4, 4, 4]
        begin = geometry()["wires"][rows.wire]["first"]
        for row in range(3):
            assert rows.up[row] == pytest.approx(begin + row + np.arange(4) + 0.1 * row)


def test_a_window_over_two_wires_is_a_window_of_each() -> None:
    # As stitch wires: several of the geometry are one wire of the record.
    data: Any = {
        "motion_up": (
            ("motion_time", "motion_node"),
            (np.add.outer([1, 4, 8], range(4)) + 0.1 * np.arange(3)[:, None]).astype("f4"),
            {},
        ),
        "motion_first": (("motion_time", "motion_wire"), np.array([[1], [4], [8]]), {}),
        "motion_count": (("motion_wire",), np.array([4]), {}),
        "contact_wire_node_x": (("contact_wire_node",), np.arange(2.0 * NODES), {}),
    }
    coords: Any = {
        "motion_time": (("motion_time",), np.arange(3.0), {}),
        "motion_wire": (("motion_wire",), np.array(["contact_wire 1"]), {}),
    }
    motion = recorded(Plain(data, coords, {}), geometry())
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
