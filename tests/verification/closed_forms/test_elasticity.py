"""Elasticity of one wire and of a simple line

How far a line rises at x under a small force, per newton. One wire, fixed at both ends:

    string          e = x (L − x)/(L T)
    tensioned beam  e = x (L − x)/(L T) − (ℓ/T) sinh(x/ℓ) sinh((L − x)/ℓ)/sinh(L/ℓ),   ℓ = √(EI/T)
    string of cubic elements, at a node       e = x (L − x)/(L T) − (√2/24) h/T

The last, derived here: a string has a kink below the force, cubic elements have none. They lose
the best approach to a jump by parabolas that join, Σ (3 − 2√2)ᵏ over the elements on both sides.

A simple line is two beams or strings on springs: droppers between them, supports above, arms below.
Between these is nothing but wire, whose stiffness is known exactly; one set of equations without a
mesh gives e (`tests/support/two_beams.py`, derived here). Under a force that slackens droppers
these are taken out, and what they carried at rest, w times their distance, is taken off the wires.

The program is asked by scenarios: one span of 60 m at 12 kN; six of 60 m, both wires at 15 kN, six
droppers of 100 kN/m in each, supports of 500 kN/m, arms of 300 N/m. Gravity is nothing, or a
thousandth: wires are straight; `elasticity_with_sag` has the rest. Beams have EI = 3 kN m² and
elements of 0.25 m, chains no EI and segments of 2.5 m.
"""

from typing import Any

import numpy as np
import pytest

from arcless.equilibrium import equilibrium
from arcless.model import load
from tests.support.beams import Beam
from tests.support.catenary import green, hooke
from tests.support.evidence import Evidence
from tests.support.faults import Fault, scaled
from tests.support.line_types import scenario_data, stitched_data
from tests.support.one_wire import AXIAL, SPAN, TENSION, one_wire
from tests.support.two_beams import TwoBeams, Wire

PLACES = np.array([12.0, 30.0, 42.0])
ELEMENT = 1.5


def of_one_wire(model: str, bending: float, element: float) -> Any:
    line = {"contact_wire__bending_stiffness": bending}
    plain = {"scheme": "generalised-alpha", "residual_flexibility": False, "wire_model": model}
    solver = {"gravity": 0.0, "contact_wire_element": element, **plain}
    return one_wire(line, **solver).elasticity(PLACES)


def string(x: Any) -> Any:
    return x * (SPAN - x) / (SPAN * TENSION)


def worst(values: Any, reference: Any) -> float:
    assert len(values) == len(reference) > 0
    return float(np.abs(values / reference - 1.0).max())


def test_string_of_cubic_elements(evidence: Evidence) -> None:
    evidence.below(
        "one string, cubic elements, worst of 3 nodes",
        worst(
            of_one_wire("hermite", 0.0, ELEMENT),
            string(PLACES) - np.sqrt(2) / 24 * ELEMENT / TENSION,
        ),
        3e-12, unit="1", reason="rounding: ten times ε EA/T",
    )  # fmt: skip


def test_string_of_point_masses(evidence: Evidence) -> None:
    evidence.below(
        "one string, chain, worst of 3 nodes",
        worst(of_one_wire("lumped", 0.0, ELEMENT), string(PLACES)), 3e-12, unit="1",
        reason="the formula is exact at the nodes of a chain; rounding as above",
    )  # fmt: skip


def test_beam(evidence: Evidence) -> None:
    bending, element = 3e3, 0.25
    beam = Beam(SPAN, TENSION, bending / float(green(TENSION, AXIAL)))
    part = 0.5 * beam.rounding / TENSION / string(PLACES).min()
    evidence.below(
        "one tensioned beam, worst of 3 nodes",
        worst(
            of_one_wire("hermite", bending, element),
            np.array([beam.under_force(x, 1.0, x) for x in PLACES]),
        ),
        part * (element / beam.rounding) ** 4 / 720, unit="1",
        reason="(h/ℓ)⁴/720 of the part that bending takes, ℓ/2T",
    )  # fmt: skip


DROPPERS = (5.0, 15.0, 25.0, 35.0, 45.0, 55.0)
PULL = 15e3
BEAM = 3e3
LIGHT = 0.00981
ALONG = np.array([120.0, 122.5, 125.0, 130.0, 140.0, 145.0, 150.0])


def simple_line(model: str, bending: float, element: float) -> equilibrium.Equilibrium:
    line = stitched_data(
        stitch_wire=None,
        dropper={"stiffness": 1e5},
        contact_wire__bending_stiffness=bending,
        messenger_wire__bending_stiffness=bending,
    )
    elements = dict.fromkeys(("contact_wire_element", "messenger_wire_element"), element)
    plain = {"scheme": "generalised-alpha", "residual_flexibility": False, "wire_model": model}
    solver = {"gravity": LIGHT, **plain, **elements}
    return equilibrium.find(load(scenario_data(line, solver=solver)))


def two_beams(bending: float) -> TwoBeams:
    lower, upper = (Wire(PULL, bending / float(green(PULL, axial))) for axial in (14e6, 7.4e6))
    return TwoBeams(6, 60.0, DROPPERS, lower, upper, dropper=1e5, support=5e5, arm=300.0)


def test_simple_line_of_beams(evidence: Evidence) -> None:
    element, exact = 0.25, two_beams(BEAM)
    reference = np.array([exact.lift(x) for x in ALONG])
    ell = exact.lower.rounding
    evidence.below(
        "simple line, cubic elements, worst of 7 places",
        worst(simple_line("hermite", BEAM, element).elasticity(ALONG), reference),
        0.5 * ell / PULL / reference.min() * (element / ell) ** 4 / 720, unit="1",
        reason="as for one beam",
    )  # fmt: skip


@pytest.mark.parametrize("force", [0.0, 0.4, 0.8])
def test_simple_line_of_strings(evidence: Evidence, force: float) -> None:
    carried = 1.1 * LIGHT / float(hooke(PULL, 14e6)) * 10.0
    exact = two_beams(0.0)
    found = simple_line("lumped", 0.0, 2.5)
    reference = np.array([exact.lift(x, force or 1.0, carried if force else np.inf) for x in ALONG])
    reference /= force or 1.0
    if force:
        assert (reference > 1.05 * found.elasticity(ALONG)).sum() >= 3, "droppers are slack"
    name = f"{force} N slacken droppers" if force else "small force"
    evidence.below(
        f"simple line, chains, {name}, worst of 7 places",
        worst(found.elasticity(ALONG, force), reference), 2.5e-8, unit="1",
        reason="exact for chains but for sag, 1.5 % at full weight and so 1.5e-8 at a thousandth",
    )  # fmt: skip
    if force == 0.8:
        x = np.linspace(120.0, 180.0, 121)
        curves = {
            "program, small force": (x, 1e3 * found.elasticity(x)),
            "program, droppers slacken": (x, 1e3 * found.elasticity(x, force)),
            "two strings, small force": (ALONG, [1e3 * exact.lift(place) for place in ALONG]),
            "two strings, droppers slacken": (ALONG, 1e3 * reference),
        }
        labels = {"x": "x, m", "y": "elasticity, mm/N"}
        evidence.figure("span", curves, **labels, title="Elasticity over a span of a simple line")


FAULTS = [
    Fault("tension 0.1 % too high", scaled("wires", "tension", 1.001),
          test_string_of_cubic_elements),
    Fault("tension 0.1 % too high, chain", scaled("segments", "tension", 1.001),
          test_string_of_point_masses),
    Fault("EI 1 % too high", scaled("wires", "EI", 1.01), test_beam),
    Fault("EI 1 % too high", scaled("wires", "EI", 1.01), test_simple_line_of_beams),
    Fault("one dropper 1 % too soft", scaled("links", "stiffness", 0.99, [14]),
          test_simple_line_of_strings, force=0.0),
    Fault("arms and supports 1 % too stiff", scaled("springs", "stiffness", 1.01),
          test_simple_line_of_strings, force=0.0),
    Fault("wires 0.1 % too light: droppers slacken earlier", scaled("segments", "mass", 0.999),
          test_simple_line_of_strings, force=0.8),
]  # fmt: skip
