"""Recorded motion is that of the line, changes nothing of a run, and reaches a viewer in pieces."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import arcless
from arcless import ContactError
from arcless.simulate.recording import motion
from arcless.simulate.recording.motion import MotionPiece, motion_bytes

SHORT = {"travel.end": "200 m", "analysis.spans": [2, 3]}
EXPLICIT = "en50318-ac-simple-320"
# Of explicit steps β h² a goes unfiltered, m: under a contact of 250 N that is
# ¼ (1 ms)² 250 N / (1.35 kg/m 0.45 m), and the filter changes no more than all of it.
UNFILTERED = 1e-4


def scenario(name: str, **changes: Any) -> arcless.Scenario:
    return arcless.load(name).with_(**SHORT, **changes)


def moving(name: str, **changes: Any) -> arcless.Scenario:
    return scenario(name, **{"output.motion": True} | changes)


def moved(dataset: Any, wire: int, node: int) -> np.ndarray:
    """The displacement of a node in the rows that hold it, NaN in the others, m."""
    counts = dataset["motion_count"].values
    start = counts[:wire].sum()
    column = node - dataset["motion_first"].values[:, wire]
    inside = (column >= 0) & (column < counts[wire])
    values = dataset["motion_up"].values[
        np.arange(len(column)), start + np.where(inside, column, 0)
    ]
    return np.where(inside, values, np.nan)


@pytest.mark.parametrize(
    ("solver", "within"),
    [
        ({"solver.scheme": "central-difference"}, UNFILTERED),
        # Single precision of less than 0.25 m.
        ({"solver.scheme": "generalised-alpha", "solver.residual_flexibility": False}, 2e-8),
    ],
    ids=["explicit", "implicit"],
)
def test_nodes_move_as_recorded_points_do(solver: dict[str, Any], within: float) -> None:
    bare = scenario(EXPLICIT, **solver)
    at_rest = arcless.statics(bare).equilibrium
    (wire,) = at_rest.mesh.contact_wires
    x = at_rest.positions[wire, 0]
    # In the span, not at droppers: nodes that only motion asks for.
    nodes = [int(np.searchsorted(x, place)) for place in (140.3, 152.1, 161.7)]
    points = {"output.points": [float(x[node]) for node in nodes]}
    found = arcless.run(moving(EXPLICIT, **solver, **points)).dataset
    assert found["motion_up"].dtype == np.float32
    rows = np.searchsorted(found["line_time"].values, found["motion_time"].values - 1e-9)
    for k, node in enumerate(nodes):
        own = moved(found, 0, node)
        seen = ~np.isnan(own)
        assert seen.sum() > 100
        point = found["point_uplift"].values[rows, k]
        assert np.abs(point[seen]).max() > 0.01
        assert np.abs(own - point)[seen].max() < within
    order = found["motion_dropper_order"].values
    first = found["motion_dropper_first"].values
    force = found["motion_dropper_force"].values
    for row in (0, len(first) // 2, len(first) - 1):
        own = order[first[row] : first[row] + force.shape[1]]
        recorded = found["dropper_force"].values[rows[row], own]
        np.testing.assert_array_equal(force[row], recorded.astype(np.float32))


@pytest.mark.parametrize("name", [EXPLICIT, "en50318-2002-250", "norway-s25-250"])
def test_a_run_is_the_same_with_and_without(name: str) -> None:
    plain = arcless.run(scenario(name)).dataset
    pieces: list[MotionPiece] = []
    kept = arcless.run(moving(name)).dataset
    watched = arcless.run(scenario(name), watch=pieces.append).dataset
    for variable in plain.variables:
        for other in (kept, watched):
            np.testing.assert_array_equal(plain[variable].values, other[variable].values)
    assert not [each for each in watched.variables if str(each).startswith("motion")]
    last = [piece for piece in pieces if piece.attempt == pieces[-1].attempt]
    assert len(last) > 3
    # A mean force is asked for or not; of a search the last attempt is the run.
    is_searched = scenario(name).pantographs[0].mean_force is not None
    assert {piece.searching for piece in pieces} == {is_searched}
    for attribute, variable in (
        ("up_m", "motion_up"),
        ("time_s", "motion_time"),
        ("first", "motion_first"),
        ("dropper_force_N", "motion_dropper_force"),
        ("contact_force_N", "contact_force"),
        ("contact_height_m", "contact_height"),
        ("mass_displacement_m", "mass_displacement"),
    ):
        joined = np.concatenate([getattr(piece, attribute) for piece in last])
        np.testing.assert_array_equal(joined, kept[variable].values)
    assert ("motion_across" in kept) == (last[0].across_m is not None)
    assert [wire.name for wire in last[0].layout.wires] == list(kept["motion_wire"].values)


def test_the_last_rows_of_a_run_that_fails_reach_a_viewer() -> None:
    """A light wire under a compliant contact, without numerical damping: motion that grows."""
    grows = arcless.load("praks-340").with_(
        **{
            "contact.law": "compliant",
            "solver.time_step": "1 ms",
            "solver.scheme": "trapezoidal",
            "line.contact_wire.mass": "0.89 kg/m",
            "line.dropper.clamp_mass_contact_wire": 0.0,
        }
    )
    pieces: list[MotionPiece] = []
    with pytest.raises(ContactError, match="the motion grew beyond all bounds") as failed:
        arcless.run(grows, watch=pieces.append)
    last = [piece for piece in pieces if piece.attempt == pieces[-1].attempt]
    time_s = np.concatenate([piece.time_s for piece in last])
    np.testing.assert_allclose(np.diff(time_s), motion.INTERVAL_S, atol=1e-12)
    assert failed.value.time_s is not None
    # The last row is less than an interval before the failure: no step is recorded after it.
    assert 0.0 <= failed.value.time_s - time_s[-1] < motion.INTERVAL_S
    for name in ("up_m", "contact_force_N", "mass_displacement_m", "dropper_force_N"):
        assert all(np.isfinite(getattr(piece, name)).all() for piece in last), name


def test_the_moved_wire_lies_on_the_strip() -> None:
    """The wire at the pantograph, between two nodes, is at the height of the contact."""
    found = arcless.run(moving(EXPLICIT)).dataset
    x, z = found["contact_wire_node_x"].values, found["contact_wire_node_z"].values
    first, count = found["motion_first"].values[:, 0], int(found["motion_count"].values[0])
    times = found["motion_time"].values
    rows = np.searchsorted(found["time"].values, times - 1e-9)
    off = []
    for row in range(20, len(times)):
        nodes = slice(first[row], first[row] + count)
        height = z[nodes] + found["motion_up"].values[row, :count]
        place = found["position"].values[rows[row], 0]
        off.append(
            np.interp(place, x[nodes], height) - found["contact_height"].values[rows[row], 0]
        )
    # The kink under the force is rounded between nodes: F ℓ/4T of 200 N, 0.45 m, 22 kN is 1 mm.
    assert np.abs(off).max() < 1e-3


def test_a_resumed_run_has_all_rows(tmp_path: Path) -> None:
    whole = arcless.run(moving(EXPLICIT, **{"pantographs.0.static_force": "120 N"}))
    first = arcless.run(whole.scenario, until="0.7 s")
    rest = arcless.resume(first)
    to_file = arcless.run(whole.scenario, to=tmp_path / "run.nc")
    (tmp_path / "again.nc").unlink(missing_ok=True)
    rest.save(tmp_path / "again.nc")
    for other in (rest, to_file, arcless.open(tmp_path / "again.nc")):
        for name in whole.dataset.variables:
            if str(name).startswith("motion"):
                found = other.dataset[name]
                np.testing.assert_array_equal(found.values, whole.dataset[name].values)
                assert found.dtype.itemsize == 4 or found.dtype.kind != "f" or name == "motion_time"


def test_window_and_interval() -> None:
    near = moving(EXPLICIT, **{"output.motion": {"interval": "20 ms", "around": "30 m"}})
    found = arcless.run(near).dataset
    np.testing.assert_allclose(np.diff(found["motion_time"].values), 0.02, atol=1e-12)
    x, first = found["contact_wire_node_x"].values, found["motion_first"].values[:, 0]
    count = int(found["motion_count"].values[0])
    place = np.interp(
        found["motion_time"].values, found["time"].values, found["position"].values[:, 0]
    )
    ends = x[first], x[np.minimum(first + count - 1, len(x) - 1)]
    inside = (place > 60) & (place < x[-1] - 60)
    # One element, 0.45 m, on each side; the travel of 1 ms before the step's end.
    assert np.all(np.abs(ends[0] - (place - 30))[inside] < 0.6)
    assert np.all(ends[1][inside] > place[inside] + 29)
    whole = moving(EXPLICIT, **{"output.motion": {"around": "whole line"}})
    assert int(arcless.run(whole).dataset["motion_count"].values[0]) == len(x)
    assert motion_bytes(near) < motion_bytes(whole)


def test_the_size_is_known_before() -> None:
    planned = moving("en50318-ac-simple-320-planar")
    found = arcless.run(planned).dataset
    names = (
        "motion_up",
        "motion_dropper_force",
        "motion_first",
        "motion_dropper_first",
        "motion_time",
    )
    assert motion_bytes(planned) == sum(found[name].values.nbytes for name in names)


def test_a_viewer_that_fails_ends_the_run() -> None:
    def fail(_piece: MotionPiece) -> None:
        raise OSError("nobody looks")

    with pytest.raises(OSError, match="nobody looks"):
        arcless.run(scenario(EXPLICIT), watch=fail)


@pytest.mark.parametrize(
    ("value", "words"),
    [({"interval": "2 s"}, "interval"), ({"around": "0 m"}, "around"), ("yes", "motion")],
)
def test_refused(value: Any, words: str) -> None:
    with pytest.raises(arcless.ModelError, match=words):
        scenario(EXPLICIT, **{"output.motion": value})


def test_wires_one_behind_the_other_share_columns() -> None:
    """Of three wires the first and the last do not overlap: a row has columns for two."""
    x = np.concatenate([np.arange(0.0, 100.0), np.arange(80.0, 180.0), np.arange(160.0, 260.0)])
    pieces = [[*range(100)], [], [*range(100, 200)], [*range(200, 300)]]
    one, two = motion._lanes("contact_wire", pieces, x, 30.0)
    assert (one.number, one.parts) == (1, (range(100), range(200, 300)))
    assert (two.number, two.parts) == (2, (range(100, 200),))
    np.testing.assert_array_equal(one.nodes, [*range(100), *range(200, 300)])
    assert one.count == two.count == 31
    layout = motion.MotionLayout(1, 10.0, (one, two), np.zeros(0, np.int64), 0, spatial=False)
    lanes = layout.variables["contact_wire_node_lane"]
    np.testing.assert_array_equal(lanes, np.repeat([1, 2, 1], 100))


def test_wires_side_by_side_share_nothing() -> None:
    x = np.concatenate([np.arange(0.0, 100.0), np.arange(0.0, 100.0)])
    lanes = motion._lanes("contact_wire", [[*range(100)], [*range(100, 200)]], x, 30.0)
    assert [lane.parts for lane in lanes] == [(range(100),), (range(100, 200),)]


def test_a_wire_alone_needs_no_lane() -> None:
    lanes = motion._lanes("contact_wire", [[*range(100)]], np.arange(100.0), np.inf)
    layout = motion.MotionLayout(1, 10.0, (*lanes,), np.zeros(0, np.int64), 0, spatial=False)
    assert set(layout.variables) == {"motion_count"}
    assert lanes[0].count == 100


def test_a_long_run_has_fewer_rows(monkeypatch: pytest.MonkeyPatch) -> None:
    planned = scenario("en50318-ac-simple-320-planar")
    found = arcless.statics(planned).equilibrium
    short = motion.layout_of(found, planned)
    monkeypatch.setattr(motion, "LONG", 10)
    assert motion.layout_of(found, planned).every == 2 * short.every
    # So it is where motion is recorded, and the size that is told is of that.
    asked = planned.with_(**{"output.motion": True})
    assert motion.layout_of(found, asked).every == 2 * short.every
    assert motion_bytes(planned, found) == motion_bytes(asked, found) == motion_bytes(asked)
    # An interval that is given wins.
    given = planned.with_(**{"output.motion": {"interval": "10 ms"}})
    assert motion.layout_of(found, given).every == short.every
    # Each row has the same; by one row more, where their number is odd.
    assert motion_bytes(given) == pytest.approx(2 * motion_bytes(asked), rel=1e-2)
