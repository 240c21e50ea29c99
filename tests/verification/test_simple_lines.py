"""Trolley wires, bridles and conductor rails against closed forms."""

import re
from math import cos, pi
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


def test_bridles_soften_the_supports() -> None:
    plain, bridled = rest_of(trolley_data()), rest_of(bridle_data())
    assert min(bridled.elasticity_m_per_N) > 50 * min(plain.elasticity_m_per_N)
    assert bridled.elasticity_nonuniformity < 0.7 < plain.elasticity_nonuniformity


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
