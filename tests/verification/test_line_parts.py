"""Masses, inserts, midpoint anchors and tensioning springs against closed forms."""

from math import atan2, pi, sin, sqrt
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.model import load
from arcless.simulate import StaticsResult
from tests.support.line_types import compound_data, scenario_data, stitched_data
from tests.support.simple_lines import rail_data, trolley_data

FINE = {"solver__contact_wire_element": 0.5, "solver__messenger_wire_element": 0.5}
GRAVITY = 9.81


def at_rest(line: dict[str, Any], **changes: Any) -> StaticsResult:
    return arcless.statics(load(scenario_data(line, **changes)))


def string(**changes: Any) -> dict[str, Any]:
    """Return a trolley wire without bending stiffness over one span of 60 m."""
    return trolley_data(
        contact_wire__bending_stiffness=0.0,
        span_types__span__length=60.0,
        spans=[{"type": "span"}],
        **changes,
    )


ONE_SPAN = {
    "travel": {"start": 10.0, "end": 50.0},
    "analysis": {"from": 20.0, "to": 40.0},
}


@pytest.mark.parametrize("model", ["hermite", "lumped"])
def test_sag_of_a_string_below_a_mass(model: str) -> None:
    """w a b/2T of the wire and m g a b/T L of the mass, a and b to either end."""
    a, b, tension = 25.0, 35.0, 12e3
    heavy = string(point_masses=[{"position": a, "mass": 20.0}])
    found = at_rest(heavy, **ONE_SPAN, **FINE, solver__wire_model=model).equilibrium
    points = found.positions[found.mesh.contact_nodes]
    at_mass = points[np.argmin(abs(points[:, 0] - a)), 2]
    # A stretched wire is lighter by metre.
    wire = 1.1 * GRAVITY * (1 - tension / 14e6)
    sag = wire * a * b / (2 * tension) + 20.0 * GRAVITY * a * b / (tension * (a + b))
    # The next terms are of the order of the squared slope, 3e-4.
    assert 5.5 - at_mass == pytest.approx(sag, rel=1e-3)


def test_an_insert_is_a_piece_of_another_wire() -> None:
    """Frequencies of a string of two densities: tan(k₁ a)/√(μ₁) = −tan(k₂ b)/√(μ₂)."""
    length, tension = 60.0, 12e3
    insert = {
        "position": 50.0,
        "length": 20.0,
        "mass": 20.0 * 4.4,
        "axial_stiffness": 1e9,
        "bending_stiffness": 0.0,
    }
    line = string(contact_wire__ends="fixed", contact_wire__axial_stiffness=1e9, inserts=[insert])
    found = at_rest(line, **ONE_SPAN, **FINE, solver__gravity=1e-3)
    for frequency in found.natural_frequencies_Hz[:6]:
        omega = 2 * pi * frequency
        k1, k2 = (omega * sqrt(density / tension) for density in (1.1, 4.4))
        a, b = length - 20.0, 20.0
        left = sin(k1 * a) * k2 * np.cos(k2 * b) + sin(k2 * b) * k1 * np.cos(k1 * a)
        # Its phase instead of its size: how far the two waves are from meeting without a kink.
        off = atan2(left, k1 + k2)
        assert off == pytest.approx(0.0, abs=1e-3)


@pytest.mark.parametrize("model", ["hermite", "lumped"])
def test_a_line_with_all_of_them_runs(model: str) -> None:
    line = compound_data(
        point_masses=[
            {"name": "feeder clamp", "wire": wire, "position": 131.3, "mass": 3.0}
            for wire in ("contact_wire", "messenger_wire", "auxiliary_wire")
        ],
        inserts=[
            {
                "name": "section insulator",
                "position": 150.0,
                "length": 1.6,
                "mass": 12.0,
                "axial_stiffness": 2e7,
                "bending_stiffness": 3e3,
            }
        ],
    )
    result = arcless.run(load(scenario_data(line, solver__wire_model=model)))
    plain = arcless.run(load(scenario_data(compound_data(), solver__wire_model=model)))
    time, x = result.dataset["time"].values, result.dataset["position"].values[:, 0]
    passed = (x > 148.0) & (x < 154.0)
    forces = [r.dataset["contact_force"].values[passed, 0] for r in (result, plain)]
    # 7.5 kg/m in place of 1.1 kg/m: the head hits it.
    assert np.abs(forces[0] - forces[1]).max() > 30.0
    assert time.size == plain.dataset["time"].size
    before = x < 110.0
    forces = [r.dataset["contact_force"].values[before, 0] for r in (result, plain)]
    # 20 m ahead of the masses, only waves reach here: 0.2 s at 117 m/s.
    np.testing.assert_allclose(*forces, atol=3.0)


HELD = {"midpoint_anchor": {"stiffness": 1e7}}


@pytest.mark.parametrize("model", ["hermite", "lumped"])
def test_wires_move_away_from_their_midpoint_anchor(model: str) -> None:
    """By α Δθ x to both sides, while tension and heights stay."""
    both = {f"{wire}__ends": "constant_force" for wire in ("contact_wire", "messenger_wire")}
    line = stitched_data(stitch_wire=None, **both, **HELD)
    cold, warm = (
        at_rest(line, solver__wire_model=model, as_built__temperature_difference=d)
        for d in (0.0, 40.0)
    )
    for wire in ("contact_nodes", "messenger_nodes"):
        nodes = getattr(warm.equilibrium.mesh, wire)
        here, there = (r.equilibrium.positions[nodes] for r in (cold, warm))
        moved, x = there[:, 0] - here[:, 0], here[:, 0] - 180.0
        # Along the wire, which the sag makes longer than the track by 1e-3; droppers lean.
        np.testing.assert_allclose(moved, 17e-6 * 40.0 * x, atol=3e-4)
        # To rounding the same on both sides: the solver stops at 1e-5 N of EA.
        np.testing.assert_allclose(moved, -moved[::-1], atol=1e-9)
        assert abs(moved[len(moved) // 2]) < 1e-9
    assert warm.as_built is not None
    tensions = [warm.as_built[f"{wire}_wire_tension_N"] for wire in ("contact", "messenger")]
    np.testing.assert_allclose(tensions, 15e3, rtol=2e-3)


def test_without_an_anchor_the_left_end_stays() -> None:
    line = trolley_data()
    warm = at_rest(line, as_built__temperature_difference=40.0)
    held = at_rest(trolley_data(**HELD), as_built__temperature_difference=40.0)
    way = 17e-6 * 40.0 * 400.0
    assert warm.as_built is not None
    assert held.as_built is not None
    # The wire is 5e-4 longer than the track, and stretched by 9e-4.
    assert warm.as_built["contact_wire_end_travel_m"] == pytest.approx(way, rel=2e-3)
    assert held.as_built["contact_wire_end_travel_m"] == pytest.approx(way / 2, rel=2e-3)
    assert held.as_built["contact_wire_start_travel_m"] == pytest.approx(-way / 2, rel=2e-3)
    assert "contact_wire_start_travel_m" not in warm.as_built
    assert "messenger_wire_start_travel_m" not in held.as_built


def test_the_anchor_stands_at_the_support_that_is_named() -> None:
    held = {"midpoint_anchor": {"stiffness": 1e7, "support": 3}}
    warm = at_rest(trolley_data(**held), as_built__temperature_difference=40.0)
    assert warm.as_built is not None
    way = 17e-6 * 40.0 * 320.0
    assert warm.as_built["contact_wire_end_travel_m"] == pytest.approx(way, rel=2e-3)


@pytest.mark.parametrize("difference", [-30.0, 30.0])
@pytest.mark.parametrize("stiffness", [2e3, 2e4])
def test_tension_of_a_spring_follows_the_temperature(stiffness: float, difference: float) -> None:
    """T − T₀ = k (u₀ − u): the spring gives what the wire takes.

    The end moves by u = L (α Δθ + (T − T₀)/EA − (wl)²/24 (1/T² − 1/T₀²)), l the span: thermal and
    elastic strain, and what goes into the sag. Without sag, ΔT = −α Δθ L/(1/k + L/EA).
    """
    ends = {"contact_wire__ends": "spring", "contact_wire__end_stiffness": stiffness}
    line = trolley_data(contact_wire__bending_stiffness=0.0, **ends)
    found = at_rest(line, **FINE, as_built__temperature_difference=difference).as_built
    assert found is not None
    length, axial, before, load_ = 400.0, 14e6, 12e3, 1.1 * GRAVITY * 40.0

    def imbalance(tension: float) -> float:
        sag = load_**2 / 24 * (1 / tension**2 - 1 / before**2)
        strain = 17e-6 * difference + (tension - before) / axial - sag
        return tension - before + stiffness * length * strain

    low, high = 2e3, 40e3
    for _ in range(60):  # halves the range down to rounding
        middle = 0.5 * (low + high)
        low, high = (middle, high) if imbalance(middle) < 0 else (low, middle)
    # Green's strain is stiffer by three times 1e-3; the stretched wire grows a little more.
    assert found["contact_wire_tension_N"] - before == pytest.approx(low - before, rel=1e-2)
    way = found["contact_wire_end_travel_m"]
    expected = (before - found["contact_wire_tension_N"]) / stiffness
    # The spring carries the horizontal part, less than the tension by half its squared slope.
    assert way == pytest.approx(expected, abs=6.0 / stiffness)
    plain = -17e-6 * difference * length / (1 / stiffness + length / axial)
    assert (low - before) / plain == pytest.approx(1.0, abs=0.1)


def test_a_spring_without_change_is_a_constant_force() -> None:
    springs = {"contact_wire__ends": "spring", "contact_wire__end_stiffness": 5e3}
    one, other = at_rest(trolley_data()), at_rest(trolley_data(**springs))
    heights = [r.equilibrium.positions[:, 2] for r in (one, other)]
    # The design hands both the same lengths; the equilibrium stops at 1e-5 N.
    np.testing.assert_allclose(*heights, atol=1e-8)


@pytest.mark.parametrize("data", [trolley_data, rail_data], ids=["trolley", "rail"])
def test_a_pantograph_runs_below_an_anchored_line(data: Any) -> None:
    result = arcless.run(load(scenario_data(data(**HELD), speed=20.0)))
    assert result.dataset["contact_force"].values.mean() == pytest.approx(120.0, rel=0.05)
