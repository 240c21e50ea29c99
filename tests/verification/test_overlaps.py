"""Overlaps in motion: one wire hands the pantograph over to the next."""

from typing import Any

import numpy as np
import pytest

import arcless
from arcless.model import load
from arcless.results import Result
from tests.support.line_types import compound_data, scenario_data, stitched_data
from tests.support.overlaps import overlap_data

# A pantograph without arm: its base is pushed by the static force alone.
LOOSE = {
    "name": "loose",
    "masses": [
        {"mass": 12.0, "stiffness": 0.0, "damping": 0.0},
        {"mass": 8.0, "stiffness": 7000.0, "damping": 60.0},
    ],
}
FORCE = 90.0


def ride(line: dict[str, Any], begin: float, end: float, **changes: Any) -> Result:
    data = scenario_data(
        line,
        pantographs=[{"model": LOOSE, "static_force": FORCE}],
        travel={"start": begin, "end": end},
        analysis={"from": begin, "to": end},
        **{"speed": "60 km/h", "solver__time_step": "2 ms", **changes},
    )
    return arcless.run(load(data))


def of_wires(found: Result) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Position, total force, and the force of each wire in order."""
    data = found.dataset
    names = [str(name) for name in data["contact"].values]
    assert names == ["P1 strip 1 wire 1", "P1 strip 1 wire 2"]
    x, total = data["position"].values[:, 0], data["contact_force"].values[:, 0]
    return x, total, data["wire_contact_force"].values


@pytest.mark.parametrize("dimension", ["planar", "spatial"])
@pytest.mark.parametrize("shared", [3, 4, 5])
def test_the_pantograph_is_handed_over_without_a_gap(shared: int, dimension: str) -> None:
    aside = 0.0 if dimension == "planar" else 0.2
    line = overlap_data(shared, ends=(4 + shared,), spans=8 + shared, overlap__separation=aside)
    first, last = 4 * 60.0, (4 + shared) * 60.0
    found = ride(line, first - 50.0, last + 50.0, solver__dimension=dimension)
    x, total, wires = of_wires(found)
    data = found.dataset
    assert data["contact_gap"].values.max() == 0.0
    # Far from lost: at 60 km/h the force hardly moves about the static one.
    assert total.min() > 0.5 * FORCE
    np.testing.assert_allclose(wires.sum(axis=1), total, atol=1e-9 * FORCE)
    # Out of reach of the other wire the pantograph is on one of them alone.
    assert not wires[x < first, 1].any()
    assert not wires[x > last, 0].any()
    assert np.all(wires[x < first, 0] > 0.0)
    # In the middle both are touched, and there the force changes over.
    middle = 0.5 * (first + last)
    both = (wires > 0.0).all(axis=1)
    assert both.any()
    assert np.abs(x[both] - middle).max() < 0.5 * 60.0 * shared - 60.0


def test_the_wires_together_push_back_what_the_pantograph_pushes() -> None:
    found = ride(overlap_data(), 190.0, 470.0, solver__dimension="spatial")
    data = found.dataset
    _, total, _ = of_wires(found)
    time = data["time"].values
    height = data["mass_displacement"].values[:, 0]
    masses = np.array([12.0, 8.0])
    # Momentum: Σ m (v(T) − v(0)) = ∫ (F₀ − F) dt; the speeds from positions 2 ms apart.
    speeds = [
        np.gradient(height[part], time[part], axis=0)[1] for part in (slice(3), slice(-3, None))
    ]
    change = float(masses @ (speeds[1] - speeds[0]))
    pushed = FORCE * (time[-1] - time[0]) - np.trapezoid(total, time)
    # 17 s of 90 N: 1 N s is less than one per mille of what was pushed.
    assert pushed == pytest.approx(change, abs=0.2)
    assert time[-1] > 16.0


def shifted(spans: int) -> Result:
    """Ride over the second overlap of a line whose first tension length is longer or shorter."""
    line = overlap_data(
        3, ends=(6 + spans, 13 + spans), spans=19 + spans, geometry__stagger_contact_wire=[0.1]
    )
    begin = 60.0 * (8 + spans)
    return ride(line, begin, begin + 400.0, speed="200 km/h", output__energy="never")


def test_an_overlap_moved_by_a_span_moves_the_result_by_a_span() -> None:
    # The second and third tension length are moved as a whole, anchors and travel with them: all
    # that differs is where zero is, so rounding, which 90 s of steps do not let grow.
    one, other = shifted(0).dataset, shifted(1).dataset
    np.testing.assert_allclose(other["position"], one["position"] + 60.0, rtol=1e-12)
    for name in ("contact_force", "wire_contact_force"):
        np.testing.assert_allclose(other[name], one[name], atol=1e-5 * FORCE)
    force = one["wire_contact_force"].values
    assert (force > 0.0).any(axis=0).all()


ARMS = {"kind": "arm", "length": 1.0, "slope": 0.1}
KINDS = {
    "twin": overlap_data(twin_contact_wires={"separation": 0.04}),
    "stitched": overlap_data(stitch_wire=stitched_data()["stitch_wire"]),
    "arms": overlap_data(steady_arm=ARMS, geometry__stagger_contact_wire=[0.2, -0.2]),
    "compound": overlap_data(
        **{name: compound_data()[name] for name in ("auxiliary_wire", "hanger", "span_types")},
        overlap__raise=[0.3, 0.04],
    ),
}


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_of_line_hands_over(kind: str) -> None:
    length = KINDS[kind]["span_types"]["span"]["length"]
    data = ride(KINDS[kind], 3.5 * length, 7.5 * length).dataset
    total, wires = data["contact_force"].values[:, 0], data["wire_contact_force"].values
    assert total.min() > 0.0
    assert data["contact_gap"].values.max() == 0.0
    # Twice as many wires in an overlap as beside it, and all of them take their turn.
    side_by_side = 2 if kind == "twin" else 1
    assert wires.shape[1] == 2 * side_by_side
    assert (wires > 0.0).any(axis=0).all()
    assert not wires[0, side_by_side:].any()
    assert not wires[-1, :side_by_side].any()
    np.testing.assert_allclose(wires.sum(axis=1), total, atol=1e-9 * FORCE)
