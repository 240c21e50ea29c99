"""Resonance speeds: frequencies against closed forms, and runs whose peak over speed they tell."""

from collections.abc import Callable
from math import pi, sqrt
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.model import Scenario, load, load_pantograph
from arcless.model.pantograph.spacing import tsi_spacing
from arcless.model.settings.run_settings import FASTEST_TRAIN
from arcless.pantograph.natural_modes import modes
from arcless.simulate.resonance import Band, ResonanceSpeed
from arcless.simulate.resonance.spans import modes_moved, spans
from arcless.simulate.resonance.speeds import TOO_FAST
from tests.support.line_types import scenario_data
from tests.support.one_wire import MASS, SPAN, TENSION, one_wire
from tests.support.simple_lines import rail_data, trolley_data

Short = Callable[..., Scenario]
MASS_KG, ZETA, LENGTH = 300.0, 0.1, 10.0


def speeds_of(scenario: Scenario, kind: str) -> list[ResonanceSpeed]:
    return [one for one in arcless.resonance_speeds(scenario).speeds if one.kind == kind]


def test_the_middle_of_a_string_moves_its_odd_modes() -> None:
    found = one_wire(gravity=0.0)
    frequency, share = modes_moved(found, 0.5 * SPAN)
    odd = np.array([1, 3, 5])
    strong = share > 0.01
    # Even modes have a node there; the mass is that per metre of the unstretched wire, 0.1 % more.
    np.testing.assert_allclose(
        frequency[strong][:3], odd / (2 * SPAN) * sqrt(TENSION / MASS), rtol=1e-3
    )
    # Of e = L/4T mode n has 8/π²n²; cubic elements lose 0.6 % of e at a kink, of high modes.
    np.testing.assert_allclose(share[strong][:3], 8 / (pi * odd) ** 2, rtol=1e-2)


def test_the_band_of_a_line_is_that_of_its_lowest_frequencies(short: Short) -> None:
    rest = arcless.statics(short())
    span = spans(rest.equilibrium, rest.scenario.line.span_list(), 80.0)[0]
    lowest = rest.natural_frequencies_Hz[:6]  # one mode a span
    # Modes with a node in the middle of this span have no share, so the band may be narrower.
    assert lowest[0] * 0.999 <= span.swing.low <= span.swing.middle <= span.swing.high
    assert span.swing.high <= lowest[-1] * 1.001
    assert span.swing_share > 0.7
    assert span.number == rest.middle_span
    assert span.elasticity.low == min(rest.elasticity_m_per_N)


def test_a_mass_on_the_line_is_an_oscillator() -> None:
    pantograph = load_pantograph(
        {"name": "one", "masses": [{"mass": 20.0, "stiffness": 0.0, "damping": 50.0}]}
    )
    (found,) = modes(pantograph, Band(2e-4, 3e-4, 4e-4), 5e4)
    for f, e in zip((found.frequency.high, found.frequency.middle), (2e-4, 3e-4), strict=True):
        # Rounding of a matrix of one row.
        assert f == pytest.approx(1 / (2 * pi * sqrt(20.0 * (e + 2e-5))), rel=1e-12)
    omega = 2 * pi * found.frequency.middle
    assert found.damping_ratio == pytest.approx(50.0 / (2 * 20.0 * omega), rel=1e-12)  # rounding
    assert found.share == pytest.approx(1.0, rel=1e-12)  # all of the energy, to rounding


def oscillator(speed: float, damping: float) -> Scenario:
    """A mass under a light wire on springs: stiffness that is nearly a cosine over the span."""
    line = trolley_data(
        contact_wire__mass=0.2,
        contact_wire__bending_stiffness=0.0,
        contact_support__vertical_stiffness=2e3,
        span_types__span__length=LENGTH,
        spans=[{"type": "span", "count": 30}],
    )
    mass = {"mass": MASS_KG, "stiffness": 0.0, "damping": damping}
    given: dict[str, Any] = {
        "pantographs": [{"model": {"name": "mass", "masses": [mass]}, "static_force": 50.0}],
        "speed": speed,
        "travel": {"start": 20.0, "end": 270.0},
        "analysis": {"from": 150.0, "to": 250.0},
        "contact": {"law": "rigid"},
        "solver": {"gravity": 0.0, "time_step": 0.01, "contact_wire_element": 0.5},
    }
    return load(scenario_data(line, **given))


def test_the_peak_over_speed_is_at_the_mark() -> None:
    """Force of a mass m on a spring 1/e with e = ē (1 + ε cos Ωt), to first order in ε.

    λ₁/F = ε (r² − 2iζr)/(1 − r² + 2iζr),   r = Ω/ω = v/(f L),   ω² = 1/(m ē),   2ζω = c/m
    """
    still = oscillator(4.0, 0.0)
    marks = speeds_of(still, "span and pantograph")
    mark = next(one for one in marks if one.order == 1)
    damping = 2.0 * ZETA * MASS_KG * 2.0 * pi * (mark.frequency_Hz or 0.0)
    (span,) = spans(arcless.statics(still).equilibrium, still.line.span_list(), 50.0)
    epsilon = span.path[1] / (50.0 * span.elasticity.middle)
    r = np.array([0.8, 0.9, 1.0, 1.1, 1.2])
    sigma = []
    for ratio in r:
        result = arcless.run(oscillator(ratio * mark.speed.middle, damping))
        sigma.append(result.assessment.pantographs[0].std_force_N)
    first = epsilon * abs((r**2 - 2j * ZETA * r) / (1 - r**2 + 2j * ZETA * r)) / sqrt(2) * 50.0
    assert int(np.argmax(sigma)) == 2
    assert 0.1 < epsilon < 0.2
    # Terms of second order are ε of those of first order, 13 %.
    np.testing.assert_allclose(sigma, first, rtol=0.13)


def test_every_mark_follows_its_formula(short: Short) -> None:
    scenario = short()
    found = arcless.resonance_speeds(scenario)
    assert [one.speed.middle for one in found.speeds] == sorted(
        one.speed.middle for one in found.speeds
    )
    for one in found.speeds:
        assert one.speed.low <= one.speed.middle <= one.speed.high
        if one.kind in ("span of the line", "span and pantograph"):
            assert one.frequency_Hz and one.length_m == 50.0 and one.order
            # The formula itself, to rounding.
            assert one.speed.middle == pytest.approx(
                one.frequency_Hz * one.length_m / one.order, rel=1e-12
            )
        if one.kind == "droppers and pantograph":
            assert one.length_m == pytest.approx(10.0, rel=1e-12)  # droppers 10 m apart, rounding
    waves = {one.name: one.speed.middle for one in found.speeds if one.kind == "wave speed"}
    expected = {"contact wire": sqrt(22e3 / 1.35), "messenger wire": sqrt(16e3 / 1.08)}
    assert waves == pytest.approx(
        {**expected, "limit of EN 50119": 0.7 * expected["contact wire"]}, rel=1e-12  # rounding
    )  # fmt: skip


def test_speeds_that_no_train_has_are_left_out_and_that_is_said(short: Short) -> None:
    scenario = short()
    found = arcless.resonance_speeds(scenario)
    (span,) = spans(arcless.statics(scenario).equilibrium, scenario.line.span_list(), 80.0)
    *_, highest = modes(scenario.pantographs[0].model, span.elasticity, 5e4)
    assert highest.frequency.middle * span.length > FASTEST_TRAIN  # once a span: left out
    assert max(one.speed.middle for one in found.speeds) <= FASTEST_TRAIN
    assert speeds_of(scenario, "span and pantograph")
    assert found.notes == (TOO_FAST,)
    assert "576 km/h" in TOO_FAST


def test_statics_tells_them(short: Short) -> None:
    rest = arcless.statics(short())
    told = rest.to_dict()["resonance_speeds"]
    assert told == rest.resonance_speeds.to_dict() == arcless.resonance_speeds(short()).to_dict()
    assert {
        "kind",
        "name",
        "speed_m_s",
        "frequency_Hz",
        "length_m",
        "order",
        "formula",
        "source",
    } <= (set(told["speeds"][0]))


def test_two_pantographs_one_behind_the_other(short: Short, placement: dict[str, Any]) -> None:
    two = short(pantographs=[placement, {**placement, "name": "P2", "distance": 25.0}])
    worst, best = (speeds_of(two, f"spacing, {word}") for word in ("worst", "best"))
    assert {one.order for one in worst} <= {1.0, 2.0, 3.0, 4.0, 5.0, 6.0}
    assert {one.order for one in best} <= {0.5, 1.5, 2.5, 3.5, 4.5, 5.5, 6.5}
    f = worst[0].frequency_Hz
    assert f is not None
    # d/v is whole periods, or half a period more; rounding.
    for one in (*worst, *best):
        assert 25.0 / one.speed.middle * f == pytest.approx(one.order, rel=1e-12)
    assert len(speeds_of(two, "droppers and pantograph")) == len(
        speeds_of(short(), "droppers and pantograph")
    )  # equal pantographs are told once


def test_a_spacing_that_follows_the_speed_has_marks_in_its_own_ranges(
    short: Short, placement: dict[str, Any]
) -> None:
    behind = {**placement, "name": "P2", "distance": "tsi"}
    two = short(pantographs=[placement, behind], speed="60 km/h")
    marks = [one for word in ("worst", "best") for one in speeds_of(two, f"spacing, {word}")]
    f = marks[0].frequency_Hz
    assert f is not None
    # Spacings and orders whose speed f d/n lies in the range in which the rule has this spacing.
    expected = {d for d in (8.0, 15.0, 85.0, 200.0) for n in np.arange(0.5, 7.0, 0.5)
                if tsi_spacing(f * d / n) == d}  # fmt: skip
    assert {one.length_m for one in marks} == expected >= {85.0, 200.0}
    for one in marks:
        assert one.length_m == tsi_spacing(one.speed.middle)
        assert f"{one.length_m:g} m behind P1" in one.name


def test_spans_of_several_lengths_have_speeds_of_their_own(short: Short) -> None:
    data = short().to_dict()
    data["line"]["span_types"]["short"] = {"length": 40.0, "droppers": {"positions": [10.0, 30.0]}}
    data["line"]["spans"] = [{"type": kind, "count": 2} for kind in ("span", "short", "span")]
    found = speeds_of(load(data), "span of the line")
    assert {one.length_m for one in found if one.order == 1} == {40.0, 50.0}


def test_of_many_lengths_three_are_told(short: Short) -> None:
    data = short().to_dict()
    for length in (40.0, 45.0, 55.0, 60.0):
        span = {"length": length, "droppers": {"positions": [10.0, 30.0]}}
        data["line"]["span_types"][f"{length:g}"] = span
        data["line"]["spans"] = [*data["line"]["spans"], {"type": f"{length:g}", "count": 1}]
    found = arcless.resonance_speeds(load(data))
    lengths = {one.length_m for one in found.speeds if one.kind == "span of the line"}
    assert lengths == {40.0, 50.0, 60.0}
    assert any("many lengths" in note for note in found.notes)


def test_lines_without_messenger_wire_or_tension() -> None:
    trolley = arcless.resonance_speeds(load(scenario_data(trolley_data())))
    assert "no messenger wire" in trolley.notes
    assert "no droppers to pass" in trolley.notes
    rail = arcless.resonance_speeds(load(scenario_data(rail_data())))
    assert any("beam without tension" in note for note in rail.notes)
    assert not [one for one in rail.speeds if one.kind == "wave speed"]
    (first,) = [one for one in rail.speeds if one.kind == "span of the line" and one.order == 1]
    # Between hinged and clamped ends of a span of beam: π/2 to 3.56 of √(EI/μ)/L².
    unit = sqrt(2e5 / 8.0) / 8.0**2
    assert pi / 2 * unit * 0.99 <= first.frequency_Hz <= 3.56 * unit


def test_a_table_has_no_natural_frequency(short: Short, placement: dict[str, Any]) -> None:
    model = dict(placement["model"])
    first = {**model["masses"][0], "stiffness": None}
    first["stiffness_table"] = {"elongation": [-1.0, 0.0, 1.0], "force": [-100.0, 0.0, 50.0]}
    model["masses"] = [first, *model["masses"][1:]]
    found = arcless.resonance_speeds(short(pantographs=[{**placement, "model": model}]))
    assert any("masses.0.stiffness_table is no constant" in note for note in found.notes)
    assert not [one for one in found.speeds if "pantograph" in one.kind]
    assert [one for one in found.speeds if one.kind == "span of the line"]


def test_a_pantograph_by_matrices_is_like_its_masses(
    short: Short, placement: dict[str, Any]
) -> None:
    matrices = {
        "mass": [[15.0, 0.0], [0.0, 7.2]],
        "damping": [[100.0, -10.0], [-10.0, 10.0]],
        "stiffness": [[4250.0, -4200.0], [-4200.0, 4200.0]],
        "strip": [0.0, 1.0],
        "preload": [1.0, 0.0],
    }
    model = {"name": "two-masses", "matrices": matrices}
    given = arcless.resonance_speeds(short(pantographs=[{**placement, "model": model}]))
    chain = arcless.resonance_speeds(short())
    for one, other in zip(given.speeds, chain.speeds, strict=True):
        assert one.name == other.name
        # The same matrices, to rounding.
        assert one.speed.middle == pytest.approx(other.speed.middle, rel=1e-12)
