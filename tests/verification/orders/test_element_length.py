"""Element length: frequencies, sag and elasticity of a wire

Cubic elements have degree p = 3 and continuous slopes. Theory, for a problem with derivatives of
order m in its energy (Strang & Fix, An Analysis of the Finite Element Method, 1973, second hand;
what is said of nodes and point forces is derived here):

    frequencies          h^(2(p + 1 − m)): 6 for a string (m = 1), 4 for a beam (m = 2)
    smooth static shape  h^(p + 1): 4. Nodes of a string are no better than the rest: what a node
                         feels is a kink there, which continuous slopes cannot draw
    force on a node      string: h, for the same reason. Beam under tension: 4, its kink is in the
                         third derivative

The first order below a point force is what the contact wire shows with elements much longer than
√(EI/T) = 0.09 m: with n elements in a span the wire is too stiff by 24 %/n, that is 0.6 % of a
span of 55 m in elements of 1.45 m.

In chains of point masses straight pieces with half their mass at either end are linear elements
with a lumped mass matrix, or second differences. Theory (derived here):

    frequencies of a string  ω = (2/ℓ) √(T/μ) sin(kℓ/2) exactly: order 2, error (kℓ)²/24
    other quantities         order 2
    point force on a node    exact for a string: a chain has its kink where the force is

References: pinned wire `ω² = (T k² + EI k⁴)/μ`, k = 3π/L; elasticity at mid-span `L/4T −
tanh(λL/2)/(2 T λ)`, λ² = T/EI (elementary); the exact curve of a heavy wire that stretches, see
Sag, with `N = EA ½ (s² − 1) s` of cubic elements and `N = EA (s − 1)` of straight pieces. One wire
of 60 m, EA = 10 MN, 20 kN; for the sag EA = 0.1 MN, 10 kN, 196 N/m, 8 m deep, in space with 60 N/m
of wind. Meshes made by hand, of equal elements and of elements three times longer at one end.
"""

from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
import pytest

from tests.support import spans
from tests.support.faults import Fault, gravity, scaled, spoiled

# An order, and how far it may be off.
Order = tuple[float, float]


@dataclass(frozen=True)
class Family:
    """Orders of a family of elements by theory, and the meshes that show them."""

    piece: str
    counts: tuple[int, ...]
    string: Order
    beam: Order
    sag: Order
    stiff: Order


CUBIC = Family("element length", (12, 24, 48), (6.0, 0.2), (4.0, 0.1), (4.0, 0.2), (4.0, 0.2))
CHAIN = Family("piece length", (24, 48, 96), (2.0, 0.02), (2.0, 0.02), (2.0, 0.02), (2.0, 0.15))
CUBICS = ("cubic, planar", "cubic, spatial")
CHAINS = ("point masses, planar", "point masses, spatial")
FAMILIES = dict.fromkeys(CUBICS, CUBIC) | dict.fromkeys(CHAINS, CHAIN)
# A wire with √(EI/T) = 3 m asks for shorter elements than a string.
FINE = (24, 48, 96)
STRING, BEAM = {"bending": 0.0, "taut": True}, {"bending": 1e5, "taut": False}
EXACT = "exact: rounding of 1e-16 of EA in stiffnesses of T, 500 times smaller"


def show(evidence: Any, model: str, what: str, order: Order, **asked: Any) -> None:
    family = FAMILIES[model]
    asked = {"counts": family.counts, "unit": family.piece} | asked
    spans.show_order(evidence, model, what=what, order=order[0], tolerance=order[1], **asked)


@pytest.mark.parametrize("model", FAMILIES)
def test_frequencies(evidence: Any, model: str) -> None:
    family, tell = FAMILIES[model], partial(show, evidence, model, error=spans.frequency_error)
    tell("third frequency of a string", family.string, **STRING)
    tell("third frequency of a beam", family.beam, **BEAM)
    what = "third frequency of a beam, pieces from 3 to 1"
    tell(what, family.beam, unit=f"mean {family.piece}", grading=0.5, **BEAM)


@pytest.mark.parametrize("model", FAMILIES)
def test_statics(evidence: Any, model: str) -> None:
    family, tell = FAMILIES[model], partial(show, evidence, model)
    tell("sag of a heavy wire", family.sag, error=spans.sag_error)
    what = "elasticity of a stiff wire, √(EI/T) = 3 m"
    tell(what, family.stiff, counts=FINE, error=spans.elasticity_error, bending=2e5)


@pytest.mark.parametrize("model", CUBICS)
def test_slopes_that_have_no_kink(evidence: Any, model: str) -> None:
    show(
        evidence, model, "elasticity of a string", (1.0, 1e-4), error=spans.elasticity_error,
        bending=0.0, reason="the kink is local, and all else exact: rounding",
    )  # fmt: skip


@pytest.mark.parametrize("model", CHAINS)
def test_a_string_of_pieces(evidence: Any, model: str) -> None:
    errors = [spans.frequency_error(model, n, **STRING) for n in CHAIN.counts]
    halves = 1.5 * np.pi / np.array(CHAIN.counts)  # k l / 2
    evidence.below(
        f"{model}: third frequency of a string against sin(kℓ/2)/(kℓ/2), worst mesh",
        float(np.max(np.abs(errors - (1.0 - np.sin(halves) / halves)))),
        1e-13,
        unit="1",
        reason=EXACT,
    )
    evidence.below(
        f"{model}: elasticity of a string, worst mesh",
        max(spans.elasticity_error(model, n, bending=0.0) for n in CHAIN.counts),
        1e-12,
        unit="1",
        reason=f"{EXACT}, in sums over 96 pieces",
    )


def before(arguments: dict[str, Any]) -> bool:
    """Give bends the length of the piece before them, not the mean of both neighbours."""
    bends = arguments["parts"]["bends"]
    pieces = arguments["parts"]["segments"]["rest_length"][bends["segments"]]
    share = pieces[:, 0] / pieces.mean(axis=1)
    bends["bending_stiffness"] *= share
    return bool(np.any(abs(share - 1.0) > 1e-6))


FAULTS = [
    # An error that refinement does not take away: the slope is that of a constant.
    *(Fault(f"{model}: {what}", broken, check, model=model)
      for model in CUBICS
      for what, broken, check in (
          ("mass 0.01 % high", scaled("wires", "mass", 1.0001), test_frequencies),
          ("EA 1 % high", scaled("wires", "EA", 1.01), test_statics),
          ("gravity 0.1 % high", gravity(1.001), test_statics),
      )),
    *(Fault(f"{model}: {what}", broken, check, model=model)
      for model in CHAINS
      for what, broken, check in (
          ("mass 1 % high", scaled("segments", "mass", 1.01), test_frequencies),
          ("EI 1 % high", scaled("bends", "EI", 1.01), test_frequencies),
          ("EA 1 % high", scaled("segments", "EA", 1.01), test_statics),
          ("gravity 1 % high", gravity(1.01), test_statics),
      )),
    *(Fault(f"{model}: wind from the other side", scaled("wire_loads", "force", -1.0),
            test_statics, model=model)
      for model in (CUBICS[1], CHAINS[1])),
    *(Fault("EI 1 % high", scaled("wires", "EI", 1.01), check, model=CUBICS[0])
      for check in (test_frequencies, test_statics)),
    Fault("bends with the length of the piece before them", spoiled(before), test_frequencies,
          model=CHAINS[0]),
]  # fmt: skip
