"""Tension of a wire on a spring over its temperature; what moves at counterweights and anchors

A wire of length L in spans l (weight w) is pulled by a spring k at one end, tension T₀ when cold.

* spring: `T − T₀ = k (u₀ − u)`, and the end moves by
  `u = L (α Δθ + (T − T₀)/EA − (wl)²/24 (1/T² − 1/T₀²))`: thermal and elastic strain, and what goes
  into the sag. Solved here by halving a bracket.
* counterweight: the free end moves by `α Δθ L`, with a midpoint anchor both ends by half of that;
  an anchor at support 3 leaves the 320 m beyond it.

Change of state of a cable (Kiessling et al., equation 5.57, as quoted in Bane NOR TRV: second
hand), with a spring in place of a fixed end. Asked as ten spans of 40 m, α = 17e-6 1/K, ± 30 and 40
K, by chains and by cubic elements of 0.5 m.
"""

from typing import Any

import pytest

import arcless
from arcless.model import load
from tests.support.evidence import Evidence
from tests.support.explicit import both_kinds
from tests.support.faults import Fault, expansion, scaled
from tests.support.line_types import scenario_data
from tests.support.simple_lines import trolley_data

WIRES = both_kinds(0.5, 5e-4)
LENGTH, AXIAL, BEFORE, LOAD = 400.0, 14e6, 12e3, 1.1 * 9.81 * 40.0
EXPANSION = 17e-6
HELD = {"midpoint_anchor": {"stiffness": 1e7}}


def as_built(line: dict[str, Any], difference: float, wires: str) -> dict[str, Any]:
    data = scenario_data(line, as_built__temperature_difference=difference, **WIRES[wires])
    found = arcless.statics(load(data)).as_built
    assert found is not None
    return found


@pytest.mark.parametrize("wires", WIRES)
@pytest.mark.parametrize("difference", [-30.0, 30.0])
@pytest.mark.parametrize("stiffness", [2e3, 2e4])
def test_spring(evidence: Evidence, stiffness: float, difference: float, wires: str) -> None:
    ends = {"contact_wire__ends": "spring", "contact_wire__end_stiffness": stiffness}
    line = trolley_data(contact_wire__bending_stiffness=0.0, **ends)
    found = as_built(line, difference, wires)
    case = f"{stiffness / 1e3:g} kN/m, {difference:+g} K, {wires}"
    exact, travel = balanced(stiffness, difference), found["contact_wire_end_travel_m"]
    evidence.close(
        f"travel of the spring, {case}",
        travel,
        (BEFORE - exact) / stiffness,
        unit="m",
        relative=5e-3,
        reason="Green's strain of 1e-3 is stiffer by three times that; the stretched wire grows "
        "by 1e-3 more",
    )
    evidence.close(
        f"tension, {case}",
        found["contact_wire_tension_N"],
        BEFORE - stiffness * travel,
        unit="N",
        absolute=6.0,
        reason="the spring carries the horizontal part, less than the tension by half its squared "
        "slope: 2 N; cubic elements round the kink off at a support: as much again, or twice",
    )


def balanced(stiffness: float, difference: float) -> float:
    """Tension at which spring and wire agree, N."""

    def imbalance(tension: float) -> float:
        sag = LOAD**2 / 24 * (1 / tension**2 - 1 / BEFORE**2)
        strain = EXPANSION * difference + (tension - BEFORE) / AXIAL - sag
        return tension - BEFORE + stiffness * LENGTH * strain

    low, high = 2e3, 40e3
    for _ in range(60):  # halves the range down to rounding
        middle = 0.5 * (low + high)
        low, high = (middle, high) if imbalance(middle) < 0 else (low, middle)
    return low


@pytest.mark.parametrize("wires", WIRES)
def test_travel_of_free_ends(evidence: Evidence, wires: str) -> None:
    longer = "sag and stretch, 5e-4 and 9e-4, stay as they are: below 1e-5 of the travel is left"
    free, held = (as_built(trolley_data(**more), 40.0, wires) for more in ({}, HELD))
    anchor = {"stiffness": 1e7, "support": 3}
    away = as_built(trolley_data(midpoint_anchor=anchor), 40.0, wires)
    assert "contact_wire_start_travel_m" not in free
    way = EXPANSION * 40.0 * LENGTH
    for what, value, expected in (
        ("of the only free end", free["contact_wire_end_travel_m"], way),
        ("of the end, with an anchor in the middle", held["contact_wire_end_travel_m"], way / 2),
        ("of the start, with it", held["contact_wire_start_travel_m"], -way / 2),
        ("of the end, anchor at support 3", away["contact_wire_end_travel_m"], 0.8 * way),
    ):
        evidence.close(
            f"travel {what}, {wires}", value, expected, unit="m", relative=2e-5, reason=longer
        )


STIFF = {"stiffness": 2e4, "difference": 30.0, "wires": "cubic elements"}
FAULTS = [
    Fault("EA 5 % too low", scaled("wires", "EA", 0.95), test_spring, **STIFF),
    Fault("springs 5 % softer", scaled("springs", "stiffness", 0.95), test_spring, **STIFF),
    *(Fault(f"wires expand 1 % too much, {wires}", expansion(1.01), test_travel_of_free_ends,
            wires=wires) for wires in WIRES),
]  # fmt: skip
