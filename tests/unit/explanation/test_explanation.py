"""Explanations of whole results: several pantographs, what is missing from a record, notes."""

import json
from typing import Any

import numpy as np
import pytest

from arcless.assess import assess
from arcless.explanation import Explanation, explain
from arcless.model import load
from tests.support.synthetic import SPAN_M, scenario_data, synthetic_dataset

SPEED = 20.0
DROPPERS = {"all": {"length": SPAN_M, "droppers": {"positions": [5.0, 15.0, 25.0, 35.0, 45.0]}}}


def force(t: np.ndarray) -> np.ndarray:
    wave = 2.0 * np.pi * SPEED / SPAN_M
    return 100.0 + 30.0 * np.sin(wave * t) + 10.0 * np.sin(5.0 * wave * t) + 3.0 * np.sin(1.3 * t)


def explanation_of(changes: dict[str, Any] | None = None, **more: Any) -> Explanation:
    scenario = scenario_data(line__span_types=DROPPERS, **(changes or {}))
    given = {"force": force, "section": (100.0, 500.0), "scenario": scenario, **more}
    dataset = synthetic_dataset(**given)
    return explain(dataset, assess(dataset), load(scenario))


def test_variances_add_up_to_that_of_the_assessment() -> None:
    scenario = scenario_data(line__span_types=DROPPERS)
    dataset = synthetic_dataset(force=force, section=(90.0, 511.0), scenario=scenario)
    assessment = assess(dataset)
    (one,) = explain(dataset, assessment, load(scenario)).pantographs
    (assessed,) = assessment.pantographs
    assert one.std_force_N == pytest.approx(assessed.std_force_N, rel=1e-12)  # rounding
    total = sum(part.variance_N2 for part in one.groups)
    assert total == pytest.approx(assessed.std_force_N**2, rel=1e-9)  # rounding
    assert one.groups[0].share_percent == pytest.approx(100 * 450 / 504.5, abs=1.0)


def test_the_sentences_name_share_frequency_wavelength_and_place() -> None:
    share, place = explanation_of().sentences
    # √(30² + 10² + 3²)/√2 = 22.46 N; the last sine is not whole in the section.
    assert share.startswith("σ is 22.4 N; the largest share of its variance is span passing, 89")
    assert "0.40 Hz, wavelength 50.0 m" in share
    assert place.startswith("The force deviates most at ")
    assert " F_m" in place


def test_several_pantographs_have_sentences_of_their_own() -> None:
    first = scenario_data()["pantographs"][0]
    pair = [{**first, "name": "front"}, {**first, "name": "rear", "distance": 100.0}]
    found = explanation_of({"pantographs": pair}, pantographs=("front", "rear"))
    assert [one.split(":")[0] for one in found.sentences] == ["front", "front", "rear", "rear"]
    assert len(found.to_dict()["pantographs"]) == 2


def test_a_record_without_elasticity_has_no_modes() -> None:
    found = explanation_of(without=("elasticity",))
    assert found.pantographs[0].modes == ()
    assert found.pantographs[0].groups[2].share_percent == 0.0
    assert "no modes of pantograph P1: the record has no elasticity of the line" in found.notes


def test_a_spring_with_a_table_has_no_modes() -> None:
    table = {"elongation": [-1.0, 0.0, 1.0], "force": [-100.0, 0.0, 50.0]}
    mass = {"mass": 8, "stiffness_table": table, "damping": 1}
    pantograph = {"static_force": 60.0, "model": {"name": "drawn", "masses": [mass]}}
    found = explanation_of({"pantographs": [pantograph]})
    (note,) = found.notes
    assert "masses.0.stiffness_table is no constant" in note


def test_a_line_whose_droppers_do_not_repeat_says_so() -> None:
    sparse = {"all": {"length": SPAN_M, "droppers": {"positions": [25.0]}}}
    scenario = scenario_data(line__span_types=sparse)
    dataset = synthetic_dataset(force=force, section=(100.0, 500.0), scenario=scenario)
    lonely = explain(dataset, assess(dataset), load(scenario))
    assert "the line has no droppers that repeat within a span" in lonely.notes


def test_a_notebook_shows_sentences_and_parts() -> None:
    found = explanation_of()
    shown = found._repr_html_()
    assert "Why σ is as it is: synthetic" in shown
    assert found.sentences[0] in shown
    assert "dropper passing" in shown


def test_it_is_plain_data() -> None:
    data = json.loads(json.dumps(explanation_of().to_dict(), allow_nan=False))
    assert data["format"] == "arcless-explanation/1"
    assert data["section_m"] == [100.0, 500.0]
    assert data["sensitivities"] is None
