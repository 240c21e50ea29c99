"""Energy of explicit steps

With y the predictor of the steps, d = yₙ₊₁ − yₙ its last increment, K_E what is explicit and K_I what is
implicit, and M* the mass that the filter of the forces stands for, the balance of a step times Δz = h vₙ₊₁ is the
change of

    E = ½ (d/h)ᵀM*(d/h) + ½ yₙ₊₁ᵀK_E yₙ + ½ zᵀK_I z,      z = ½ (yₙ + yₙ₊₁)

(derived in docs/theory/energy.md). The program finds E from its tables of the wires, point by point, and
never from the forces that moved them. Here its terms are added up anew, for contacts that open, droppers
that slacken, friction, gusts, rigid contact, two tension lengths and stitch wires: what is left is
rounding. What opening and closing within a step takes or gives must fall with the step.

Lines: four uneven spans in space (`tests/support/small.py`), 1309 steps at 275 km/h, and shipped ones.
"""

from functools import cache
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.results import Result
from tests.support.small import small
from tests.verification.conservation.test_energy import remainder, terms

EXPLICIT: dict[str, Any] = {
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
SHIPPED = {
    "stitch wires, guests on the messenger wire": "re200-stitched",
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
