"""Heights of the contact wire: gradients in a line file, and heights measured on site."""

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from arcless.errors import ModelError
from arcless.model import Scenario, load, load_line, scenario_warnings
from arcless.model.advice.gradients import allowed_gradient
from arcless.model.as_built.measured_heights import measured_places
from tests.support.line_types import scenario_data
from tests.support.overlaps import overlap_data

Data = dict[str, Any]


def change(first: int, last: int, height: float) -> Data:
    return {"from_support": first, "to_support": last, "height": height}


def with_changes(data: Data, *changes: Data, **more: Any) -> Data:
    line = load_line(data["line"]).to_dict()
    line["geometry"]["height_changes"] = list(changes)
    return {**data, **more, "line": line}


def refusal(data: Data) -> str:
    with pytest.raises(ModelError) as caught:
        load(data)
    return str(caught.value)


def test_heights_are_linear_on_a_stretch_and_level_elsewhere(data: Data) -> None:
    scenario = load(with_changes(data, change(2, 4, 5.1), change(6, 7, 5.2)))
    spans = len(scenario.line.span_list())
    start = scenario.line.geometry.contact_wire_height
    expected = [start, start, 0.5 * (start + 5.1), 5.1, 5.1, 5.1, 5.2]
    expected += [5.2] * (spans + 1 - len(expected))
    # Round-off of a linear interpolation.
    np.testing.assert_allclose(scenario.line.contact_wire_heights(), expected, rtol=1e-12)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ([change(3, 3, 5)], "height_changes.0.to_support: empty stretch: got support 3 to support"),
        ([change(2, 4, 5), change(3, 5, 5)], "height_changes.1.from_support: stretches overlap or"),
        ([change(2, 99, 5)], "to_support: change of height outside the line: got support 99"),
        ([change(0, 4, 5)], "from_support"),
        ([change(2, 4, -5)], "height: got -5, expected a length"),
        ([{"from_support": 2, "height": 5}], "to_support: missing field"),
    ],
)
def test_changes_that_do_not_fit_are_refused(data: Data, changes: list[Data], message: str) -> None:
    assert message in refusal(with_changes(data, *changes))


def test_what_the_standard_allows() -> None:
    """Rows of the design data, section 4.2 (mark A)."""
    for speed, limits in ((60, (20, 10)), (100, (6, 3)), (101, (4, 2)), (200, (1, 0.5))):
        assert allowed_gradient(speed / 3.6) == limits
    assert allowed_gradient(230 / 3.6) == (0.4, 0.2)


def test_steep_gradients_deserve_a_word(data: Data) -> None:
    length = load(data).line.span_list()[2].length
    gentle = load(data).line.geometry.contact_wire_height + 0.0015 * length
    # 1.5 ‰ at 160 km/h: the gradient passes (2 ‰), the change of it does not (1 ‰).
    scenario = load(with_changes(data, change(3, 4, gentle), speed="160 km/h"))
    words = [text for text in scenario_warnings(scenario) if "gradient" in text]
    assert len(words) == 1
    assert "changes by 1.5 ‰ at support 3; EN 50119 allows 1 ‰ at 160 km/h" in words[0]
    words = [text for text in scenario_warnings(scenario.with_(speed=50)) if "gradient" in text]
    assert "a gradient of 1.5 ‰ in span 3; EN 50119 allows 1 ‰ at 180 km/h" in words[0]
    assert not [t for t in scenario_warnings(scenario.with_(speed=15)) if "gradient" in t]


def test_a_base_spring_over_a_change_of_height_deserves_a_word(data: Data) -> None:
    scenario = load(with_changes(data, change(2, 8, 5.6)))
    stiff = scenario.with_(**{"pantographs.0.model.masses.0.stiffness": 200})
    assert any("base spring of P1 changes its force by" in t for t in scenario_warnings(stiff))
    loose = scenario.with_(**{"pantographs.0.model.masses.0.stiffness": 0})
    assert not any("base spring" in t for t in scenario_warnings(loose))


@pytest.fixture
def surveyed(files: Path) -> Callable[[str], Path]:
    """Write a scenario with a file of measured heights; lines of the good one may be changed."""

    def write(text: str) -> Path:
        (files / "survey.csv").write_text(text, encoding="utf-8")
        path = files / "scenario.yaml"
        given = path.read_text("utf-8") + "as_built:\n  measured_heights: survey.csv\n"
        path.write_text(given, encoding="utf-8")
        return path

    return write


def survey(files: Path, *, skip: int = -1, more: str = "") -> str:
    places = measured_places(load(files / "scenario.yaml").line)
    rows = [f"{x + 0.04:.3f}, 5300" for i, x in enumerate(places) if i != skip]
    return "\n".join(["position [m], height [mm]", *rows, more])


def test_a_survey_is_matched_with_droppers_and_supports(
    files: Path, surveyed: Callable[[str], Path]
) -> None:
    scenario = load(surveyed(survey(files)))
    heights = scenario.as_built.measured_heights
    assert {one.height for one in heights} == {5.3}
    assert scenario.as_built.is_empty, "nothing is changed after the design"
    assert Scenario.model_validate(scenario.to_dict()) == scenario


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"skip": 3}, r"no height measured at span 1 dropper 3: expected a height within 0.1 m of"),
        ({"skip": 0}, r"no height measured at support 1: expected"),
        ({"more": "0.05, 5300"}, r"height of support 1 measured twice: got at 0.04 m and at 0.05"),
        ({"more": "1.0, 5300"}, r"neither dropper nor support: got 1 m, expected a place within"),
        ({"more": "-7, 5300"}, r"height measured outside the line: got -7 m, expected a position"),
        ({"more": "12,"}, r"survey.csv:\d+ \(named in .*\): height: empty cell"),
        ({"more": "12, 53000"}, r"measured_heights.\d+.height: got 53.0, expected"),
    ],
)
def test_surveys_that_do_not_fit_are_refused(
    files: Path, surveyed: Callable[[str], Path], changes: Data, message: str
) -> None:
    with pytest.raises(ModelError) as caught:
        load(surveyed(survey(files, **changes)))
    assert re.search(message, str(caught.value)), str(caught.value)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("position, height mm\n0, 5300\n", "column position: unit missing"),
        ("position m\n0\n", "missing column: got no height"),
        ("position m, height kg\n0, 5\n", "kg is the unit of a mass"),
        ("position m, height m\n0, 5.3\n", "no height measured at span 1 dropper 1, and "),
    ],
)
def test_faulty_survey_files_are_refused(
    surveyed: Callable[[str], Path], text: str, message: str
) -> None:
    with pytest.raises(ModelError) as caught:
        load(surveyed(text))
    assert message in str(caught.value)


def test_given_lengths_and_measured_heights_exclude_each_other(
    files: Path, surveyed: Callable[[str], Path]
) -> None:
    path = surveyed(survey(files))
    line, positions = files / "line.yaml", "positions: [10, 20, 35, 45]"
    given = f"{positions}\n      lengths: [1, 0.8, 0.8, 1]"
    line.write_text(line.read_text("utf-8").replace(positions, given), encoding="utf-8")
    with pytest.raises(ModelError, match="both dropper lengths and measured heights given"):
        load(path)


def test_bridles_have_no_lengths_to_be_found() -> None:
    scenario = load("trolley-bridles-60")
    rows = [{"position": x, "height": 5.5} for x in measured_places(scenario.line)]
    with pytest.raises(ModelError, match="measured heights of a line with bridles"):
        scenario.with_(**{"as_built.measured_heights": rows})


def test_measured_heights_of_an_overlap_would_be_those_of_two_wires() -> None:
    scenario = load(scenario_data(overlap_data()))
    rows = [{"position": x, "height": 5.3} for x in measured_places(scenario.line)]
    with pytest.raises(ModelError, match="measured heights of a line with several tension"):
        scenario.with_(**{"as_built.measured_heights": rows})
