"""Compound line below a rigid messenger wire: a string on equal springs

Contact wire (tension T) on hangers a apart, each on the auxiliary wire's string (T_a) between two
rigid droppers, c and a − c away: stiffness `T_a (1/c + 1/(a − c))`, in series with the hanger gives
k. A string on springs k, a apart, under a unit force at a spring rises there by

* `e = 1/√(k² + 4kT/a)`, at the next spring by `e₁ = μ e`, `μ = 1 + q − √(q² + 2q)`, `q = ka/2T`
* in the middle between two springs `a/4T + (e + e₁)/2`

Derived here (difference equation of the string). Asked as six spans of 50 m with next to no weight,
a messenger wire of 1e8 N and droppers of 1e9 N/m, at 127.5 and 132.5 m, by chains and by cubic
elements.
"""

from math import sqrt

import numpy as np
import pytest

import arcless
from arcless.model import load
from tests.support.evidence import Evidence
from tests.support.faults import Fault, scaled
from tests.support.line_types import compound_data, scenario_data

RIGID = {"mass": 0.1, "axial_stiffness": 1e11, "bending_stiffness": 0.0, "tension": 1e8}
WIRES = {
    "chains": {"solver__wire_model": "lumped"},
    "cubic elements": {"solver__scheme": "generalised-alpha"},
}


@pytest.mark.parametrize("wires", WIRES)
def test_elasticity(evidence: Evidence, wires: str) -> None:
    line = compound_data(
        messenger_wire=RIGID,
        contact_wire__bending_stiffness=0.0,
        auxiliary_wire__bending_stiffness=0.0,
        dropper={"stiffness": 1e9},
        hanger={"stiffness": 2e4},
        support__vertical_stiffness=1e10,
        steady_arm={"kind": "none"},
        span_types__span__hangers={"positions": [7.5, 17.5, 27.5, 37.5, 47.5]},
    )
    settings = {"solver__gravity": 0.1, "solver__contact_wire_element": 0.5}
    data = scenario_data(line, **settings, **WIRES[wires])
    found = arcless.statics(load(data)).equilibrium.elasticity(np.array([127.5, 132.5]))

    a, c, string, tension = 10.0, 2.5, 14e3, 15e3
    auxiliary = string * (1 / c + 1 / (a - c))
    k = 1 / (1 / 2e4 + 1 / auxiliary)
    q = 0.5 * k * a / tension
    here = 1 / sqrt(k * k + 4 * k * tension / a)
    following = here * (1 + q - sqrt(q * q + 2 * q))
    reason = "the messenger wire gives by L/4T = 1e-7 m/N, 0.1 % of the whole; the rest is sag"
    for what, value, expected in (
        ("at a hanger", found[0], here),
        ("between two hangers", found[1], a / (4 * tension) + (here + following) / 2),
    ):
        evidence.close(
            f"elasticity {what}, {wires}", value, expected, unit="m/N", relative=2e-3,
            reason=reason,
        )  # fmt: skip


FAULTS = [
    Fault("hangers 1 % softer", scaled("links", "stiffness", 0.99), test_elasticity,
          wires="chains"),
    Fault("all tensions 1 % too low", scaled("segments", "tension", 0.99), test_elasticity,
          wires="chains"),
]  # fmt: skip
