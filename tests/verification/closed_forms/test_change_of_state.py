"""Change of state of a wire: temperature and ice

A wire is tensioned, then warmed or loaded. Its unstretched length L₀ becomes L₀ (1 + α Δθ), its
weight w₁ per metre of that; it hangs in the elastic catenary of `sag`, whose horizontal tension H₁
follows from what holds its end:

    fixed ends          x(L₀ (1 + α Δθ), w₁, H₁) = L
    constant force      H₁ = H₀, and the end moves by u = x(…) − L
    tensioning spring   H₁ = H₀ − k u

For a taut wire between fixed ends this is the change-of-state equation of every line builder, cubic
in T₁, with P the weight of the span,

    T₁² [T₁ − T₀ + EA P₀²/(24 T₀²) + EA α Δθ] = EA P₁²/24

Source: Kiessling et al., Contact Lines for Electric Railways, equation 5.57, second hand by the
rules of Bane NOR; derived again here. The first form is solved by bisection without any elements
(`tests/support/catenary.py`); cubic elements stretch by Green's strain, chains by Hooke's law.

The program is asked by a scenario: one span of 60 m, 1.1 kg/m, EA = 14 MN, EI = 0, tensioned to
12 kN, α = 17·10⁻⁶/K, elements of 0.5 m, then `as_built` with a temperature difference and ice.
Tensions go from 4.3 to 17 kN.
"""

from typing import Any

import numpy as np
import pytest

from tests.support.catenary import Law, green, hooke, of_tension, with_ends
from tests.support.evidence import Evidence
from tests.support.faults import Fault, expansion, misbuilt, scaled
from tests.support.one_wire import AXIAL, GRAVITY, MASS, SPAN, TENSION, WEIGHT, one_wire

EXPANSION = 17e-6
ELEMENT = 0.5
# Warmer by (K), ice (kg/m).
STATES = {"cold": (-25.0, 0.0), "warm": (40.0, 0.0), "hot": (80.0, 0.0), "icy": (-5.0, 1.5)}
FIXED, HELD = ({"contact_wire__ends": kind} for kind in ("fixed", "constant_force"))
SPRING = 5e4
SPRUNG = {"contact_wire__ends": "spring", "contact_wire__end_stiffness": SPRING}


def changed(state: str, ends: dict[str, Any], model: str) -> Any:
    """Return the equilibrium of the wire in a state."""
    difference, ice = STATES[state]
    built = {"temperature_difference": difference, "ice": {"contact_wire": ice}}
    line = {**ends, "contact_wire__thermal_expansion": EXPANSION}
    return one_wire(line, wire_model=model, contact_wire_element=ELEMENT, as_built=built)


def exact(state: str, law: Law, stiffness: float | None) -> Any:
    """Return the catenary in a state and the way of its end in m."""
    difference, ice = STATES[state]
    longer = 1.0 + EXPANSION * difference
    weight = WEIGHT / longer + ice * GRAVITY
    before = of_tension(SPAN, WEIGHT, AXIAL, TENSION, law)
    return with_ends(before, longer, weight, stiffness)


def tension_error(ends: dict[str, Any], stiffness: float | None, model: str, law: Law) -> float:
    """Largest relative error of the tension of all elements in all states."""
    errors = []
    for state in STATES:
        found = changed(state, ends, model).arrays
        wire, _ = exact(state, law, stiffness)
        lengths = found["wire_rest_length"]
        assert len(lengths) == SPAN / ELEMENT
        here = wire.tension((np.cumsum(lengths) - 0.5 * lengths) * wire.rest / lengths.sum())
        errors.append(np.abs(found["wire_tension"] / here - 1.0).max())
    return float(max(errors))


CASES = {"fixed ends": (FIXED, None), "tensioning spring": (SPRUNG, SPRING)}


def turn(state: str, stiffness: float | None) -> float:
    """Return by how much the wire turns along one element in a state."""
    wire, _ = exact(state, hooke, stiffness)
    return float(wire.weight * ELEMENT / wire.horizontal)


def chord_error(state: str, stiffness: float | None) -> float:
    """Relative error of the tension of a chain, whose chords are shorter than arcs by (wh/H)²/24.

    The wire was too short by that when it was designed, so the difference is a strain. It meets
    the stiffness of the wire, of its sag and of the spring one behind the other.
    """
    wire, _ = exact(state, hooke, stiffness)
    weight, tension = wire.weight * SPAN, wire.horizontal
    softer = AXIAL * weight**2 / (12 * tension**3) + (
        AXIAL / (stiffness * SPAN) if stiffness else 0
    )
    strain = ((WEIGHT * ELEMENT / TENSION) ** 2 - turn(state, stiffness) ** 2) / 24
    return float(abs(AXIAL / tension * strain / (1 + softer)))


@pytest.mark.parametrize("case", CASES)
def test_tension_of_cubic_elements(evidence: Evidence, case: str) -> None:
    ends, stiffness = CASES[case]
    tensions = {state: exact(state, hooke, stiffness)[0].horizontal for state in STATES}
    limits = [AXIAL / tensions[state] * turn(state, stiffness) ** 4 for state in STATES]
    evidence.below(
        f"worst tension, cubic elements, {case}", tension_error(ends, stiffness, "hermite", green),
        max(limits), unit="1", reason="fourth order: strain (wh/H)⁴, of the softest state, EA/T",
    )  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_tension_of_a_chain(evidence: Evidence, case: str) -> None:
    ends, stiffness = CASES[case]
    evidence.below(
        f"worst tension, chain of point masses, {case}",
        tension_error(ends, stiffness, "lumped", hooke),
        1.1 * max(chord_error(state, stiffness) for state in STATES),
        unit="1",
        reason="chord and arc differ by (wh/H)²/24, which changes with the state; a tenth more",
    )


@pytest.mark.parametrize("model", ["hermite", "lumped"])
def test_way_of_an_end_under_constant_force(evidence: Evidence, model: str) -> None:
    law = {"hermite": green, "lumped": hooke}[model]
    errors = [
        abs(changed(state, HELD, model).end_travel()[0] - exact(state, law, 0.0)[1])
        for state in STATES
    ]
    rounding = 8 * 2.2e-16 * SPAN * AXIAL / ELEMENT * SPAN / AXIAL
    arcs = max(abs((WEIGHT * ELEMENT / TENSION) ** 2 - turn(s, 0.0) ** 2) for s in STATES) / 24
    limit, reason = {
        "hermite": (rounding, "the statics balances to 8 ε L EA/h; that force on a wire of L/EA"),
        "lumped": (1.1 * SPAN * arcs, "chord and arc under ice, L (wh/H)²/24, and a tenth more"),
    }[model]
    evidence.below(
        f"worst way of an end under constant force, {model}", max(errors), limit, unit="m",
        reason=reason,
    )  # fmt: skip


@pytest.mark.parametrize("state", STATES)
def test_the_cubic_equation(evidence: Evidence, state: str) -> None:
    difference, ice = STATES[state]
    before, after = (AXIAL * ((MASS + m) * GRAVITY * SPAN) ** 2 / 24 for m in (0.0, ice))
    linear = before / TENSION**2 - TENSION + AXIAL * EXPANSION * difference
    (tension,) = (r.real for r in np.roots([1.0, linear, 0.0, -after]) if r.real > 0 and not r.imag)
    found = changed(state, FIXED, "hermite").arrays["wire_tension"]
    evidence.close(
        f"tension, {state}, cubic equation", found[len(found) // 2], tension, unit="N",
        relative=2 * max(tension, TENSION) / AXIAL,
        reason="first order in the strain, and Hooke's law: each leaves out about T/EA",
    )  # fmt: skip


FAULTS = [
    Fault("α 1 % too high", expansion(1.01), test_the_cubic_equation, state="hot"),
    Fault("α 1 % too high", expansion(1.01), test_tension_of_a_chain, case="fixed ends"),
    Fault("α 1 % too high", expansion(1.01), test_way_of_an_end_under_constant_force,
          model="hermite"),
    Fault("mass per metre as if still cold",
          misbuilt("mass", lambda mass: mass * (1.0 + 17e-6 * 80.0)),
          test_tension_of_cubic_elements, case="fixed ends"),
    Fault("ice 1 % too light", misbuilt("mass", lambda mass: mass - 0.01 * 1.5 * (mass > 2.0)),
          test_way_of_an_end_under_constant_force, model="lumped"),
    Fault("EA 1 % too high, wires", scaled("wires", "EA", 1.01), test_tension_of_cubic_elements,
          case="fixed ends"),
    Fault("EA 1 % too high, segments", scaled("segments", "EA", 1.01), test_tension_of_a_chain,
          case="fixed ends"),
    Fault("spring 1 % too soft", scaled("springs", "stiffness", 0.99),
          test_tension_of_cubic_elements, case="tensioning spring"),
]  # fmt: skip
