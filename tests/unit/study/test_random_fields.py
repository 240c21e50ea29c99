"""Dropper-length errors along a line: their covariance, and studies that draw them."""

import math
from pathlib import Path

import numpy as np
import pytest

import arcless
from arcless.errors import ModelError
from arcless.model import load as load_scenario
from arcless.study import run
from arcless.study.random_fields import DRAWINGS, RandomField, droppers, length_errors
from arcless.study.variants import scenario
from tests.support.studies import VARIABLES, rows, study

SIGMA, LENGTH, DRAWN = 0.004, 20.0, 4000
FIELD = {
    "field": "as_built.dropper_length_errors",
    "random_field": {"standard_deviation": "4 mm", "correlation_length": "20 m"},
}


def sample(field: RandomField) -> np.ndarray:
    line = study().base.line
    return np.array(
        [[one["length_error"] for one in length_errors(field, line, n)] for n in range(DRAWN)]
    )


@pytest.mark.parametrize("length", [LENGTH, 0.0])
def test_covariance_is_the_closed_form(length: float) -> None:
    x = np.array([place for place, _ in droppers(study().base.line)])
    field = RandomField(standard_deviation=SIGMA, correlation_length=length)
    distance = np.abs(x[:, None] - x)
    exact = np.exp(-distance / length) if length else np.eye(len(x))
    found = sample(field)
    # A covariance of normal values is found to σ²√(1 + ρ²)/√n ≤ σ²·0.0224; of all pairs the worst
    # lies within five of these.
    np.testing.assert_allclose(found.T @ found / DRAWN / SIGMA**2, exact, atol=5 * 0.0224)
    # The mean to σ/√n, worst of all droppers within four.
    np.testing.assert_allclose(found.mean(axis=0), 0.0, atol=4 * SIGMA / math.sqrt(DRAWN))


def test_a_wrong_correlation_length_is_noticed() -> None:
    x = np.array([place for place, _ in droppers(study().base.line)])
    exact = np.exp(-np.abs(x[:, None] - x) / LENGTH)
    found = sample(RandomField(standard_deviation=SIGMA, correlation_length=1.5 * LENGTH))
    assert np.abs(found.T @ found / DRAWN / SIGMA**2 - exact).max() > 5 * 0.0224


def test_a_number_gives_the_same_errors_again() -> None:
    line, field = (
        study().base.line,
        RandomField(standard_deviation=SIGMA, correlation_length=LENGTH),
    )
    assert length_errors(field, line, 5.0) == length_errors(field, line, 5.0)
    assert length_errors(field, line, 5.0) != length_errors(field, line, DRAWINGS - 1.0)


def test_tension_lengths_have_processes_of_their_own() -> None:
    line = load_scenario("ac-simple-overlap-275").line
    field = RandomField(standard_deviation=SIGMA, correlation_length=1e5)
    errors = {one["tension_length"]: one["length_error"] for one in length_errors(field, line, 1.0)}
    assert len(errors) > 1
    assert len(set(errors.values())) == len(errors)
    assert len(length_errors(field, line, 1.0)) == len(droppers(line))


def test_a_study_draws_them(tmp_path: Path) -> None:
    made = study(variables={"errors": FIELD}, design={"kind": "monte-carlo", "count": 3}, seed=2)
    run(made, tmp_path)
    found = rows(tmp_path / "table.parquet")
    assert len({row["sigma"] for row in found}) == 3
    one = scenario(made, 2)
    assert len(one.as_built.dropper_length_errors) == len(droppers(made.base.line))
    assert arcless.run(one).assessment.pantographs[0].std_force_N == found[1]["sigma"]
    assert found[1]["errors"] == made.plan.values(1)[0]


def test_only_where_it_belongs() -> None:
    wrong = {**FIELD, "field": "speed"}
    with pytest.raises(ModelError, match=r'random field: got "speed", expected "as_built\.dropper'):
        study(variables={"errors": wrong}, design={"kind": "monte-carlo", "count": 3})
    with pytest.raises(ModelError, match="values cannot be counted"):
        study(variables={"errors": FIELD, "force": VARIABLES["force"]})
