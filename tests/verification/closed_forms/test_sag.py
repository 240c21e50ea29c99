"""Sag of one wire between two anchors

A wire without bending stiffness hangs in the elastic catenary. With H the horizontal tension, w
the weight per metre of unstretched wire, σ the length along that and V = w L₀/2 for ends of one
height,

    x = H σ/EA + (H/w) [asinh(V/H) − asinh((V − wσ)/H)]
    z = − (σ/EA) (V − wσ/2) − (H/w) [√(1 + (V/H)²) − √(1 + ((V − wσ)/H)²)]

and the unstretched length L₀ follows from x(L₀) = L. Source: Irvine, Cable Structures (1981), here
second hand and derived again. The integrals behind it are taken by Gauss's rule, for any law of
stretching; the first row holds it against these formulas. A taut wire is a parabola with

    sag = w L²/8T

The chain of point masses stretches by Hooke's law, N = EA (s − 1). The cubic elements use Green's
strain, N = EA ½ (s² − 1) s: at the same tension s is smaller by ³⁄₂ (T/EA)², some 10⁻⁶.

The program is asked by a scenario: a line of one span of 60 m (1.1 kg/m, EA = 14 MN, EI = 0),
anchored at both ends, elements of 1 m. The horizontal tension is given, 12 kN as in service, or
1.5 kN, at which the wire sags by a twentieth of its span; shape and unstretched length are the
answer. Far greater sags are not found by the design calculation.
"""

from typing import Any

import numpy as np
import pytest

from tests.support.catenary import Catenary, green, hooke, of_tension
from tests.support.evidence import Evidence
from tests.support.faults import Fault, gravity, scaled
from tests.support.one_wire import AXIAL, HEIGHT, SPAN, TENSION, WEIGHT, one_wire

SLACK = 1.5e3
ELEMENT = 1.0
TURN = WEIGHT * ELEMENT / SLACK  # of a wire along one element, in rad


def hung(tension: float, model: str = "hermite", rise: float = 0.0) -> tuple[Any, Any, Any]:
    """Return x and height over the first end in m of all nodes, and the equilibrium."""
    line: dict[str, Any] = {"contact_wire__tension": tension}
    if rise:
        change = {"from_support": 1, "to_support": 2, "height": HEIGHT + rise}
        line["geometry__height_changes"] = [change]
    found = one_wire(line, wire_model=model, contact_wire_element=ELEMENT)
    x, _, z = found.positions[found.mesh.contact_nodes].T
    assert len(x) == round(SPAN / ELEMENT) + 1
    return x, z - HEIGHT, found


def exact(tension: float, law: Any = green, rise: float = 0.0) -> Catenary:
    return of_tension(SPAN, WEIGHT, AXIAL, tension, law, rise=rise)


def test_the_reference_itself(evidence: Evidence) -> None:
    wire = exact(SLACK, hooke)
    sigma = np.linspace(0.0, wire.rest, 11)
    h, v, w = wire.horizontal, wire.hanging, wire.weight
    below = v - w * sigma
    x = h * sigma / AXIAL + h / w * (np.arcsinh(v / h) - np.arcsinh(below / h))
    z = -sigma / AXIAL * (v - 0.5 * w * sigma)
    z -= h / w * (np.hypot(1.0, v / h) - np.hypot(1.0, below / h))
    evidence.below(
        "reference by Gauss's rule against the formulas, 1.5 kN",
        max(np.abs(wire.at(sigma)[0] - x).max(), np.abs(wire.at(sigma)[1] - z).max()),
        1e-12, unit="m", reason="rounding of H/w = 139 m, times 30",
    )  # fmt: skip


def test_sag_of_a_taut_wire(evidence: Evidence) -> None:
    wire = exact(TENSION, hooke)
    strain = 1.5 * (TENSION / AXIAL) ** 2
    found = hung(TENSION)
    evidence.close(
        "sag, 12 kN", -found[1].min(), -wire.at(0.5 * wire.rest)[1], unit="m",
        relative=1.2 * strain,
        reason="Hooke's law here, Green's strain there: the weight by metre is ³⁄₂ (T/EA)² greater",
    )  # fmt: skip
    evidence.close(
        "unstretched length, 12 kN", found[2].arrays["wire_rest_length"].sum(), wire.rest,
        unit="m", relative=1.2 * strain, reason="the same; a twelfth of what 1 % of EA would do",
    )  # fmt: skip


def test_parabola(evidence: Evidence) -> None:
    weight = WEIGHT / (1.0 + TENSION / AXIAL)
    evidence.close(
        "sag, 12 kN, parabola", -hung(TENSION)[1].min(), weight * SPAN**2 / (8 * TENSION),
        unit="m", relative=1.1 * (weight * SPAN / TENSION) ** 2 / 48,
        reason="the next term of the catenary, (wL/T)²/48; w is taken per metre of stretched wire",
    )  # fmt: skip


@pytest.mark.parametrize("rise", [0.0, 3.0])
def test_shape_of_a_slack_wire(evidence: Evidence, rise: float) -> None:
    x, z, _ = hung(SLACK, rise=rise)
    sag = WEIGHT * SPAN**2 / (8 * SLACK)
    evidence.below(
        f"worst height of a node, 1.5 kN, ends {rise:.0f} m apart in height",
        np.abs(z - exact(SLACK, rise=rise).height(x)).max(),
        sag * TURN**4,
        unit="m",
        reason="fourth order: sag (wh/H)⁴, wh/H = 0.0072 the turn of the wire along an element",
    )
    if rise == 0.0:
        parabola = -WEIGHT * x * (SPAN - x) / (2 * SLACK)
        curves = {
            "catenary": (x, exact(SLACK).height(x) - parabola),
            "program, nodes": (x[::4], (z - parabola)[::4]),
        }
        labels = {"x": "x, m", "y": "height above the parabola, m"}
        evidence.figure("parabola", curves, **labels, title="Wire of 60 m at 1.5 kN")


def test_shape_of_a_chain(evidence: Evidence) -> None:
    x, z, _ = hung(SLACK, "lumped")
    sag = WEIGHT * SPAN**2 / (8 * SLACK)
    evidence.below(
        "worst height of a point mass, 1.5 kN", np.abs(z - exact(SLACK, hooke).height(x)).max(),
        1.1 * sag * TURN**2 / 24, unit="m",
        reason="an arc is longer than its chord by (wh/H)²/24; of the sag, and a tenth more",
    )  # fmt: skip


def tension_error(model: str, law: Any) -> float:
    """Largest relative error of the tension in the middle of an element or segment."""
    found = hung(SLACK, model)[2]
    lengths = found.arrays["wire_rest_length"]
    wire = exact(SLACK, law)
    here = wire.tension((np.cumsum(lengths) - 0.5 * lengths) * wire.rest / lengths.sum())
    assert np.ptp(here) > 0.02 * SLACK, "it varies along the wire"
    return float(np.abs(found.arrays["wire_tension"] / here - 1.0).max())


def test_tension_of_cubic_elements(evidence: Evidence) -> None:
    evidence.below(
        "worst tension in the middle of an element, 1.5 kN", tension_error("hermite", green),
        AXIAL / SLACK * TURN**4 / 3, unit="1",
        reason="parabolic slopes: the strain there is off by (wh/H)⁴/4, times EA/T",
    )  # fmt: skip


def test_tension_of_a_chain(evidence: Evidence) -> None:
    share = 0.5 * WEIGHT * SPAN / SLACK
    evidence.below(
        "worst tension of a segment, 1.5 kN", tension_error("lumped", hooke),
        1.1 * share**2 * TURN**2 / 24, unit="1",
        reason="chord and arc, (wh/H)²/24, of the weight that hangs at an end, (V/H)² of N",
    )  # fmt: skip


FAULTS = [
    Fault("EA 1 % too high", scaled("wires", "EA", 1.01), test_sag_of_a_taut_wire),
    Fault("mass of the wire 1 % too high", scaled("wires", "mass", 1.01), test_parabola),
    Fault("mass of the wire 1 % too high", scaled("wires", "mass", 1.01),
          test_shape_of_a_slack_wire, rise=3.0),
    Fault("tension 0.1 % too high, segments", scaled("segments", "tension", 1.001),
          test_shape_of_a_chain),
    Fault("tension 0.1 % too high, wires", scaled("wires", "tension", 1.001),
          test_tension_of_cubic_elements),
    Fault("gravity 0.1 % too high", gravity(1.001), test_sag_of_a_taut_wire),
    Fault("gravity 0.1 % too high", gravity(1.001), test_tension_of_a_chain),
    Fault("one of sixty elements 1 % too light", scaled("wires", "mass", 0.99, [30]),
          test_shape_of_a_slack_wire, rise=0.0),
]  # fmt: skip
