"""Tensioned beam under its weight and under a point load

A wire that resists bending, hinged at both ends, T v″ − EI v⁗ = −q, small slopes, ℓ = √(EI/T):

    weight w         v = (w/T) [x (L − x)/2 − ℓ² (1 − cosh((x − L/2)/ℓ)/cosh(L/2ℓ))]
    force F at a     v = (F/T) [x (L − a)/L − ℓ sinh(x/ℓ) sinh((L − a)/ℓ)/sinh(L/ℓ)]      x ≤ a

Source: derived here; sine series, summed once, agree to rounding. In the chain of point masses
differences stand for derivatives. Its exact answer is the same, with ℓ′ from 2 sinh(h/2ℓ′) = h/ℓ in
the hyperbolic functions and h/sinh(h/ℓ′) for the ℓ before sinh (derived here).

Both elements resist bending per metre of unstretched wire. In a wire stretched by s the EI above is
EI/s for cubic elements, EI s³ for the chain; the weight is w/s. With T = 12 kN, EA = 14 MN, s is
1.00086.

The program is asked by a scenario: one span of 20 m, EI = 200 kN m², so that ℓ = 4.1 m and bending
takes a third of the sag; a point mass of 20 kg at 7 m; elements of 1 m; in the plane and in space.
Gravity is a hundredth of the usual one: the squares of slopes then stay below 10⁻⁷.
"""

from typing import Any

import numpy as np
import pytest

from tests.support.beams import Beam
from tests.support.catenary import green, hooke
from tests.support.evidence import Evidence
from tests.support.faults import Fault, scaled
from tests.support.one_wire import AXIAL, HEIGHT, MASS, TENSION, one_wire

SPAN, BENDING = 20.0, 2e5
ELEMENT, GRAVITY = 1.0, 0.0981
LOAD, PLACE = 20.0, 7.0
ELL = (BENDING / TENSION) ** 0.5


def sag(model: str, dimension: str, load: float) -> tuple[Any, Any]:
    """Return x and sag in m of all nodes."""
    line = {"span_types__span__length": SPAN, "contact_wire__bending_stiffness": BENDING}
    if load:
        line["point_masses"] = [{"position": PLACE, "mass": load}]
    found = one_wire(
        line,
        wire_model=model,
        dimension=dimension,
        gravity=GRAVITY,
        contact_wire_element=ELEMENT,
    )
    x, y, z = found.positions[found.mesh.contact_nodes].T
    assert len(x) == SPAN / ELEMENT + 1
    assert not y.any()
    return x, HEIGHT - z


def exact(x: Any, model: str, load: float) -> Any:
    """Return the sag by the formulas."""
    if model == "hermite":
        stretch = float(green(TENSION, AXIAL))
        beam = Beam(SPAN, TENSION, BENDING / stretch)
    else:
        stretch = float(hooke(TENSION, AXIAL))
        beam = Beam(SPAN, TENSION, BENDING * stretch**3, ELEMENT)
    of_weight = beam.under_weight(x, MASS * GRAVITY / stretch)
    return of_weight + beam.under_force(x, load * GRAVITY, PLACE)


def error(model: str, load: float) -> float:
    """Largest error of a node, in the plane and in space, as part of the largest sag."""
    errors = []
    for dimension in ("planar", "spatial"):
        x, found = sag(model, dimension, load)
        reference = exact(x, model, load)
        errors.append(np.abs(found - reference).max() / reference.max())
    return float(max(errors))


NAMES = {0.0: "own weight", LOAD: "point load"}


@pytest.mark.parametrize("load", NAMES)
def test_cubic_elements(evidence: Evidence, load: float) -> None:
    evidence.below(
        f"worst node of cubic elements, {NAMES[load]}, part of the sag", error("hermite", load),
        (ELEMENT / ELL) ** 4 / 720 / 2, unit="1",
        reason="fourth order: (h/ℓ)⁴/720 of what bending takes, here up to half of the sag",
    )  # fmt: skip


@pytest.mark.parametrize("load", NAMES)
def test_chain_of_point_masses(evidence: Evidence, load: float) -> None:
    slope = 0.5 * MASS * GRAVITY * SPAN / TENSION + load * GRAVITY / TENSION
    evidence.below(
        f"worst point mass of a chain, {NAMES[load]}, part of the sag", error("lumped", load),
        0.5 * slope**2, unit="1",
        reason="the formula is exact for a chain but for half of the square of the slope",
    )  # fmt: skip


def test_sag_at_the_load(evidence: Evidence) -> None:
    x, found = sag("hermite", "planar", LOAD)
    (row,) = np.flatnonzero(np.abs(x - PLACE) < 1e-9)
    evidence.close(
        "sag at the point load, cubic elements", 1e3 * found[row],
        1e3 * exact(PLACE, "hermite", LOAD), unit="mm", relative=(ELEMENT / ELL) ** 4 / 720 / 2,
        reason="as above",
    )  # fmt: skip
    fine = np.linspace(0.0, SPAN, 201)
    string = Beam(SPAN, TENSION, 1e-3 * BENDING)
    limp = string.under_weight(fine, MASS * GRAVITY) + string.under_force(
        fine, LOAD * GRAVITY, PLACE
    )
    curves = {
        "tensioned beam": (fine, -1e3 * exact(fine, "hermite", LOAD)),
        "program, nodes": (x, -1e3 * found),
        "without bending stiffness": (fine, -1e3 * limp),
    }
    labels = {"x": "x, m", "y": "height, mm"}
    evidence.figure("point-load", curves, **labels, title="Wire of 20 m, 12 kN, with a point load")


FAULTS = [
    Fault("EI 0.1 % too high", scaled("wires", "EI", 1.001), test_cubic_elements, load=0.0),
    Fault("EI 0.1 % too high, chain", scaled("bends", "EI", 1.001), test_chain_of_point_masses,
          load=0.0),
    Fault("one of 19 bends 1 % too soft", scaled("bends", "EI", 0.99, [9]),
          test_chain_of_point_masses, load=0.0),
    Fault("tension 0.1 % too high", scaled("wires", "tension", 1.001), test_cubic_elements,
          load=LOAD),
    Fault("EA 1 % too high", scaled("wires", "EA", 1.01), test_cubic_elements, load=0.0),
    Fault("point mass 0.1 % too light", scaled("masses", "mass", 0.999), test_sag_at_the_load),
]  # fmt: skip
