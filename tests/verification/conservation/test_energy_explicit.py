"""Energy of explicit steps

With y the predictor of the steps, d = yₙ₊₁ − yₙ its last increment, K_E what is explicit and K_I
what is implicit, and M* the mass that the filter of the forces stands for, the balance of a step
times Δz = h vₙ₊₁ is the change of

    E = ½ (d/h)ᵀM*(d/h) + ½ yₙ₊₁ᵀK_E yₙ + ½ zᵀK_I z,      z = ½ (yₙ + yₙ₊₁)

(derived in docs/theory/energy.md). The program finds E from its tables of the wires, point by
point, and never from the forces that moved them. Here its terms are added up anew, for contacts
that open, droppers that slacken, friction, gusts, rigid contact, two tension lengths and stitch
wires: what is left is rounding. What opening and closing within a step takes or gives must fall
with the step.

Lines: four uneven spans in space (`tests/support/small.py`), 1309 steps at 275 km/h, and shipped
ones.
"""

from functools import cache
from typing import Any
from unittest.mock import patch

import numpy as np
import pytest

import arcless
from arcless.results import Result
from tests.support.faults import Fault, forgotten
from tests.support.python_faults import not_booked
from tests.support.small import small
from tests.verification.conservation.test_energy import remainder, terms

EXPLICIT: dict[str, Any] = {
    "solver.residual_flexibility": "auto",
    "solver.scheme": "central-difference",
    "solver.contact_wire_element": "auto",
    "solver.messenger_wire_element": "auto",
}
CASES: dict[str, dict[str, Any]] = {
    "compliant contact": {},
    "loss of contact": {"pantographs.0.static_force": 60.0},
    "rigid contact": {"contact.law": "rigid"},
    "friction along the wire": {"contact.friction_coefficient": 0.3},
    "gusts": {
        "line.contact_wire.diameter": "12 mm",
        "line.messenger_wire.diameter": "14 mm",
        "as_built.wind.speed": 12.0,
        "as_built.gusts": {"time": [0.0, 0.4, 0.8, 2.0], "speed": [12.0, 19.0, 7.0, 15.0]},
    },
    "controlled force": {
        "pantographs.0.controller": {
            "sample_time": "5 ms",
            "pid": {"target": 150.0, "proportional": 0.4, "integral": 2.0},
        }
    },
}
FORCE = 150.0  # N, static
UNTIL = "0.6 s"
STEPS = ("1 ms", "0.5 ms", "0.25 ms", "0.125 ms")
SHIPPED = {
    "stitch wires, guests on the messenger wire": "china-stitched-350",
    "two tension lengths": "ac-simple-overlap-275",
}


@cache
def ran(case: str) -> Result:
    return arcless.run(small(**EXPLICIT | CASES[case] | {"output.energy": "always"}))


@pytest.mark.parametrize("case", CASES)
def test_the_ledger_closes(evidence: Any, case: str) -> None:
    left, turnover = remainder(ran(case))
    evidence.below(
        f"explicit steps, {case}: what the terms leave, over the energy turned over",
        left / turnover,
        2e-12,
        unit="1",
        reason="1309 steps with rounding of 2e-16 of the energy stored each; elastic energies are"
        " differences of larger ones: some times that",
    )


@cache
def shipped(name: str) -> Result:
    scenario = arcless.load(name)
    count = range(len(scenario.pantographs))
    forces = {f"pantographs.{i}.mean_force": None for i in count}
    forces |= {f"pantographs.{i}.static_force": FORCE for i in count}
    every = {"output.energy": "always", "output.line_every": 1}
    changes = EXPLICIT | {"solver.time_step": "1 ms"} | forces | every
    return arcless.run(scenario.with_(**changes), until=UNTIL)


@pytest.mark.parametrize("case", SHIPPED)
def test_wires_at_points_of_others(evidence: Any, case: str) -> None:
    left, turnover = remainder(shipped(SHIPPED[case]))
    evidence.below(
        f"explicit steps, {case}: what the terms leave, over the energy turned over",
        left / turnover,
        2e-12,
        unit="1",
        reason="rounding, as above",
    )


@cache
def switched(step: str) -> float:
    """Return what opening and closing have taken or given, over the work of the traction."""
    changes = {"solver.time_step": step, "output.energy": "always"}
    found = terms(arcless.run(small(**EXPLICIT | changes)))
    return float(np.max(np.abs(found["switching"])) / found["work_traction"][-1])


def test_switching_falls_with_the_step(evidence: Any) -> None:
    shares = [switched(step) for step in STEPS]
    evidence.below(
        "explicit steps: switching of contacts and droppers at 1 ms, over the work of the traction",
        shares[0],
        0.01,
        unit="1",
        reason="the program ends a run at 0.05 of the energy turned over; droppers that slacken"
        " within a step leave a share of some h², some thousandths",
    )
    evidence.order(
        "explicit steps: switching of contacts and droppers as the step shrinks",
        [float(step.removesuffix(" ms")) for step in STEPS],
        shares,
        1.5,
        tolerance=0.5,
        unit="step",
        reason="what opens is off by a part of a step and h² of the force there: second order for"
        " each, but few of them count, and where in its step each comes is chance",
    )


def lasting(step: str, sound: Any = switched) -> float:
    """Return one answer for every step, apart from 1 % per letter: no two answers are equal."""
    return sound("1 ms") * (1.0 + 0.01 * len(step))


AFRESH = forgotten(ran, shipped, switched)
FAULTS = [
    *(Fault(f"`{term}` not booked", [AFRESH, not_booked(term)], test_the_ledger_closes, case=case)
      for term, case in (
          ("energy_contact", "rigid contact"),
          ("energy_dissipated_line", "compliant contact"),
          ("energy_dissipated_supports", "compliant contact"),
          ("energy_switching", "loss of contact"),
          ("energy_work_control", "controlled force"),
          ("energy_work_friction", "friction along the wire"),
          ("energy_work_wind", "gusts"),
      )),
    *(Fault(f"elastic energy off by 1e-6, {case}", [AFRESH, not_booked("energy_elastic", 1e-6)],
            test_wires_at_points_of_others, case=case)
      for case in SHIPPED),
    Fault("switching that does not fall", [AFRESH, patch.multiple(__name__, switched=lasting)],
          test_switching_falls_with_the_step),
]  # fmt: skip
