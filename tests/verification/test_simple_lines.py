"""Trolley wires, bridles and conductor rails against closed forms."""

import re
from math import cos, pi, sqrt
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import arcless
from arcless import report
from arcless.model import load
from arcless.simulate import StaticsResult
from tests.support.line_types import scenario_data
from tests.support.simple_lines import bridle_data, rail_data, trolley_data

GUIDE = Path(__file__).parents[2] / "docs" / "guide" / "simple-lines.md"
FINE = {"solver__contact_wire_element": 0.5, "solver__messenger_wire_element": 0.5}
STAGGER = {"geometry__stagger_contact_wire": [0.2, -0.2]}
GRAVITY = 9.81


def rest_of(line: dict[str, Any], **changes: Any) -> StaticsResult:
    return arcless.statics(load(scenario_data(line, **changes)))


@pytest.mark.parametrize("model", ["hermite", "lumped"])
def test_a_trolley_wire_sags_as_a_string_that_turns_at_its_supports(model: str) -> None:
    """z = w L²/8T less what the bending stiffness takes at the supports.

    There the slope w L/2T begins as 1 − exp(−s/ℓ), ℓ² = EI/T: less by w L ℓ/2T, but for w ℓ²/T. The
    wire is longer than its weight was measured on by T/EA.
    """
    found = rest_of(trolley_data(), **FINE, solver__wire_model=model)
    weight, span, tension, bending = 1.1 * GRAVITY, 40.0, 12e3, 130.0
    length = sqrt(bending / tension)
    sag = weight / tension * (span**2 / 8 - span * length / 2 + length**2)
    sag *= 1 - tension / 14e6
    # Elements of 0.5 m and two of 0.2 m, not 0.1 m: 0.03 mm; segments bend within their length.
    assert found.contact_wire_sag_m == pytest.approx(
        sag, abs={"hermite": 5e-5, "lumped": 6e-4}[model]
    )
    # The design holds it at its height at every support.
    heights = [support["contact_wire_height_m"] for support in found.supports]
    np.testing.assert_allclose(heights, 5.5, atol=1e-7)
    inner = [support["contact_support_force_N"] for support in found.supports[2:-2]]
    np.testing.assert_allclose(inner, weight * span * (1 - tension / 14e6), rtol=1e-3)


def test_elasticity_of_a_trolley_wire() -> None:
    """L/4T in the middle, less 3ℓ/4T: bending takes ℓ/2T at the force and ℓ/8T at either side of
    both supports, which give 1/2k together. At a support 1/(k + 2T/L).
    """
    found = rest_of(trolley_data(), **FINE)
    span, tension, stiffness = 40.0, 12e3, 5e5
    length = sqrt(130.0 / tension)
    middle = (span - 3 * length) / (4 * tension) + 1 / (2 * stiffness)
    e = np.array(found.elasticity_m_per_N)
    # Elements of 0.5 m where the kink below the force is 0.1 m long.
    assert e[len(e) // 2] == pytest.approx(middle, rel=2e-3)
    assert e[0] == pytest.approx(1 / (stiffness + 2 * tension / span), rel=1e-3)


@pytest.mark.parametrize("difference", [-25.0, 30.0])
def test_tension_between_fixed_ends_follows_the_temperature(difference: float) -> None:
    """Change of state of a cable, H²[H − H₀ + EA (wL)²/24H₀² + EA α Δθ] = EA (wL)²/24, for spans
    that are all alike. Source: Kiessling et al., equation 5.57, as quoted in Bane NOR TRV.
    """
    line = trolley_data(contact_wire__ends="fixed", contact_wire__bending_stiffness=0.0)
    found = rest_of(line, **FINE, as_built__temperature_difference=difference)
    load_, axial, before = 1.1 * GRAVITY * 40.0, 14e6, 12e3
    sag = axial * load_**2 / 24
    roots = np.roots([1, -before + sag / before**2 + axial * 17e-6 * difference, 0, -sag])
    (expected,) = [root.real for root in roots if abs(root.imag) < 1e-9 and root.real > 0]
    assert found.as_built is not None
    # Green's strain of 1e-3 is stiffer by three times that, of a change by half of the tension.
    assert found.as_built["contact_wire_tension_N"] == pytest.approx(expected, rel=2e-3)
    assert abs(expected / before - 1) > 0.3
    assert "messenger_wire_tension_N" not in found.as_built


def test_clamps_of_bridles_are_at_the_height_of_the_wire() -> None:
    found = rest_of(bridle_data(), **FINE)
    assert [b["support"] for b in found.bridles] == [f"support {n}" for n in range(2, 11)]
    heights = np.array([bridle["clamp_heights_m"] for bridle in found.bridles]) - 5.5
    # Alike on both sides: off by the second order of the slopes, 0.12²/2 of a rise of 0.6 m.
    np.testing.assert_allclose(heights[2:-2], 0.0, atol=1e-3)
    # Next to an anchor one side carries w a/2 more: less than |R₁ − R₂| a/2T.
    unlike = 0.5 * 1.1 * GRAVITY * 5.0 * 5.0 / (2 * 12e3)
    assert abs(heights[[0, -1]]).max() < unlike + 1e-3
    # Rise R a/T_b + w_b a²/2T_b, with half of a span, the clamp and half of the arm on each clamp.
    force = 0.5 * 1.1 * GRAVITY * 40.0 + 0.4 * GRAVITY + 0.25 * GRAVITY
    rise = force * 5.0 / 2e3 + 0.3 * GRAVITY * 25.0 / 4e3
    assert found.bridles[4]["hangs_at_m"] == pytest.approx(5.5 + rise, abs=1e-6)


@pytest.mark.parametrize(
    "changes",
    [{"bridle__tension": 1e3}, {"bridle__tension": 11.5e3}, {"bridle__length": 30.0}],
    ids=["loose", "nearly all of the tension", "long"],
)
def test_unusual_bridles_are_found_from_a_cold_start(changes: dict[str, Any]) -> None:
    found = rest_of(bridle_data(**changes))
    heights = np.array([bridle["clamp_heights_m"] for bridle in found.bridles[2:-2]]) - 5.5
    rises = np.array([bridle["hangs_at_m"] for bridle in found.bridles[2:-2]]) - 5.5
    # The second order of the slopes, of a rise of up to 1.9 m.
    slope = rises.max() / (0.5 * changes.get("bridle__length", 10.0))
    assert abs(heights).max() < max(1e-3, 0.5 * slope**2 * rises.max())


@pytest.mark.parametrize("stagger", [{}, STAGGER], ids=["straight", "staggered"])
def test_forces_balance_at_the_clamps_of_a_bridle(stagger: dict[str, Any]) -> None:
    limp = bridle_data(contact_wire__bending_stiffness=0.0, **stagger)
    found = rest_of(limp, solver__wire_model="lumped").equilibrium
    mesh, points = found.mesh, found.positions
    nodes, floats = mesh.parts["segments"]
    tension, rest = found.arrays["wire_tension"], found.arrays["wire_rest_length"]
    for bridle in mesh.bridles:
        for clamp in (bridle.nodes[0], bridle.nodes[-1]):
            rows = np.flatnonzero((nodes == clamp).any(axis=1))
            far = np.where(nodes[rows, 0] == clamp, nodes[rows, 1], nodes[rows, 0])
            away = points[far] - points[clamp]
            pull = tension[rows, None] * away / np.linalg.norm(away, axis=1)[:, None]
            weight = GRAVITY * (0.4 + 0.5 * np.sum(floats[rows, 2] * rest[rows]))
            # Balanced to what the statics calls rounding: 8 ε · 400 m · EA/L, 1e-5 N here.
            np.testing.assert_allclose(pull.sum(axis=0), [0.0, 0.0, weight], atol=2e-5)
            along = sorted(np.abs(pull[:, 0]))
            np.testing.assert_allclose(along, [2e3, 10e3, 12e3], atol=2e-5)


def test_bridles_soften_the_supports() -> None:
    plain, bridled = rest_of(trolley_data()), rest_of(bridle_data())
    assert min(bridled.elasticity_m_per_N) > 50 * min(plain.elasticity_m_per_N)
    assert bridled.elasticity_nonuniformity < 0.7 < plain.elasticity_nonuniformity


@pytest.mark.parametrize("model", ["hermite", "lumped"])
def test_a_rail_sags_as_a_continuous_beam(model: str) -> None:
    """w L⁴/384 EI in every span far from the ends, and no tension from anywhere."""
    found = rest_of(rail_data(), **FINE, solver__wire_model=model)
    sag = 8.0 * GRAVITY * 8.0**4 / (384 * 2e5)
    # Differences for derivatives: clamped beam of N = 16 segments, (1 + 8/N²) of its sag.
    sag *= {"hermite": 1.0, "lumped": 1.0 + 8.0 / 16**2}[model]
    assert found.contact_wire_sag_m == pytest.approx(sag, rel=1e-3)
    tension = found.equilibrium.arrays["wire_tension"]
    # The shear of half a span, 314 N, times the slope there, 4e-3.
    assert abs(tension).max() < 1.6
    assert found.wave_speed is None


def test_a_rail_under_a_force_is_a_beam_on_many_supports() -> None:
    """P in the middle of a span: L³/192 EI clamped, and L/4 times the turn of both supports.

    The spans beyond turn back as 2√3 EI/L (three-moment equation, neighbours by −(2 − √3)), the
    span itself as 2 EI/L; the clamped moment is P L/8: θ = P L²/(16 (1 + √3) EI).
    """
    found = rest_of(rail_data(), **FINE)
    e = found.elasticity_m_per_N
    beam = 8.0**3 / 2e5 * (1 / 192 + 1 / (64 * (1 + sqrt(3))))
    # The sag adds an arch of 1e-2: with it the force is off by its square.
    assert e[len(e) // 2] == pytest.approx(beam, rel=1e-3)


def test_a_rail_on_springs_follows_the_three_moment_equation() -> None:
    """Settling supports: M₋ + 4M + M₊ = 6EI/L² (z₋ − 2z + z₊) + load term, k z = jump of shear."""
    count, span, bending, stiffness = 30, 8.0, 2e5, 6e4
    found = rest_of(rail_data(contact_support__vertical_stiffness=stiffness), **FINE)
    e = found.elasticity_m_per_N
    assert e[len(e) // 2] == pytest.approx(
        middle_of_beam_on_springs(count, span, bending, stiffness), rel=1e-3
    )


def middle_of_beam_on_springs(count: int, span: float, bending: float, k: float) -> float:
    """Deflection under a unit force in the middle span; slope-deflection, anchors at both ends.

    Unknowns are height and slope at each support; a span of beam couples them by its stiffness
    12, 6, 4, 2 EI/L^n, and the loaded one adds the forces ½ and the moments ± L/8 of clamped ends.
    """
    a, b, c = 12 * bending / span**3, 6 * bending / span**2, bending / span
    beam = np.array([[a, b, -a, b], [b, 4 * c, -b, 2 * c], [-a, -b, a, -b], [b, 2 * c, -b, 4 * c]])
    size = 2 * (count + 1)
    matrix, force = np.zeros((size, size)), np.zeros(size)
    for i in range(count):
        matrix[2 * i : 2 * i + 4, 2 * i : 2 * i + 4] += beam
    for i in range(1, count):
        matrix[2 * i, 2 * i] += k
    loaded = 2 * ((count - 1) // 2)
    force[loaded : loaded + 4] += [0.5, span / 8, 0.5, -span / 8]
    free = [i for i in range(size) if i not in {0, size - 2}]
    found = np.zeros(size)
    found[free] = np.linalg.solve(matrix[np.ix_(free, free)], force[free])
    z0, t0, z1, t1 = found[loaded : loaded + 4]
    return float(0.5 * (z0 + z1) + span / 8 * (t0 - t1) + span**3 / (192 * bending))


def test_first_frequency_of_a_rail_on_supports() -> None:
    """All spans swing against their neighbours, each as a hinged beam: π/2L² √(EI/m)."""
    found = rest_of(rail_data(), **FINE)
    first = pi / (2 * 8.0**2) * sqrt(2e5 / 8.0)
    # Supports of 1e10 N/m; the sag's arch stiffens it by less.
    assert found.natural_frequencies_Hz[0] == pytest.approx(first, rel=1e-3)


def test_a_heated_rail_between_fixed_ends_carries_the_euler_load_of_its_spans() -> None:
    """π² EI/L²: neighbours bend to opposite sides, each as a hinged bar."""
    fixed = rail_data(contact_wire__ends="fixed", contact_wire__thermal_expansion=23e-6)
    found = rest_of(fixed, as_built__temperature_difference=30.0)
    assert found.as_built is not None
    euler = pi**2 * 2e5 / 8.0**2
    # From below, as far as the sag, which bends all spans alike, is small beside the buckles; held
    # straight it would carry EA α Δθ, three times as much.
    assert found.as_built["contact_wire_tension_N"] == pytest.approx(-euler, rel=1e-2)


def printed(name: str) -> list[float]:
    """Return the numbers of a row of the guide's tables."""
    (row,) = re.findall(rf"\| {re.escape(name)} \| (.*) \|", GUIDE.read_text(encoding="utf-8"))
    return [float(value) for value in row.split(" | ")]


def test_the_guide_prints_what_is_found(at_rest: Any) -> None:
    plain = {"line.bridle": None, "line.steady_arm": {"kind": "none"}}
    wires = [at_rest("trolley-bridles-60", plain), at_rest("trolley-bridles-60")]
    rails = [at_rest(f"conductor-rail-{number}-120") for number in (1, 2, 3)]
    rows = [
        ("sag, mm", [1e3 * f.contact_wire_sag_m for f in wires], 0.51),
        ("highest elasticity, mm/N", [1e3 * max(f.elasticity_m_per_N) for f in wires], 0.0051),
        ("lowest elasticity, mm/N", [1e3 * min(f.elasticity_m_per_N) for f in wires], 0.0051),
        ("sag in the middle span, mm", [1e3 * f.contact_wire_sag_m for f in rails], 0.051),
        ("highest elasticity, µm/N", [1e6 * max(f.elasticity_m_per_N) for f in rails], 0.051),
        ("lowest elasticity, µm/N", [1e6 * min(f.elasticity_m_per_N) for f in rails], 0.0051),
        ("first natural frequency, Hz", [f.natural_frequencies_Hz[0] for f in rails], 0.0051),
    ]
    for name, values, last_digit in rows:
        np.testing.assert_allclose(printed(name), values, atol=last_digit)


@pytest.mark.parametrize("model", ["hermite", "lumped"])
@pytest.mark.parametrize(
    "data", [trolley_data, bridle_data, rail_data], ids=["plain", "bridle", "rail"]
)
@pytest.mark.parametrize("staggered", [False, True], ids=["straight", "staggered"])
def test_a_pantograph_runs_below(data: Any, staggered: bool, model: str) -> None:
    settings = {"solver__scheme": "trapezoidal", "output__energy": "always", "speed": 20.0}
    # A rail is led from side to side over many spans.
    pattern = [0.2 * cos(2 * pi * i / 12) for i in range(12)] if data is rail_data else [0.2, -0.2]
    line = data(geometry__stagger_contact_wire=pattern if staggered else [0.0])
    result = arcless.run(load(scenario_data(line, solver__wire_model=model, **settings)))
    force = result.dataset["contact_force"].values
    # The masses of the pantograph move freely: the mean is the static force but for the base.
    assert force.mean() == pytest.approx(120.0, rel=0.05)
    assert abs(result.dataset.attrs["energy_residual_relative"]) < 1e-9
    assert result.dataset.sizes.get("dropper", 0) == 0
    assert "messenger_wire_node" not in result.dataset.dims
    assert ("bridle_node" in result.dataset.dims) == ("bridle" in line)
    html = report.html(result)
    assert ("bridles" in html) == ("bridle" in line)
    assert "messenger wire" not in html.split("<script")[0]
    assert (result.assessment.to_dict()["slack_droppers_max"] or 0) == 0


def test_a_result_without_droppers_is_read_again(tmp_path: Any) -> None:
    result = arcless.run(load(scenario_data(trolley_data(), speed=20.0)))
    result.save(tmp_path / "result.nc")
    again = arcless.results.open(tmp_path / "result.nc")
    assert again.scenario == result.scenario
    assert again.assessment.to_dict() == result.assessment.to_dict()
