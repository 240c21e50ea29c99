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

from functools import partial
from typing import Any

import pytest

from tests.support import spans
from tests.support.faults import Fault, gravity, scaled

MODELS = ("cubic, planar", "cubic, spatial")
DIMENSIONS = pytest.mark.parametrize("model", MODELS)
COUNTS = (12, 24, 48)
PIECE = "element length"


@DIMENSIONS
def test_frequencies(evidence: Any, model: str) -> None:
    string, beam = {"bending": 0.0, "taut": True}, {"bending": 1e5, "taut": False}
    show = partial(spans.show_order, evidence, model, COUNTS, spans.frequency_error)
    show("third frequency of a string", order=6.0, tolerance=0.2, unit=PIECE, **string)
    show("third frequency of a beam", order=4.0, tolerance=0.1, unit=PIECE, **beam)
    what = "third frequency of a beam, pieces from 3 to 1"
    show(what, order=4.0, tolerance=0.1, unit=f"mean {PIECE}", grading=0.5, **beam)


@DIMENSIONS
def test_statics(evidence: Any, model: str) -> None:
    show = partial(spans.show_order, evidence, model, unit=PIECE)
    show(COUNTS, spans.sag_error, "sag of a heavy wire", order=4.0, tolerance=0.2)
    kink = "the kink is local, and all else exact: rounding"
    error, what = spans.elasticity_error, "elasticity of a string"
    show(COUNTS, error, what, order=1.0, tolerance=1e-4, reason=kink, bending=0.0)
    what = "elasticity of a stiff wire, √(EI/T) = 3 m"
    show((24, 48, 96), error, what, order=4.0, tolerance=0.2, bending=2e5)


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
