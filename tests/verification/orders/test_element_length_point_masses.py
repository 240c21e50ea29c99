"""Element length, chains of point masses

Straight pieces with half their mass at either end are linear elements with a lumped mass matrix, or
second differences. Theory (derived here):

    frequencies of a string  ω = (2/ℓ) √(T/μ) sin(kℓ/2) exactly: order 2, error (kℓ)²/24
    other quantities         order 2
    point force on a node    exact for a string: a chain has its kink where the force is

References as for Element length, cubic elements, with Hooke's law `N = EA (s − 1)` of the pieces.
The same wires, in equal pieces, and in pieces three times longer at one end.
"""

from functools import partial
from typing import Any

import numpy as np
import pytest

from tests.support import spans
from tests.support.faults import Fault, gravity, scaled, spoiled

MODELS = ("point masses, planar", "point masses, spatial")
DIMENSIONS = pytest.mark.parametrize("model", MODELS)
COUNTS = (24, 48, 96)
PIECE = "piece length"
EXACT = "exact: rounding of 1e-16 of EA in stiffnesses of T, 500 times smaller"


@DIMENSIONS
def test_frequencies(evidence: Any, model: str) -> None:
    string, beam = {"bending": 0.0, "taut": True}, {"bending": 1e5, "taut": False}
    errors = [spans.frequency_error(model, n, **string) for n in COUNTS]
    halves = 1.5 * np.pi / np.array(COUNTS)  # k l / 2
    evidence.below(
        f"{model}: third frequency of a string against sin(kℓ/2)/(kℓ/2), worst mesh",
        float(np.max(np.abs(errors - (1.0 - np.sin(halves) / halves)))),
        1e-13,
        unit="1",
        reason=EXACT,
    )
    show = partial(spans.show_order, evidence, model, COUNTS, spans.frequency_error)
    show("third frequency of a string", order=2.0, tolerance=0.02, unit=PIECE, **string)
    show("third frequency of a beam", order=2.0, tolerance=0.02, unit=PIECE, **beam)
    what = "third frequency of a beam, pieces from 3 to 1"
    show(what, order=2.0, tolerance=0.02, unit=f"mean {PIECE}", grading=0.5, **beam)


@DIMENSIONS
def test_statics(evidence: Any, model: str) -> None:
    show = partial(spans.show_order, evidence, model, COUNTS, unit=PIECE)
    show(spans.sag_error, "sag of a heavy wire", order=2.0, tolerance=0.02)
    evidence.below(
        f"{model}: elasticity of a string, worst mesh",
        max(spans.elasticity_error(model, n, bending=0.0) for n in COUNTS),
        1e-12,
        unit="1",
        reason=f"{EXACT}, in sums over 96 pieces",
    )
    what = "elasticity of a stiff wire, √(EI/T) = 3 m"
    show(spans.elasticity_error, what, order=2.0, tolerance=0.15, bending=2e5)


def before(arguments: dict[str, Any]) -> bool:
    """Give bends the length of the piece before them, not the mean of those beside them."""
    pieces = arguments["parts"]["segments"][1][:, 0]
    numbers, floats = arguments["parts"]["bends"]
    share = pieces[numbers[:, 0]] / pieces[numbers].mean(axis=1)
    floats[:, 0] *= share
    return bool(np.any(abs(share - 1.0) > 1e-6))


FAULTS = [
    *(Fault(f"{model}: {what}", broken, test_frequencies, model=model)
      for model in MODELS
      for what, broken in (
          ("mass 1 % high", scaled("segments", "mass", 1.01)),
          ("EI 1 % high", scaled("bends", "EI", 1.01)),
      )),
    *(Fault(f"{model}: {what}", broken, test_statics, model=model)
      for model in MODELS
      for what, broken in (
          ("EA 1 % high", scaled("segments", "EA", 1.01)),
          ("gravity 1 % high", gravity(1.01)),
      )),
    Fault("wind from the other side", scaled("wire_loads", "across", -1.0), test_statics,
          model="point masses, spatial"),
    Fault("bends with the length of the piece before them", spoiled(before), test_frequencies,
          model="point masses, planar"),
]  # fmt: skip
