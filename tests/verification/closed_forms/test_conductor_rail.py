"""Conductor rail: a beam without tension on many supports

Spans L of a rail (EI, mass μ per metre) on supports of stiffness k, no tension anywhere:

* sag far from the ends, clamped by symmetry: `z = w L⁴/384 EI`. A chain of segments takes
  differences for derivatives: `1 + 8/N²` of that with N segments in a span.
* force P in the middle of a span, stiff supports: `z/P = L³/EI (1/192 + 1/(64 (1 + √3)))`. The
  spans beyond turn back as `2√3 EI/L` (three-moment equation, neighbours by −(2 − √3)), the span
  itself as `2 EI/L`, and the clamped moment is `PL/8`.
* the same on springs: slope-deflection equations of 30 spans, solved here as a dense system.
* lowest frequency: neighbours swing against one another, each as a hinged beam,
  `f = π/2L² √(EI/μ)`.
* heated between fixed ends: it buckles span by span at Euler's load `π² EI/L²`.

Textbook beams; composed here. Asked as a line of 30 spans of 8 m, EI 2e5 N m², 8 kg/m; elements of
0.5 m.
"""

from math import pi, sqrt
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.model import load
from arcless.simulate import StaticsResult
from tests.support.evidence import Evidence
from tests.support.faults import Fault, scaled
from tests.support.line_types import scenario_data
from tests.support.python_faults import tension
from tests.support.simple_lines import rail_data

FINE = {"solver__contact_wire_element": 0.5, "solver__messenger_wire_element": 0.5}
SPANS, SPAN, BENDING, MASS = 30, 8.0, 2e5, 8.0


def at_rest(line: dict[str, Any], **changes: Any) -> StaticsResult:
    return arcless.statics(load(scenario_data(line, **FINE | changes)))


@pytest.mark.parametrize("model", ["hermite", "lumped"])
def test_sag(evidence: Evidence, model: str) -> None:
    found = at_rest(rail_data(), solver__wire_model=model)
    assert found.contact_wire_sag_m is not None
    share = {"hermite": 1.0, "lumped": 1.0 + 8.0 / 16**2}[model]
    evidence.close(
        f"sag, {model}",
        found.contact_wire_sag_m,
        MASS * 9.81 * SPAN**4 / (384 * BENDING) * share,
        unit="m",
        relative=1e-5,
        reason="the rail is longer than the track by half its slope squared, 1e-6, and the ends "
        "are fifteen spans away; both formulas are exact at the nodes",
    )
    tension = found.equilibrium.arrays["wire_tension"]
    evidence.below(
        f"largest tension, {model}",
        float(abs(tension).max()),
        1.6,
        unit="N",
        reason="nothing but the shear of half a span, 314 N, times the slope there, 4e-3",
    )


def test_force_in_the_middle(evidence: Evidence) -> None:
    e = at_rest(rail_data()).elasticity_m_per_N
    evidence.close(
        "elasticity in the middle, stiff supports",
        e[len(e) // 2],
        SPAN**3 / BENDING * (1 / 192 + 1 / (64 * (1 + sqrt(3)))),
        unit="m/N",
        relative=2e-5,
        reason="the rail's slope of 2e-3 squared, several times",
    )
    soft = 6e4
    e = at_rest(rail_data(contact_support__vertical_stiffness=soft)).elasticity_m_per_N
    evidence.close(
        "elasticity in the middle, on springs",
        e[len(e) // 2],
        middle_of_beam_on_springs(soft),
        unit="m/N",
        relative=5e-5,
        reason="the rail's slope squared; it sags by 10 mm more on its springs",
    )


def middle_of_beam_on_springs(stiffness: float) -> float:
    """Deflection under a unit force in the middle span; slope-deflection, anchors at both ends.

    Unknowns are height and slope at each support; a span of beam couples them by its stiffness
    12, 6, 4, 2 EI/L^n, and the loaded one adds the forces ½ and the moments ± L/8 of clamped ends.
    """
    a, b, c = (factor * BENDING / SPAN**n for factor, n in ((12, 3), (6, 2), (1, 1)))
    beam = np.array([[a, b, -a, b], [b, 4 * c, -b, 2 * c], [-a, -b, a, -b], [b, 2 * c, -b, 4 * c]])
    size = 2 * (SPANS + 1)
    matrix, force = np.zeros((size, size)), np.zeros(size)
    for i in range(SPANS):
        matrix[2 * i : 2 * i + 4, 2 * i : 2 * i + 4] += beam
    for i in range(1, SPANS):
        matrix[2 * i, 2 * i] += stiffness
    loaded = 2 * ((SPANS - 1) // 2)
    force[loaded : loaded + 4] += [0.5, SPAN / 8, 0.5, -SPAN / 8]
    free = [i for i in range(size) if i not in {0, size - 2}]
    found = np.zeros(size)
    found[free] = np.linalg.solve(matrix[np.ix_(free, free)], force[free])
    z0, t0, z1, t1 = found[loaded : loaded + 4]
    return float(0.5 * (z0 + z1) + SPAN / 8 * (t0 - t1) + SPAN**3 / (192 * BENDING))


def test_first_frequency(evidence: Evidence) -> None:
    evidence.close(
        "lowest frequency",
        at_rest(rail_data()).natural_frequencies_Hz[0],
        pi / (2 * SPAN**2) * sqrt(BENDING / MASS),
        unit="Hz",
        relative=1e-3,
        reason="cubic elements of L/16: (π/16)⁴/720 = 2e-6; the rail is led over its supports by "
        "the arch of its sag, which moves along the track: some 1e-4",
    )


def test_buckling_of_a_heated_rail(evidence: Evidence) -> None:
    fixed = rail_data(contact_wire__ends="fixed", contact_wire__thermal_expansion=23e-6)
    found = at_rest(fixed, as_built__temperature_difference=30.0)
    assert found.as_built is not None
    evidence.close(
        "compression between fixed ends, 30 K warmer",
        -found.as_built["contact_wire_tension_N"],
        pi**2 * BENDING / SPAN**2,
        unit="N",
        relative=1e-2,
        reason="from below, as far as the sag, which bends all spans alike, is small beside the "
        "buckles; held straight it would carry EA α Δθ, three times as much",
    )


FAULTS = [
    Fault("EI 1 % too high", scaled("wires", "EI", 1.01), test_sag, model="hermite"),
    Fault("EI of bends 1 % too high", scaled("bends", "EI", 1.01), test_sag, model="lumped"),
    Fault("EI 1 % too high", scaled("wires", "EI", 1.01), test_force_in_the_middle),
    Fault("EI 5 % too high", scaled("wires", "EI", 1.05), test_buckling_of_a_heated_rail),
    Fault("mass 1 % too high", scaled("wires", "mass", 1.01), test_first_frequency),
    Fault("10 N of tension", tension(more=10.0), test_sag, model="hermite"),
]  # fmt: skip
