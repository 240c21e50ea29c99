"""Mass on a wire, and a piece of another wire in it

* sag of a string (tension T, weight w) of one span below a mass m, a and b from its ends:
  `z = w a b/2T + m g a b/(T (a + b))`
* frequencies of a string of two densities μ₁ (length a) and μ₂ (length b): the waves on both meet
  without a kink, `k₁ cos(k₁a) sin(k₂b) + k₂ sin(k₁a) cos(k₂b) = 0` with `k = ω √(μ/T)`. What is
  compared is the angle `atan2(left side, k₁ + k₂)`, so that a steep root counts like a flat one.

Textbook strings. Asked as a trolley wire of one span of 60 m without bending stiffness, 12 kN: a
mass of 20 kg at 25 m, and a section insulator of four times the wire's mass over the last 20 m.
"""

from math import atan2, cos, pi, sin, sqrt
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
from tests.support.simple_lines import one_span_data

FINE = {"solver__contact_wire_element": 0.5, "solver__messenger_wire_element": 0.5}
ONE_SPAN = {"travel": {"start": 10.0, "end": 50.0}, "analysis": {"from": 20.0, "to": 40.0}}
TENSION, GRAVITY = 12e3, 9.81


def at_rest(line: dict[str, Any], **changes: Any) -> StaticsResult:
    return arcless.statics(load(scenario_data(line, **ONE_SPAN, **FINE, **changes)))


@pytest.mark.parametrize("model", ["hermite", "lumped"])
def test_sag_below_a_mass(evidence: Evidence, model: str) -> None:
    a, b = 25.0, 35.0
    heavy = one_span_data(point_masses=[{"position": a, "mass": 20.0}])
    found = at_rest(heavy, solver__wire_model=model).equilibrium
    points = found.positions[found.mesh.contact_nodes]
    wire = 1.1 * GRAVITY * (1 - TENSION / 14e6)
    evidence.close(
        f"sag below the mass, {model}",
        5.5 - points[np.argmin(abs(points[:, 0] - a)), 2],
        wire * a * b / (2 * TENSION) + 20.0 * GRAVITY * a * b / (TENSION * (a + b)),
        unit="m",
        relative=1e-3,
        reason="the next terms are of the order of the squared slope, (0.02)² = 4e-4; cubic "
        "elements round off the kink over 0.5 m",
    )


def test_frequencies_with_an_insert(evidence: Evidence) -> None:
    insert = {
        "position": 50.0,
        "length": 20.0,
        "mass": 20.0 * 4.4,
        "axial_stiffness": 1e9,
        "bending_stiffness": 0.0,
    }
    stiff = {"contact_wire__ends": "fixed", "contact_wire__axial_stiffness": 1e9}
    found = at_rest(one_span_data(inserts=[insert], **stiff), solver__gravity=1e-3)
    frequencies = found.natural_frequencies_Hz[:6]
    assert len(frequencies) == 6
    evidence.below(
        "largest phase off at six frequencies",
        max(abs(phase_off(2 * pi * f, 40.0, 20.0)) for f in frequencies),
        1e-4,
        unit="rad",
        reason="cubic elements of 0.5 m, shortest wave 20 m: (kh)⁴/720 = 1e-6 of ka = 12; a kink "
        "of the bending between elements as much again, several times",
    )


def phase_off(omega: float, a: float, b: float) -> float:
    """Return the distance of the waves from both ends from meeting without a kink."""
    k1, k2 = (omega * sqrt(density / TENSION) for density in (1.1, 4.4))
    left = sin(k1 * a) * k2 * cos(k2 * b) + sin(k2 * b) * k1 * cos(k1 * a)
    return atan2(left, k1 + k2)


FAULTS = [
    Fault("mass 1 % too light", scaled("masses", "mass", 0.99), test_sag_below_a_mass,
          model="hermite"),
    Fault("tension 1 % too high", tension(1.01), test_sag_below_a_mass, model="lumped"),
    Fault("mass of the wires 1 % too high", scaled("wires", "mass", 1.01),
          test_frequencies_with_an_insert),
]  # fmt: skip
