"""Element length, cubic elements

Elements of degree p = 3 with continuous slopes. Theory, for a problem with derivatives of order m
in its energy (Strang & Fix, An Analysis of the Finite Element Method, 1973, second hand; what is
said of nodes and point forces is derived here):

    frequencies          h^(2(p + 1 − m)): 6 for a string (m = 1), 4 for a beam (m = 2)
    smooth static shape  h^(p + 1): 4. Nodes of a string are no better than the rest: what a node
                         feels is a kink there, which continuous slopes cannot draw
    force on a node      string: h, for the same reason. Beam under tension: 4, its kink is in the
                         third derivative

The first order below a point force is what the contact wire shows with elements much longer than
√(EI/T) = 0.09 m: with n elements in a span the wire is too stiff by 24 %/n, that is 0.6 % of a
span of 55 m in elements of 1.45 m.

References: pinned wire `ω² = (T k² + EI k⁴)/μ`, k = 3π/L; elasticity at mid-span `L/4T −
tanh(λL/2)/(2 T λ)`, λ² = T/EI (elementary); the exact curve of a heavy wire that stretches, see
Sag, with the elements' law `N = EA ½ (s² − 1) s`. One wire of 60 m, EA = 10 MN, 20 kN; for the sag
EA = 0.1 MN, 10 kN, 196 N/m, 8 m deep, in space with 60 N/m of wind. Meshes made by hand, of equal
elements and of elements three times longer at one end.
"""

from typing import Any

import pytest

from tests.support import spans
from tests.support.faults import Fault, gravity, scaled

MODELS = ("cubic, planar", "cubic, spatial")
DIMENSIONS = pytest.mark.parametrize("model", MODELS)
COUNTS = (12, 24, 48)
SIZES = [spans.LENGTH / count for count in COUNTS]
NEXT = "terms of the next order on the coarsest of these meshes"


@DIMENSIONS
def test_frequencies(evidence: Any, model: str) -> None:
    evidence.order(
        f"{model}: third frequency of a string",
        SIZES,
        [spans.frequency_error(model, n, bending=0.0, taut=True) for n in COUNTS],
        6.0,
        tolerance=0.2,
        reason=NEXT,
        unit="element length",
    )
    evidence.order(
        f"{model}: third frequency of a beam",
        SIZES,
        [spans.frequency_error(model, n, bending=1e5, taut=False) for n in COUNTS],
        4.0,
        tolerance=0.1,
        reason=NEXT,
        unit="element length",
    )

    evidence.order(
        f"{model}: third frequency of a beam, pieces from 3 to 1",
        SIZES,
        [spans.frequency_error(model, n, bending=1e5, taut=False, grading=0.5) for n in COUNTS],
        4.0,
        tolerance=0.1,
        reason=NEXT,
        unit="mean element length",
    )


@DIMENSIONS
def test_statics(evidence: Any, model: str) -> None:
    evidence.order(
        f"{model}: sag of a heavy wire",
        SIZES,
        [spans.sag_error(model, n) for n in COUNTS],
        4.0,
        tolerance=0.2,
        reason=NEXT,
        unit="element length",
    )
    evidence.order(
        f"{model}: elasticity of a string",
        SIZES,
        [spans.elasticity_error(model, n, bending=0.0) for n in COUNTS],
        1.0,
        tolerance=1e-4,
        reason="the kink is local, and all else exact: rounding",
        unit="element length",
    )
    finer = (24, 48, 96)
    evidence.order(
        f"{model}: elasticity of a stiff wire, √(EI/T) = 3 m",
        [spans.LENGTH / n for n in finer],
        [spans.elasticity_error(model, n, bending=2e5) for n in finer],
        4.0,
        tolerance=0.2,
        reason=NEXT,
        unit="element length",
    )


FAULTS = [
    # An error that refinement does not take away: the slope is that of a constant.
    *(Fault(f"{model}: mass 0.01 % high", scaled("wires", "mass", 1.0001), test_frequencies,
            model=model)
      for model in MODELS),
    *(Fault(f"{model}: {what}", broken, test_statics, model=model)
      for model in MODELS
      for what, broken in (
          ("EA 1 % high", scaled("wires", "EA", 1.01)),
          ("gravity 0.1 % high", gravity(1.001)),
      )),
    Fault("wind from the other side", scaled("wire_loads", "across", -1.0), test_statics,
          model="cubic, spatial"),
    *(Fault("EI 1 % high", scaled("wires", "EI", 1.01), check, model="cubic, planar")
      for check in (test_frequencies, test_statics)),
]  # fmt: skip
