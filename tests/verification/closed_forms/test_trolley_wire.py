"""Trolley wire: sag and elasticity of a wire with bending stiffness on its supports

Spans L of a wire (tension T, bending stiffness EI, weight w) that is held at its height at every
support. With ℓ = √(EI/T) much shorter than L, and far from the ends of the line:

* sag: `z = w/T (L²/8 − L ℓ/2 + ℓ²)`. The slope `wL/2T` of a string begins at a support as
  `1 − exp(−s/ℓ)`, which takes `wLℓ/2T` from the sag but for `wℓ²/T`.
* force on a support: `w L`.
* elasticity in the middle of a span: `e = (L − 3ℓ)/4T + 1/2k`; bending takes `ℓ/2T` at the force
  and `ℓ/8T` at either side of both supports, which give `1/2k` together.
* elasticity at a support of stiffness k: `e = 1/(k + 2T/L)`.

The weight is that of the stretched wire, `w = μ g (1 − T/EA)`. Derived here from the beam under
tension, `EI z⁗ − T z″ = −w`.

Asked as a line: ten spans of 40 m, 12 kN, 1.1 kg/m, EI 130 N m² (ℓ = 0.10 m), k = 5e5 N/m; elements
of 0.5 m, and two of 0.2 m at each support.
"""

from math import sqrt

import pytest

import arcless
from arcless.model import load
from arcless.simulate import StaticsResult
from tests.support.evidence import Evidence
from tests.support.faults import Fault, gravity, scaled
from tests.support.line_types import scenario_data
from tests.support.python_faults import tension
from tests.support.simple_lines import trolley_data

FINE = {"solver__contact_wire_element": 0.5, "solver__messenger_wire_element": 0.5}
SPAN, TENSION, BENDING, STIFFNESS = 40.0, 12e3, 130.0, 5e5
WEIGHT = 1.1 * 9.81 * (1 - TENSION / 14e6)
BENT = sqrt(BENDING / TENSION)


def at_rest(model: str = "hermite") -> StaticsResult:
    plain = {"solver__scheme": "generalised-alpha", "solver__residual_flexibility": False}
    data = scenario_data(trolley_data(), **FINE, **plain, solver__wire_model=model)
    return arcless.statics(load(data))


@pytest.mark.parametrize("model", ["hermite", "lumped"])
def test_sag(evidence: Evidence, model: str) -> None:
    found = at_rest(model).equilibrium
    points = found.positions[found.mesh.contact_nodes]
    middle = points[abs(points[:, 0] - 5.5 * SPAN) <= SPAN / 2]
    assert len(middle) > 50
    reasons = {
        "hermite": "elements of 0.2 m at a support where the wire bends over 0.10 m: 0.03 mm found "
        "by halving them",
        "lumped": "segments bend within their length: half a segment, 0.1 m, takes the place of ℓ, "
        "so w L/2T · 0.1 m · few per cent",
    }
    evidence.close(
        f"sag, {model}",
        5.5 - float(middle[:, 2].min()),
        WEIGHT / TENSION * (SPAN**2 / 8 - SPAN * BENT / 2 + BENT**2),
        unit="m",
        absolute={"hermite": 5e-5, "lumped": 6e-4}[model],
        reason=reasons[model],
    )


def test_supports(evidence: Evidence) -> None:
    found = at_rest()
    inner = [support["contact_support_force_N"] for support in found.supports[2:-2]]
    evidence.close(
        "force of an inner support, the one that is farthest off",
        max(inner, key=lambda force: abs(force - WEIGHT * SPAN)),
        WEIGHT * SPAN,
        unit="N",
        relative=5e-4,
        reason="the wire is longer than the track by half its slopes squared, 1e-4 at most",
    )


def test_elasticity(evidence: Evidence) -> None:
    e = at_rest().elasticity_m_per_N
    evidence.close(
        "elasticity in the middle of a span",
        e[len(e) // 2],
        (SPAN - 3 * BENT) / (4 * TENSION) + 1 / (2 * STIFFNESS),
        unit="m/N",
        relative=2e-3,
        reason="elements of 0.5 m where the kink below the force is 0.1 m long: ℓ/2T = 0.5 %",
    )
    evidence.close(
        "elasticity at a support",
        e[0],
        1 / (STIFFNESS + 2 * TENSION / SPAN),
        unit="m/N",
        relative=5e-5,
        reason="the wire gives 600 N/m beside 5e5 N/m of the support; bending adds ℓ/L of that, "
        "3e-6; ten times as much",
    )


FAULTS = [
    Fault("gravity 0.1 % too large", gravity(1.001), test_supports),
    *(Fault(f"tension 1 % too high, {model}", tension(1.01), test_sag, model=model)
      for model in ("hermite", "lumped")),
    Fault("no bending stiffness", scaled("wires", "EI", 0.0), test_elasticity),
    Fault("supports 1 % softer", scaled("springs", "stiffness", 0.99), test_elasticity),
]  # fmt: skip
