"""Line at rest and its natural frequencies, by scikit-fem

scikit-fem (Gustafsson & McBain, JOSS 5 (2020) 2369) brings elements, quadrature and assembly; what
is integrated is written down for this section, from the energy of docs/theory/wires.md:

`U = ∫ ½ EA ε² + ½ EI κ² − μ g z ds`, `ε = ½ (r′·r′ − 1)`, `κ = (x′z″ − z′x″)/|r′|³`

with its first and second derivatives by hand, droppers `k (ℓ − ℓ₀)`, springs to ground, hinges of
the messenger wire at supports. Newton's method from the wires as drawn; natural frequencies from
that stiffness and the mass matrix `∫ μ S Sᵀ ds` (scipy, shift and invert).

The line is `en50318-2002` with three spans. Masses, stiffness and gravity come from the model
file; lengths of wires and droppers, and the rests of the springs, are those that Arcless found
when it designed the line. So if its design, its element, its assembly or its springs were wrong,
the line would hang elsewhere here.

With the same elements (1.5 m and 3 m) both solve one system of equations by two programs: nothing
but rounding is left. With elements of an eighth of the length of those of the shipped case (0.8 m
and 1.6 m), the length `√(EI/T)` = 0.1 m within which a wire bends at a clamp is resolved. Then what
the elements of the shipped case leave is seen. The record was written with scikit-fem 12.0.2.
"""

from functools import cache

import numpy as np
import pytest

import arcless
from arcless.equilibrium import equilibrium
from tests.support.faults import Fault, forgotten, gravity, scaled
from tests.support.python_faults import misled

pytest.importorskip("skfem", reason="scikit-fem is not installed: `make peers`")

from tests.support.skfem_line import Line

SHORT = {
    "line.spans": [{"type": "standard", "count": 3}],
    "travel": {"start": "60 m", "end": "120 m"},
    "analysis.spans": None,
}
FREQUENCIES = 20


def designed(contact: float, messenger: float) -> tuple[arcless.Scenario, equilibrium.Equilibrium]:
    elements = {
        "solver.scheme": "generalised-alpha", "solver.residual_flexibility": False,
        "solver.contact_wire_element": contact, "solver.messenger_wire_element": messenger,
    }  # fmt: skip
    scenario = arcless.load("en50318-2002-250").with_(**SHORT, **elements)
    return scenario, equilibrium.find(scenario)


def apart(found: equilibrium.Equilibrium, line: Line, q: np.ndarray) -> float:
    """Largest distance of the places where a node is, m."""
    here = found.arrays["positions"].reshape(-1, 2)
    moved = [q[list(unknowns)] - here[node] for node, unknowns in line.at.items()]
    assert len(moved) > 200
    return float(np.abs(moved).max())


def test_same_elements(evidence) -> None:
    scenario, found = designed(1.5, 3.0)
    line = Line(scenario, found)
    q = line.settle()
    evidence.below(
        "same elements: place of a node, largest difference", apart(found, line, q), 2e-9, unit="m",
        reason="rounding of a strain, 1e-16, times EA is 2e-9 N on some hundred nodes; the softest"
        " place gives way by 0.5 mm/N, and along the wire errors of the strain add up",
    )  # fmt: skip
    forces = line.dropper_forces(q)
    assert forces.size == 27
    evidence.below(
        "same elements: dropper force, largest difference of 27",
        float(np.abs(forces - found.of_droppers("link_tension")).max()), 2e-7, unit="N",
        reason="100 kN/m times the rounding of places 6 m high, 1e-15 m, and of those above",
    )  # fmt: skip
    mine, theirs = found.frequencies(FREQUENCIES), line.frequencies(q, FREQUENCIES)
    evidence.below(
        f"same elements: {FREQUENCIES} natural frequencies, largest relative difference",
        float(np.abs(mine / theirs - 1.0).max()), 2e-9, unit="1",
        reason="places off by 1e-10 m, and eigenvalues to 1e-10",
    )  # fmt: skip


@cache
def shipped() -> tuple[equilibrium.Equilibrium, Line, np.ndarray]:
    scenario, found = designed(0.8, 1.6)
    line = Line(scenario, found, parts=8)
    return found, line, line.settle()


def test_elements_of_the_shipped_case(evidence) -> None:
    found, line, q = shipped()
    evidence.below(
        "elements 8 times as fine: place of a node, largest difference", apart(found, line, q),
        0.7e-3, unit="m",
        reason="a wire kinked by φ = F/T over cubic elements of length h, with one slope at the"
        " clamp, gives way by φ h/18 less (∫ w′² with w′ quadratic and 0 at the clamp): 0.2 mm in"
        " the contact wire (86 N, 20 kN, 0.8 m) and 0.5 mm in the messenger wire (16 kN, 1.6 m)",
    )  # fmt: skip
    forces = line.dropper_forces(q)
    evidence.below(
        "elements 8 times as fine: dropper force, largest difference of 27",
        float(np.abs(forces - found.of_droppers("link_tension")).max()), 1.2, unit="N",
        reason="0.2 mm between droppers 6.5 m apart is 20 kN · 0.2 mm · 2/6.5 m = 1.2 N",
    )  # fmt: skip
    mine, theirs = found.frequencies(FREQUENCIES), line.frequencies(q, FREQUENCIES)
    evidence.below(
        f"elements 8 times as fine: {FREQUENCIES} natural frequencies, largest relative difference",
        float(np.abs(mine / theirs - 1.0).max()), 1e-3, unit="1",
        reason="the messenger wire sags by 0.7 m; the stiffness of that goes with the square of the"
        " sag, of which 0.7 mm may be missing, and a frequency with its root",
    )  # fmt: skip


def doubled(*lengths: float) -> list[float]:
    return [2 * length for length in lengths]


FAULTS = [
    *(Fault(f"{column} of the wires 1e-4 too large", scaled("wires", column, 1.0 + 1e-4),
            test_same_elements)
      for column in ("EA", "EI", "mass")),
    *(Fault(f"stiffness of {kind} 1e-4 too large", scaled(kind, "stiffness", 1.0 + 1e-4),
            test_same_elements)
      for kind in ("links", "springs")),
    Fault("gravity 1e-4 too large", gravity(1.0 + 1e-4), test_same_elements),
    Fault("elements twice as long", [forgotten(shipped), misled(__name__, "designed", doubled)],
          test_elements_of_the_shipped_case),
]  # fmt: skip
