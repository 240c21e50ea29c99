"""Motion that is thinned to a size: which rows and nodes stay, and that their values do."""

from typing import Any, cast

import numpy as np
import pytest

from arcless.studio.animation.cut import cut
from arcless.studio.animation.thinning import LEVELS, thinned
from arcless.studio.at_rest.plain_geometry import Geometry
from tests.support.waving import uplift, waving

LENGTH, NODES, SPEED = 2000.0, 4001, 160.0
# Displacements are singles of some centimetres.
SINGLE = 1e-8


def line() -> Geometry:
    x = np.linspace(0.0, LENGTH, NODES).tolist()
    rest: Any = {"x": x, "y": [0.0] * NODES, "z": [5.0] * NODES}
    spans = [50.0 * n for n in range(40)]
    supports = [*spans, LENGTH]
    nodes = range(37, NODES, 53)
    found: Any = {
        "name": "a line", "spatial": True, "height_m": 5.0,
        "spans": [
            {"number": n + 1, "start_m": at, "end_m": at + 50.0} for n, at in enumerate(spans)
        ],
        "wires": [
            {"name": "contact wire", "kind": "contact", "first": 0, **rest},
            {"name": "messenger wire", "kind": "messenger", "first": 0, **rest},
        ],
        "droppers": [
            {"name": f"D{node}", "span": 1, "x_m": x[node], "top": [x[node], 0, 6], "length_m": 1.0,
             "bottom": [x[node], 0, 5], "force_N": 80.0, "wire": 0, "node": node, "top_wire": 1,
             "top_node": node}
            for node in nodes
        ],
        "supports": [
            {"name": f"S{n}", "x_m": at, "stagger_m": 0.0, "wire": 0, "node": 100 * n, "arms": []}
            for n, at in enumerate(supports)
        ],
    }  # fmt: skip
    return cast(Geometry, found)


GEOMETRY = line()
TIMES = np.arange(0.0, 10.0, 0.005)
X = 200.0 + SPEED * TIMES
MOTION = waving(GEOMETRY, TIMES, X)


def test_what_fits_is_the_record() -> None:
    small = thinned(MOTION, GEOMETRY, 5.0, 1e9)
    assert small.level == LEVELS[0]
    assert small.whole
    assert np.array_equal(small.motion.times, TIMES)
    assert all(mask.all() for mask in small.kept)
    assert np.array_equal(small.motion.wires[0].up, MOTION.wires[0].up)


@pytest.mark.parametrize("limit", [5e6, 1.5e6, 4e5])
def test_what_stays_has_its_values(limit: float) -> None:
    small = thinned(MOTION, GEOMETRY, 6.0, limit)
    left = cut(GEOMETRY, small.kept).geometry
    assert small.level != LEVELS[0]
    for one in small.motion.wires:
        along = np.asarray(left["wires"][one.wire]["x"])
        for row, time in enumerate(small.motion.times):
            at = along[one.first[row] : one.first[row] + one.count[row]]
            exact = uplift(at, 200.0 + SPEED * time)
            assert one.up[row, : one.count[row]] == pytest.approx(exact, abs=SINGLE)
            assert np.array_equal(one.across[row], -one.up[row])  # type: ignore[index]


def test_nodes_that_hold_something_stay() -> None:
    small = thinned(MOTION, GEOMETRY, 6.0, 2.5e6)
    left = cut(GEOMETRY, small.kept)
    assert small.whole
    assert len(left.droppers) == len(GEOMETRY["droppers"])
    for dropper in left.geometry["droppers"]:
        wire = left.geometry["wires"][dropper["wire"]]
        assert wire["x"][dropper["node"]] == dropper["x_m"]
    for support in left.geometry["supports"]:
        assert left.geometry["wires"][0]["x"][support["node"]] == support["x_m"]


def test_what_must_be_shortened_has_the_worst_place() -> None:
    small = thinned(MOTION, GEOMETRY, 6.0, 4e5)
    assert not small.whole
    assert small.motion.times[0] < 6.0 < small.motion.times[-1]
    left = cut(GEOMETRY, small.kept)
    assert len(left.supports) < len(GEOMETRY["supports"])
    # Numbers of what is left are those in the whole line.
    first = left.geometry["supports"][0]
    assert GEOMETRY["supports"][left.supports[0]]["name"] == first["name"]
    assert {span["number"] for span in left.geometry["spans"]} < set(range(1, 41))


def test_the_worst_place_at_an_end_leaves_no_gap() -> None:
    for worst in (TIMES[0], TIMES[-1]):
        small = thinned(MOTION, GEOMETRY, worst, 4e5)
        assert len(small.motion.times) > 10
        assert small.motion.times[0] <= worst <= small.motion.times[-1]
