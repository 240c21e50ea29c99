"""Trolley wires, bridles and conductor rails in motion and in files."""

from math import cos, pi
from typing import Any

import pytest

import arcless
from arcless import report
from arcless.model import load
from arcless.simulate import StaticsResult
from tests.support.line_types import scenario_data
from tests.support.simple_lines import bridle_data, rail_data, trolley_data

FINE = {"solver__contact_wire_element": 0.5, "solver__messenger_wire_element": 0.5}
STAGGER = {"geometry__stagger_contact_wire": [0.2, -0.2]}
GRAVITY = 9.81


def rest_of(line: dict[str, Any], **changes: Any) -> StaticsResult:
    return arcless.statics(load(scenario_data(line, **changes)))


def test_bridles_soften_the_supports() -> None:
    plain, bridled = rest_of(trolley_data()), rest_of(bridle_data())
    assert min(bridled.elasticity_m_per_N) > 50 * min(plain.elasticity_m_per_N)
    assert bridled.elasticity_nonuniformity < 0.7 < plain.elasticity_nonuniformity


@pytest.mark.parametrize(
    ("staggered", "model"),
    [(False, "hermite"), (False, "lumped"), (True, "lumped")],
    ids=["straight-hermite", "straight-lumped", "staggered-lumped"],
)
@pytest.mark.parametrize(
    "data", [trolley_data, bridle_data, rail_data], ids=["plain", "bridle", "rail"]
)
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
