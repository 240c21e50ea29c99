"""Element length in a run below a wire

The pantograph of EN 50318:2002 runs 9 m below a weightless wire (60 m, 20 kN), as in Time step of a
run. A contact between nodes bends its element, or not: what a cubic element does not follow of a
point force in its middle is of order ℓ/T for a string, for it cannot have the kink, and of order
ℓ³/EI for a stiff wire, for it has it only in the third derivative. A chain of point masses misses
ℓ/4T of a string between its nodes; with bending stiffness its second differences count, ℓ². The
missed yielding comes and goes as the contact moves, and is the order of the contact force
(derived here):

    cubic elements     string 1, stiff wire 3
    point masses       string 1, stiff wire 2

Stiff is √(EI/T) = 1 m here, longer than the elements. The contact wire (0.09 m) is a string for all
elements that are used: halving them takes away half of the error of its contact force, before any
filter. Quantity: contact force, mean error over all steps. Reference: the same run with 1152
elements. Steps of 0.25 ms for all.
"""

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from arcless.model import load_pantograph
from arcless.simulate.setup import pantographs
from tests.support import bare, schemes, spans
from tests.support.faults import Fault, Spoil, scaled, spoiled

Floats = NDArray[np.float64]

SPEED, DURATION, H = 30.0, 0.6, 2.5e-4
FINEST = 1152
# Order, how far it may be off, numbers of elements.
CASES = {
    ("cubic, planar", "string"): (1.0, 0.2, (96, 192, 384)),
    ("cubic, planar", "stiff wire"): (3.0, 0.3, (80, 160, 320)),
    ("cubic, spatial", "stiff wire"): (3.0, 0.3, (80, 160, 320)),
    ("point masses, planar", "string"): (1.0, 0.2, (96, 192, 384)),
    ("point masses, planar", "stiff wire"): (2.0, 0.15, (96, 192, 384)),
    ("point masses, spatial", "string"): (1.0, 0.2, (96, 192, 384)),
}
BENDING = {"string": 0.0, "stiff wire": 2e4}


def force(model: str, kind: str, count: int) -> Floats:
    """Contact force at each step, N."""
    wire = spans.span(
        model, count, length=spans.LENGTH, rest=spans.LENGTH / spans.STRETCH, axial=spans.AXIAL,
        bending=BENDING[kind], mass=spans.MASS,
    )  # fmt: skip
    t = H * np.arange(round(DURATION / H) + 1)
    turn = 2.0 * np.pi / DURATION
    x = 20.0 + 0.5 * SPEED * (t - np.sin(turn * t) / turn)
    head = pantographs.data(load_pantograph("en50318-2002"), 120.0)
    found = bare.run(wire, head, bare.Asked(schemes.DEFAULT, H, x, contact_stiffness=50e3))
    return np.asarray(found["force"])


@pytest.mark.parametrize(("model", "kind"), CASES)
def test_order(evidence: Any, model: str, kind: str) -> None:
    expected, tolerance, counts = CASES[model, kind]
    finest = force(model, kind, FINEST)
    evidence.order(
        f"{model}, {kind}: contact force, N",
        [spans.LENGTH / count for count in counts],
        [float(np.abs(force(model, kind, count) - finest).mean()) for count in counts],
        expected,
        tolerance=tolerance,
        reason="waves of an element's length, of the same order, come in or go out of step with"
        " each other as elements are halved; the reference has a third of the"
        " shortest elements",
        unit="element length",
    )


def finest_heavier(kind: str) -> Spoil:
    """Make the finest mesh heavier: an error of all meshes cancels, one of the reference not."""

    def spoil(arguments: dict[str, Any]) -> bool:
        rows = arguments["parts"][kind]
        is_finest = len(rows) == FINEST
        if is_finest:
            rows["mass"] *= 1.05
        return is_finest

    return spoil


FAULTS = [
    *(Fault(f"{model}: mass of the finest mesh 5 % high", spoiled(finest_heavier(kind)), test_order,
            model=model, kind="stiff wire")
      for model, kind in (("cubic, planar", "wires"), ("point masses, planar", "segments"))),
    Fault("bending of cubic elements dropped", scaled("wires", "EI", 0.0), test_order,
          model="cubic, planar", kind="stiff wire"),
    Fault("bending of chains dropped", scaled("bends", "EI", 0.0), test_order,
          model="point masses, planar", kind="stiff wire"),
]  # fmt: skip
