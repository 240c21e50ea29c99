"""Objects as a notebook and a prompt show them: cards, short words, names to complete, frames."""

import dataclasses
import inspect
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pydantic
import pytest
from typer.testing import Result as Told

import arcless
from arcless.assess.signals.filter import low_pass, sample_rate_Hz
from arcless.errors import ArclessError, ModelError, OutputError
from tests.interface.conftest import SHORT

# Of what a prompt prints, in characters.
SHORT_WORDS = 200
KINDS = (
    "scenario", "line", "pantograph", "placement", "result", "assessment", "criterion", "statics",
    "resonance speeds", "comparison", "outcome", "realtime", "study", "study status",
    "explanation", "wire stress",
)  # fmt: skip
CARDS = ("scenario", "line", "pantograph", "result", "assessment", "statics", "comparison",
         "study status", "explanation", "wire stress")  # fmt: skip


@cache
def objects() -> Mapping[str, Any]:
    """Return an object of each kind that a user gets."""
    scenario = arcless.load(SHORT)
    result = arcless.run(scenario)
    slower = arcless.run(scenario.with_(speed="90 mph"))
    study = arcless.study.load("speed-sweep")
    status = arcless.study.StudyStatus(
        "sweep", "runs/studies/sweep", False, None, 0, 10, 7, 0, 1, 2, 0, None, None, 1.5,
        {"a <step> failed": 2}, {"0.1.0": 10},
    )  # fmt: skip
    statics = arcless.statics(scenario)
    return {
        "scenario": scenario, "line": scenario.line, "pantograph": scenario.pantographs[0].model,
        "placement": scenario.pantographs[0], "result": result, "assessment": result.assessment,
        "criterion": result.assessment.criteria[0], "statics": statics,
        "resonance speeds": statics.resonance_speeds,
        "comparison": arcless.compare([result, slower]), "outcome": arcless.batch([scenario])[0],
        "realtime": arcless.realtime(scenario), "study": study, "study status": status,
        "explanation": result.explain(), "wire stress": result.wire_stress(exponent=5.0),
    }  # fmt: skip


@pytest.mark.parametrize("kind", KINDS)
def test_a_prompt_shows_a_short_line(kind: str) -> None:
    for text in (repr(objects()[kind]), str(objects()[kind])):
        assert 5 < len(text) < SHORT_WORDS
        assert "\n" not in text


@pytest.mark.parametrize("kind", CARDS)
def test_a_notebook_shows_a_card_that_holds_by_itself(kind: str) -> None:
    html = objects()[kind]._repr_html_()
    made = ElementTree.fromstring(html)
    assert not {one.tag for one in made.iter()} & {"script", "link", "img", "iframe"}
    assert "://" not in html and "url(" not in html and "@import" not in html
    assert len(html) < 40_000  # a notebook is stored with all of its outputs


def test_a_speed_is_shown_as_it_was_typed() -> None:
    assert "90 mph" in objects()["scenario"].with_(speed="90 mph")._repr_html_()
    assert "160 km/h" in objects()["scenario"]._repr_html_()


def test_a_name_from_a_file_is_a_text() -> None:
    name = "<script>alert(1)</script> & more"
    scenario = objects()["scenario"].with_(name=name, **{"pantographs.0.name": "<b>P</b>"})
    result = arcless.run(scenario)
    for one in (
        scenario,
        result,
        result.assessment,
        arcless.compare([result, objects()["result"]]),
    ):
        html = one._repr_html_()
        ElementTree.fromstring(html)
        assert "<script" not in html and "<b>" not in html


def test_the_words_are_those_of_the_terminal(
    arcless: Callable[..., Told], finished: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "400")  # no title is broken into lines
    told = arcless("assess", finished).output
    shown = ElementTree.fromstring(objects()["result"]._repr_html_())
    rows = [["".join(cell.itertext()) for cell in row.iter("td")] for row in shown.iter("tr")]
    titles = {row[0] for row in rows if len(row) == 7}
    assert len(titles) > 5
    for title in titles:
        assert title in told
    for row in rows:
        if len(row) == 7:
            assert row[5].strip("✔✘≈ ") in told


def test_a_run_that_stopped_early_says_so() -> None:
    html = arcless.run(objects()["scenario"], until="70 m")._repr_html_()
    ElementTree.fromstring(html)
    assert "stopped early, arcless.resume continues it; not assessed" in html


@pytest.mark.parametrize("kind", KINDS)
def test_only_documented_names_are_completed(kind: str) -> None:
    one = objects()[kind]
    names = [name for name in dir(one) if not name.startswith("_")]
    assert names
    fields = _fields(type(one))
    for name in names:
        member = inspect.getattr_static(type(one), name, None)
        assert getattr(member, "__doc__", None) or name in fields, f"{kind}: {name}"


def _fields(kind: type) -> set[str]:
    """Return the names of data that the class describes: fields, and those under Attributes."""
    told = {
        word.strip(" ,") for line in (kind.__doc__ or "").splitlines() for word in line.split(",")
    }
    if issubclass(kind, pydantic.BaseModel):
        return {name for name, field in kind.model_fields.items() if field.description} | told
    return set(getattr(kind, "__dataclass_fields__", ())) | told


def test_nothing_of_pydantic_is_completed() -> None:
    clutter = {name for name in dir(pydantic.BaseModel) if not name.startswith("_")}
    for kind in ("scenario", "line", "pantograph", "placement", "study"):
        assert not set(dir(objects()[kind])) & clutter
        assert objects()[kind].model_copy() == objects()[kind]  # which is there all the same


@pytest.mark.parametrize("kind", ["scenario", "line", "pantograph", "placement"])
def test_a_model_that_is_changed_says_how_to(kind: str) -> None:
    with pytest.raises(ModelError, match="cannot be changed") as caught:
        objects()[kind].name = "another"
    assert "with_(" in str(caught.value)
    assert "http" not in str(caught.value)


@pytest.mark.parametrize("call", [arcless.run, arcless.statics, arcless.realtime])
def test_a_name_in_place_of_a_scenario_is_told(call: Callable[[Any], Any]) -> None:
    with pytest.raises(ModelError, match=r"hint: arcless.load\('norway-s25-250'\) gives one"):
        call("norway-s25-250")


def test_the_filtered_force_is_that_of_the_assessment() -> None:
    result = objects()["result"]
    force = result.filtered_force()
    assert (force.dims, force.attrs["units"]) == (("time", "pantograph"), "N")
    data, analysis = result.dataset, result.scenario.analysis
    rate = sample_rate_Hz(data["time"].values)
    expected = low_pass(data["contact_force"].values, rate, analysis.low_pass)
    assert np.array_equal(force.values, expected)
    begin, end = result.assessment.section_m
    one = result.assessment.pantographs[0]
    place = data["position"].values[:, 0]
    inside = force.values[(place >= begin) & (place <= end), 0]
    # Ends of the section may count one sample more or less, of thousands.
    assert inside.mean() == pytest.approx(one.mean_force_N, rel=1e-3)
    assert data["contact_force"].attrs["units"] == "N"  # which stays what it was
    assert data["contact_force"].attrs.get("low_pass_Hz") is None


def test_frames_have_what_the_objects_have() -> None:
    result, statics = objects()["result"], objects()["statics"]
    made = result.to_dataframe()
    assert made.index.name == "time [s]"
    assert np.array_equal(made["P1.contact_force_filtered [N]"], result.filtered_force()[:, 0])
    assert len(result.to_dataframe("droppers")) == result.dataset.sizes["dropper"]
    assert len(result.to_dataframe("supports")) == result.dataset.sizes["support"]
    quantities = result.assessment.to_dataframe()
    mean = result.assessment.pantographs[0].mean_force_N
    assert quantities.loc["mean_force_N", "pantograph P1"] == mean
    assert quantities.loc["mean_force_N", "unit"] == "N"
    criteria = result.assessment.to_dataframe("criteria")
    assert list(criteria.index) == [one.name for one in result.assessment.criteria]
    assert list(statics.to_dataframe()["force at rest [N]"]) == [
        one["force_N"] for one in statics.droppers
    ]
    assert len(statics.to_dataframe("supports")) == len(statics.supports)
    elasticity = statics.to_dataframe("elasticity")["elasticity [mm/N]"]
    assert elasticity.max() == 1e3 * max(statics.elasticity_m_per_N)


def test_a_frame_of_a_comparison_has_the_differences() -> None:
    comparison = objects()["comparison"]
    numbers = comparison.to_dataframe().set_index("key")
    one, other = comparison.names
    row = numbers.loc["std_force_N"]
    assert row[f"{other}: difference"] == row[other] - row[one]
    assert list(comparison.to_dataframe("fields")["field"]) == ["speed"]
    assert f"{other}: verdict" in comparison.to_dataframe("criteria")


@pytest.mark.parametrize("kind", ["result", "assessment", "statics", "comparison"])
def test_an_unknown_table_is_told(kind: str) -> None:
    with pytest.raises(OutputError, match="unknown table") as caught:
        objects()[kind].to_dataframe("nothing")
    assert isinstance(caught.value, ArclessError)


def test_a_line_at_rest_is_drawn() -> None:
    drawing = objects()["statics"].plot("elasticity")
    assert drawing.axes[0].get_ylabel() == "elasticity, mm/N"


def test_a_long_name_is_no_long_line() -> None:
    explanation = dataclasses.replace(objects()["explanation"], scenario="name " * 100)
    assert "σ = " in repr(explanation) and len(repr(explanation)) < SHORT_WORDS
