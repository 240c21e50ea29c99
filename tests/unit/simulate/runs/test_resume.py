"""Runs that stop and are resumed: the same bits as whole ones, and refusals."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.errors import ControlError, ModelError, ResultFormatError
from arcless.model import Scenario
from arcless.results import Result
from tests.support.parts import in_parts, unlike

Short = Callable[..., Scenario]


# Schemes, laws and controllers: tests/verification/conservation/test_save_resume.py.
@pytest.mark.parametrize(
    "changes",
    [
        {"output.line_every": 100, "output.contact_every": 3, "contact.law": "rigid"},
        {"pantographs.0.static_force": None, "pantographs.0.mean_force": 85.0},
    ],
    ids=["seldom recorded", "mean force"],
)
def test_parts_are_the_whole_run(short: Short, tmp_path: Path, changes: dict[str, Any]) -> None:
    scenario = short(**changes)
    whole = arcless.run(scenario)
    parts = in_parts(scenario, tmp_path, "70 m", "1.5 s", 199.8)
    assert whole.is_complete
    assert parts.is_complete
    compared, differing = unlike(whole, parts)
    assert compared > 1000
    assert differing == 0
    assert parts.assessment.to_dict()["criteria"] == whole.assessment.to_dict()["criteria"]


def test_a_part_is_the_beginning_of_the_whole(short: Short, run: Callable[..., Result]) -> None:
    whole, part = run(), arcless.run(short(), until="100 m")
    facts = part.metadata["state"]
    assert not part.is_complete
    step = float(part.dataset["speed"][0]) * short().time_step_s
    assert 100.0 <= facts["position_m"] < 100.0 + step
    assert facts["step"] == part.metadata["steps"] == len(part.dataset["time"])
    assert 0 < facts["step"] < whole.metadata["steps"]
    there = whole.dataset["contact_force"].values[: facts["step"]]
    np.testing.assert_array_equal(part.dataset["contact_force"].values, there)
    assert part.metadata["simulated_time_s"] == facts["step"] * short().time_step_s


def test_the_end_is_the_whole_run(short: Short, run: Callable[..., Result]) -> None:
    end = run().metadata["simulated_time_s"]
    assert unlike(run(), arcless.run(short(), until=f"{end} s"))[1] == 0


@pytest.mark.parametrize("until", ["1 km", "1 h", "100 s"])
def test_beyond_the_end_is_refused(short: Short, until: str) -> None:
    with pytest.raises(ModelError, match="until"):
        arcless.run(short(), until=until)


@pytest.mark.parametrize("until", ["5 kN", "soon", "50 m", "-1 s", "0 s", float("nan")])
def test_no_place_to_stop_is_refused(short: Short, until: str | float) -> None:
    with pytest.raises(ModelError, match="until"):
        arcless.run(short(), until=until)


@pytest.fixture(scope="module")
def part(short: Short, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the file of a run that stopped at 100 m."""
    file = tmp_path_factory.mktemp("part") / "part.nc"
    arcless.run(short(), until="100 m").save(file)
    return file


def told(result: Result, **options: Any) -> str:
    with pytest.raises(ResultFormatError) as caught:
        arcless.resume(result, **options)
    return str(caught.value)


def test_a_complete_run_cannot_go_on(run: Callable[..., Result]) -> None:
    assert "holds no state" in told(run())


def test_it_does_not_run_backwards(part: Path) -> None:
    with pytest.raises(ModelError, match="already there"):
        arcless.resume(arcless.open(part), until="90 m")


def test_another_version_or_format_is_refused(part: Path) -> None:
    other = arcless.open(part)
    other.dataset.attrs["arcless_version"] = "0.0.9"
    assert "version 0.0.9" in told(other)
    other = arcless.open(part)
    other.dataset.attrs["state"] = other.dataset.attrs["state"].replace("state/2", "state/7")
    assert "arcless-state/7" in told(other)


def test_a_changed_scenario_or_line_is_refused(part: Path) -> None:
    good = arcless.open(part)
    changed = Result(good.dataset, good.scenario.with_(speed="150 km/h"))
    assert "not the one that the run began with" in told(changed)
    facts = good.metadata["state"] | {"line": "0" * 64}
    good = arcless.open(part)
    good.dataset.attrs["state"] = json.dumps(facts)
    assert "line at rest" in told(good)


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        (lambda f: f["parts"].pop("datum"), "damaged"),
        (lambda f: f.update(step=f["step"] + 1), "damaged"),
        (lambda f: f.update(parts=3), "damaged"),
        (lambda f: f["parts"].update(datum=-1), "damaged"),
        (lambda f: f["parts"].update(other=f["parts"].pop("datum")), "does not fit"),
    ],
)
def test_a_damaged_state_is_refused(part: Path, spoil: Callable[..., Any], words: str) -> None:
    bad = arcless.open(part)
    facts = bad.metadata["state"]
    spoil(facts)
    bad = arcless.open(part)
    bad.dataset.attrs["state"] = json.dumps(facts)
    assert words in told(bad)


def test_numbers_that_cannot_be_are_refused(part: Path) -> None:
    bad = arcless.open(part)
    bad.dataset["state"].values[:] = 0.5
    assert "does not fit" in told(bad)
    bad.dataset["state"].values[:] = np.nan
    assert "not finite" in told(bad)


def test_a_state_beyond_the_end_is_refused(part: Path) -> None:
    far = arcless.open(part)
    facts = far.metadata["state"] | {"step": 10**6}
    far = arcless.open(part)
    far.dataset.attrs |= {"state": json.dumps(facts), "steps": 10**6}
    assert "damaged" in told(far)
    assert "damaged" in told(far, until="150 m")


def test_numbers_of_another_kind_are_refused(part: Path) -> None:
    bad = arcless.open(part)
    bad.dataset["state"] = bad.dataset["state"].astype(str)
    assert "damaged" in told(bad)


def test_functions_of_unknown_memory_are_refused(short: Short) -> None:
    with pytest.raises(ControlError, match="cannot be saved"):
        arcless.run(short(), until="100 m", controllers={"P1": lambda _: 0.0})
