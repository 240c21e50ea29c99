"""Overlap: the wires together push back what the pantograph pushes, before, between and after

A pantograph whose base is pushed by a static force alone (no spring to the vehicle) rides through
an overlap of two wires:

* momentum: `Σ m (v(T) − v(0)) = ∫ (F₀ − F) dt` over the whole ride
* at each instant the forces of the wires add up to the force on the head
* no gap: at 60 km/h nothing may bounce off, and out of reach of a wire that has no force

Newton's law; no reference values are needed. Asked as lines of spans of 60 m with overlaps of
three, four and five spans, planar and with the wires 0.2 m apart sideways; steps of 2 ms.
"""

from functools import partial
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.model import load
from arcless.results import Result
from tests.support.evidence import Evidence
from tests.support.faults import Fault
from tests.support.line_types import compound_data, scenario_data, stitched_data
from tests.support.overlaps import overlap_data
from tests.support.python_faults import wrong
from tests.support.run_faults import pantograph_scaled

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


def test_momentum(evidence: Evidence) -> None:
    data = ride(overlap_data(), 190.0, 470.0, solver__dimension="spatial").dataset
    time, total = data["time"].values, data["contact_force"].values[:, 0]
    height = data["mass_displacement"].values[:, 0]
    masses = np.array([12.0, 8.0])
    ends = slice(3), slice(-3, None)
    speeds = [np.gradient(height[part], time[part], axis=0)[1] for part in ends]
    pushed = FORCE * (time[-1] - time[0]) - np.trapezoid(total, time)
    assert time[-1] > 16.0
    evidence.close(
        "momentum that the force brings in 17 s, of 1500 N s pushed",
        pushed,
        float(masses @ (speeds[1] - speeds[0])),
        unit="N s",
        absolute=0.05,
        reason="speeds are differences of positions 4 ms apart: 20 kg · 2 ms · 1 m/s² at most",
    )


def wires_of(found: Result) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Position, total force, and the force of each wire in order."""
    data = found.dataset
    assert list(data["contact"].values) == ["P1 strip 1 wire 1", "P1 strip 1 wire 2"]
    x, total = data["position"].values[:, 0], data["contact_force"].values[:, 0]
    return x, total, data["wire_contact_force"].values


SHORT = [(3, "spatial"), (4, "planar")]
MORE = [(3, "planar"), (4, "spatial"), (5, "planar"), (5, "spatial")]


@pytest.mark.parametrize(
    ("shared", "dimension"),
    [*SHORT, *(pytest.param(*case, marks=pytest.mark.evidence) for case in MORE)],
)
def test_handover(evidence: Evidence, shared: int, dimension: str) -> None:
    aside = 0.0 if dimension == "planar" else 0.2
    line = overlap_data(shared, ends=(4 + shared,), spans=8 + shared, overlap__separation=aside)
    first, last = 4 * 60.0, (4 + shared) * 60.0
    found = ride(line, first - 50.0, last + 50.0, solver__dimension=dimension)
    x, total, wires = wires_of(found)
    case = f"{shared} spans, {dimension}"
    evidence.below(
        f"largest difference of the sum over the wires to the total, {case}",
        float(abs(wires.sum(axis=1) - total).max()),
        1e-12 * FORCE,
        unit="N",
        reason="rounding of one sum",
    )
    evidence.below(
        f"lift-off, and force of a wire out of reach, {case}",
        float(max(data_max(found), wires[x < first, 1].max(), wires[x > last, 0].max())),
        0.0,
        unit="m or N",
        reason="there is no gap at any step and no force without wire: exactly nothing",
    )
    both = (wires > 0.0).all(axis=1)
    assert both.any()
    assert total.min() > 0.5 * FORCE
    evidence.below(
        f"where both are touched, farthest from the middle, {case}",
        float(abs(x[both] - 0.5 * (first + last)).max()),
        0.5 * 60.0 * shared - 60.0,
        unit="m",
        reason="not in the spans where a wire rises to its end",
    )


def data_max(found: Result) -> float:
    return float(found.dataset["contact_gap"].values.max())


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


@pytest.mark.evidence
@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_of_line(evidence: Evidence, kind: str) -> None:
    length = KINDS[kind]["span_types"]["span"]["length"]
    found = ride(KINDS[kind], 3.5 * length, 7.5 * length)
    total = found.dataset["contact_force"].values[:, 0]
    wires = found.dataset["wire_contact_force"].values
    # Twice as many wires in an overlap as beside it, and all of them take their turn.
    one_side = 2 if kind == "twin" else 1
    assert wires.shape[1] == 2 * one_side
    assert (wires > 0.0).any(axis=0).all()
    assert not wires[0, one_side:].any() and not wires[-1, :one_side].any()
    evidence.below(f"lift-off, {kind}", data_max(found), 0.0, unit="m", reason="no gap at any step")
    evidence.below(
        f"largest difference of the sum over the wires to the total, {kind}",
        float(abs(wires.sum(axis=1) - total).max()),
        1e-12 * FORCE,
        unit="N",
        reason="rounding of one sum",
    )


def weaker(found: Result, *, summed: bool) -> Result:
    """Take a thousandth from the recorded force of the second wire, and from the sum of both."""
    shares = found.dataset["wire_contact_force"]
    lost = (1.0 - 0.999) * shares[:, 1]
    shares[:, 1] = 0.999 * shares[:, 1]
    if summed:
        found.dataset["contact_force"][:, 0] -= lost
    return found


FAULTS = [
    Fault("force of the second wire 0.1 % too small",
          wrong(__name__, "ride", partial(weaker, summed=True)), test_momentum),
    Fault("force of the second wire 0.1 % too small, sum as it was",
          wrong(__name__, "ride", partial(weaker, summed=False)), test_handover, shared=3,
          dimension="spatial"),
    Fault("thirty times the mass", pantograph_scaled("mass", 30.0), test_handover, shared=3,
          dimension="spatial"),
]  # fmt: skip
