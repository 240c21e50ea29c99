"""Parts of a run are the whole run

A run that stops and goes on from what it saved must be the run that never stopped, bit for bit:
every series, every extreme, every count, the ledger, the static force that was searched for.
The state that is saved is complete if and only if that holds, whatever the run is made of.

Each case below is run once as a whole and once in three parts, `run(scenario, until=…)` and
`arcless.resume`. Between the parts there is nothing but the file: the line at rest is found
again, the matrices are factorised again. The first stop is after some steps, the second in the
middle of the events: droppers slack, contact lost, delayed forces of a controller on their way.
All numbers of both results are compared, and their attributes but for times of day and wall
times.

Lines: four uneven spans in space (`tests/support/small.py`), of point masses once with updated
kinematics and once with explicit steps, and two shipped scenarios cut short.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

import arcless
from arcless.errors import ContactError
from arcless.model import Scenario
from arcless.simulate.runs import checkpoint
from tests.support.explicit import BY_MATRIX, EXPLICIT
from tests.support.faults import Fault
from tests.support.parts import in_parts, unlike
from tests.support.python_faults import wrong
from tests.support.small import small

STOPS = ("51 m", "1.02 s")
CHANGES: dict[str, dict[str, Any]] = {
    "default": {},
    "trapezoidal rule with ledger and friction": {
        "solver.scheme": {"name": "trapezoidal"},
        "contact.friction_coefficient": 0.2,
    },
    "rigid contact, loss of contact": {
        "contact.law": "rigid",
        "solver.scheme": {"name": "generalised-alpha", "spectral_radius": 0.0},
        "pantographs.0.static_force": 60.0,
    },
    "PID, sampled and late": {
        "pantographs.0.controller": {
            "sample_time": "5 ms",
            "delay": "12 ms",
            "rate_limit": "900 N/s",
            "pid": {"target": 150.0, "proportional": 0.4, "integral": 2.0, "filter": "10 ms"},
        }
    },
    "point masses, updated kinematics, backward differences": {
        "solver.wire_model": "lumped",
        "solver.kinematics": "updated",
        "solver.scheme": {"name": "backward-difference"},
        "solver.time_step": "4 ms",
    },
    "point masses, explicit steps": EXPLICIT,
}


def overlap(**changes: Any) -> Scenario:
    return arcless.load("ac-simple-overlap-275").with_(
        **{
            **changes,
            "pantographs.0.mean_force": None,
            "pantographs.0.static_force": 150.0,
            "travel": {"start": 470.0, "end": 620.0},
            "analysis": {"from": 480.0, "to": 610.0},
        }
    )


def two_pantographs(**changes: Any) -> Scenario:
    shorter = {"travel.end": "500 m", "analysis": {"from": "260 m", "to": "298 m"}}
    return arcless.load("ac-simple-320-two-pantographs").with_(**shorter, **changes)


LONG = {
    "two wires in an overlap": overlap(),
    "two wires in an overlap, cubic elements": overlap(**BY_MATRIX),
    "two pantographs, mean force searched for": two_pantographs(),
    "two pantographs, mean force searched for, cubic elements": two_pantographs(**BY_MATRIX),
}


def compare(evidence: Any, case: str, scenario: Scenario, stops: Any, folder: Path) -> None:
    whole = arcless.run(scenario)
    compared, differing = unlike(whole, in_parts(scenario, folder, *stops))
    reason = "the state is complete, and nothing else is carried over"
    evidence.same(case, compared=compared, differing=differing, reason=reason)


@pytest.mark.parametrize("case", CHANGES)
def test_parts(evidence: Any, tmp_path: Path, case: str) -> None:
    compare(evidence, case, small(**CHANGES[case]), STOPS, tmp_path)


@pytest.mark.evidence
@pytest.mark.parametrize("case", LONG)
def test_long_parts(evidence: Any, tmp_path: Path, case: str) -> None:
    compare(evidence, case, LONG[case], ("0.3 s", "1.2 s"), tmp_path)


@contextmanager
def lost(name: str) -> Iterator[None]:
    """Lose a part of the state between two parts of a run."""
    hits = []

    def forgetful(saved: Any) -> Any:
        hits.append(bool(saved.numbers[name].any()))
        saved.numbers[name][:] = 0.0
        return saved

    with wrong(checkpoint, "read", forgetful):
        yield
    if not any(hits):
        raise RuntimeError(f"{name}: there was nothing to lose")


def parts(evidence: Any, tmp_path: Path, case: str) -> None:
    """Check the parts; an energy balance that does not close notices as well."""
    try:
        test_parts(evidence, tmp_path, case)
    except ContactError as error:
        raise AssertionError(str(error)) from error


LEDGER = "trapezoidal rule with ledger and friction"
CONTROLLED = "PID, sampled and late"
POINT_MASSES = "point masses, explicit steps"
LOST = {
    "contact_force": LEDGER,
    "controller_0": CONTROLLED,
    "grid_across": POINT_MASSES,
    "line_acceleration": "default",
}
LOST_TOO = {
    "contact_weights": LEDGER,
    "energy": LEDGER,
    "energy_sums": LEDGER,
    "grid_along": POINT_MASSES,
    "line_displacement": "default",
    "line_velocity": "default",
    "link_elongation": "default",
    "link_max": "default",
    "pivot_counts": "default",
    "rider_0_preload_ground_actuator": "default",
    "rider_0_start": "default",
    "rider_0_velocity": "default",
    "rider_0_waiting": CONTROLLED,
}
FAULTS = [
    Fault(f"`{name}` lost", lost(name), parts, case=case, slow=name in LOST_TOO)
    for name, case in (LOST | LOST_TOO).items()
]  # fmt: skip
