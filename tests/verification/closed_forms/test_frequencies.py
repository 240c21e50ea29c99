"""Natural frequencies of a tensioned beam

A straight wire hinged at both ends, k = nπ/L, stretched by s:

    across    ω² = (T k² + (EI/s) k⁴)/(μ/s)
    along     ω² = (s k)² EA (3s² − 1)/2μ      for Green's strain

Elements have frequencies of their own, which can be written down too. With sin(nπj/N) at the nodes
and cos(nπj/N) for their slopes, N cubic elements leave two equations; the element matrices are the
textbook ones of beam, tension and mass (Przemieniecki, Theory of Matrix Structural Analysis),
derived again. For a chain of N segments h, L₀ = h/s unstretched, with θ = nπ/N,

    ω² = [4 (T/h) sin²(θ/2) + 16 (EI/L₀³) sin⁴(θ/2)]/(μ L₀)

The program is asked by a scenario: one span of 60 m, 1.1 kg/m, 12 kN, no gravity, elements of
1.5 m; EI = 20 kN m², which raises the tenth frequency by a fifth (a contact wire has 0.1 to 0.2).
"""

from math import cos, pi, sin, sqrt
from typing import Any

import numpy as np
import pytest
from scipy.linalg import eigh

from tests.support.catenary import green, hooke
from tests.support.evidence import Evidence
from tests.support.faults import Fault, scaled
from tests.support.one_wire import AXIAL, MASS, SPAN, TENSION, one_wire

BENDING = 2e4
MODES = 20
ELEMENT = 1.5
COUNT = round(SPAN / ELEMENT)
NUMBERS = np.arange(1, MODES + 1)
STRETCH = float(green(TENSION, AXIAL))


def found(count: int = MODES, **settings: Any) -> Any:
    """Return the lowest frequencies in Hz of the straight wire."""
    line = {"contact_wire__bending_stiffness": BENDING}
    return one_wire(line, gravity=0.0, **settings).frequencies(count)


def straight(n: Any) -> Any:
    """Return the frequencies of the tensioned beam in Hz."""
    k = n * pi / SPAN
    return np.sqrt((TENSION * k**2 + BENDING / STRETCH * k**4) * STRETCH / MASS) / (2 * pi)


def of_cubic_elements(n: int, count: int) -> float:
    """Return a frequency in Hz of the wire of so many cubic elements."""
    h, theta = SPAN / count, n * pi / count
    tension = TENSION / (30 * h) * _matrix(36, 3 * h, -36, 3 * h, 4 * h * h, -h * h)
    bending = BENDING / STRETCH / h**3 * _matrix(12, 6 * h, -12, 6 * h, 4 * h * h, 2 * h * h)
    mass = MASS / STRETCH * h / 420 * _matrix(156, 22 * h, 54, -13 * h, 4 * h * h, -3 * h * h)
    k, m = (_of_wave(matrix, theta) for matrix in (tension + bending, mass))
    return float(sqrt(eigh(k, m, eigvals_only=True)[0]) / (2 * pi))


def _matrix(*entries: float) -> Any:
    """Return a beam element's matrix by its first row, aa and ab; its second end is mirrored."""
    vv, va, vw, vb, aa, ab = entries
    return np.array(
        [[vv, va, vw, vb], [va, aa, -vb, ab], [vw, -vb, vv, -va], [vb, ab, -va, aa]]
    )  # fmt: skip


def _of_wave(e: Any, theta: float) -> Any:
    """Return the two equations that an element leaves for sines at nodes, cosines as slopes."""
    cross = 2 * e[1, 2] * sin(theta)
    return np.array(
        [
            [2 * e[0, 0] + 2 * e[0, 2] * cos(theta), cross],
            [cross, 2 * e[1, 1] + 2 * e[1, 3] * cos(theta)],
        ]
    )


def worst(values: Any, reference: Any) -> float:
    assert len(values) == len(reference) > 0
    return float(np.abs(np.asarray(values) / np.asarray(reference) - 1.0).max())


def test_across(evidence: Evidence) -> None:
    few = NUMBERS[:10]
    k = few * pi / SPAN
    share = BENDING * k**2 / (TENSION + BENDING * k**2)
    evidence.below(
        "worst of 10 frequencies across, cubic elements of 1.5 m",
        worst(found(10, contact_wire_element=ELEMENT), straight(few)),
        1.1 * max((k * ELEMENT) ** 4 / 1440 * share + (k * ELEMENT) ** 6 / 60480),
        unit="1",
        reason="(kh)⁴/1440 of the part of bending, (kh)⁶/60480 of that of tension; a tenth more",
    )


def test_cubic_elements_have_their_own(evidence: Evidence) -> None:
    own = [of_cubic_elements(n, COUNT) for n in NUMBERS]
    evidence.below(
        "worst of 20 frequencies, against those of the elements",
        worst(found(contact_wire_element=ELEMENT), own), 3e-12, unit="1",
        reason="rounding: ten times ε EA/T, by which a tension rounds",
    )  # fmt: skip


def test_a_chain_has_its_own(evidence: Evidence) -> None:
    stretch = float(hooke(TENSION, AXIAL))
    theta, rest = NUMBERS * pi / COUNT, ELEMENT / stretch
    string, beam = 4 * TENSION / ELEMENT, 16 * BENDING / rest**3
    squares = string * np.sin(theta / 2) ** 2 + beam * np.sin(theta / 2) ** 4
    evidence.below(
        "worst of 20 frequencies of a chain, against those of the chain",
        worst(
            found(contact_wire_element=ELEMENT, wire_model="lumped"),
            np.sqrt(squares / (MASS * rest)) / (2 * pi),
        ),
        3e-12, unit="1", reason="as for cubic elements",
    )  # fmt: skip


@pytest.mark.parametrize("count", [2, 2 * MODES])
def test_in_space_each_comes_twice(evidence: Evidence, count: int) -> None:
    both = found(count, contact_wire_element=ELEMENT, dimension="spatial")
    one = found(contact_wire_element=ELEMENT)[: count // 2]
    evidence.below(
        f"worst of {count} frequencies in space, against two of each in the plane",
        worst(both, np.repeat(one, 2)), 1e-9, unit="1",
        reason="Lanczos's method ends where values move by less than 1e-10 in ω²; ten times that",
    )  # fmt: skip


def test_wave_speed_of_the_shipped_wire(evidence: Evidence) -> None:
    wire = {"mass": 1.35, "axial_stiffness": 15e6, "bending_stiffness": 195.0, "tension": 22e3}
    line = {f"contact_wire__{name}": value for name, value in wire.items()}
    first = one_wire(line, gravity=0.0).frequencies(1)[0]
    evidence.close(
        "wave speed 2 L f₁ of the contact wire of `ac-simple-55`", 3.6 * 2 * SPAN * first, 460.0,
        unit="km/h", absolute=0.5, mark="A", reason="the data's own table gives whole km/h",
    )  # fmt: skip


def test_along(evidence: Evidence) -> None:
    line = {"contact_wire__bending_stiffness": 0.0}
    many = one_wire(line, gravity=0.0, contact_wire_element=ELEMENT).frequencies(45)
    first = sqrt(AXIAL * 0.5 * (3 * STRETCH**2 - 1) / MASS) * STRETCH / (2 * SPAN)
    nearest = many[np.argmin(np.abs(many - first))]
    evidence.close(
        "first frequency along the wire", nearest, first, unit="Hz", relative=1e-9,
        reason="(kh)⁶/60480 with kh = 0.08 is 4e-12; rounding",
    )  # fmt: skip


FAULTS = [
    Fault("EI 0.1 % too high", scaled("wires", "EI", 1.001), test_across),
    Fault("EI 0.1 % too high, chain", scaled("bends", "EI", 1.001), test_a_chain_has_its_own),
    Fault("mass 0.1 % too high", scaled("wires", "mass", 1.001), test_across),
    Fault("mass 1 % too high", scaled("wires", "mass", 1.01), test_wave_speed_of_the_shipped_wire),
    Fault("one of 40 segments 0.1 % too heavy", scaled("segments", "mass", 1.001, [7]),
          test_a_chain_has_its_own),
    Fault("EA 1 % too high", scaled("wires", "EA", 1.01), test_cubic_elements_have_their_own),
    Fault("EA 1 % too high", scaled("wires", "EA", 1.01), test_along),
    Fault("tension 0.1 % too low", scaled("wires", "tension", 0.999), test_across),
    Fault("one of 40 elements bends too little by 0.1 %", scaled("wires", "EI", 1.001, [3]),
          test_cubic_elements_have_their_own),
]  # fmt: skip
