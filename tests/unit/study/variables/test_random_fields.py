"""Errors along a line as random fields: their covariance, and studies that draw them."""

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.errors import ModelError
from arcless.model import load as load_scenario
from arcless.study import run
from arcless.study.evaluation.variants import scenario
from arcless.study.report import html
from arcless.study.variables.random_fields import DRAWINGS, FIELDS, RandomField, errors
from tests.support.studies import QUICK, VARIABLES, rows, study

SIGMA, BOUND, LENGTH, DRAWN = 0.004, 0.03, 20.0, 4000
DROPPERS, SUPPORTS = FIELDS
BOTH = pytest.mark.parametrize("path", FIELDS)
# Some of them, four tension lengths and all: enough to see a covariance.
SPANS = {"line.spans": [{"type": "span", "count": 7}]}
SAMPLE = {"kind": "monte-carlo", "count": 3}


def varied(path: str = DROPPERS) -> dict[str, Any]:
    field = {"standard_deviation": "4 mm", "correlation_length": "20 m"}
    return {"field": path, "random_field": field}


def sample(path: str, field: RandomField) -> tuple[np.ndarray, np.ndarray]:
    """Return places in m, and errors in m of many drawings."""
    line = study(set=QUICK | SPANS).base.line
    kind = FIELDS[path]
    drawn = [[one[kind.error] for one in errors(path, field, line, n)] for n in range(DRAWN)]
    return np.array([place for place, _ in kind.places(line)]), np.array(drawn)


@BOTH
@pytest.mark.parametrize("length", [LENGTH, pytest.param(100.0, marks=pytest.mark.evidence), 0.0])
def test_covariance_is_the_closed_form(path: str, length: float) -> None:
    field = RandomField(standard_deviation=SIGMA, correlation_length=length)
    x, found = sample(path, field)
    distance = np.abs(x[:, None] - x)
    exact = np.exp(-distance / length) if length else np.eye(len(x))
    # A covariance of normal values is found to σ²√(1 + ρ²)/√n ≤ σ²·0.0224; of all pairs the worst
    # lies within five of these.
    np.testing.assert_allclose(found.T @ found / DRAWN / SIGMA**2, exact, atol=5 * 0.0224)
    # The mean to σ/√n, worst of all places within four.
    np.testing.assert_allclose(found.mean(axis=0), 0.0, atol=4 * SIGMA / math.sqrt(DRAWN))


@BOTH
def test_a_wrong_correlation_length_is_noticed(path: str) -> None:
    length = {DROPPERS: LENGTH, SUPPORTS: 100.0}[path]
    x, found = sample(path, RandomField(standard_deviation=SIGMA, correlation_length=1.5 * length))
    exact = np.exp(-np.abs(x[:, None] - x) / length)
    assert np.abs(found.T @ found / DRAWN / SIGMA**2 - exact).max() > 5 * 0.0224


@BOTH
@pytest.mark.parametrize("length", [LENGTH, 0.0])
def test_errors_within_a_bound_are_equally_likely(path: str, length: float) -> None:
    field = RandomField(bound=BOUND, correlation_length=length)
    x, found = sample(path, field)
    assert np.abs(found).max() <= BOUND
    # A share of p of n is found to √(p (1 − p)/n) ≤ 0.0079; of all places the worst within five.
    for share in (0.1, 0.5, 0.9):
        below = (found < BOUND * (2.0 * share - 1.0)).mean(axis=0)
        np.testing.assert_allclose(below, share, atol=5 * 0.0079)
    distance = np.abs(x[:, None] - x)
    normal = np.exp(-distance / length) if length else np.eye(len(x))
    exact = 6.0 / math.pi * np.arcsin(normal / 2.0)
    # Products of bounded values scatter less than those of normal ones, for which 0.0224 holds.
    spread = BOUND**2 / 3.0
    np.testing.assert_allclose(found.T @ found / DRAWN / spread, exact, atol=5 * 0.0224)


@pytest.mark.parametrize(
    ("field", "got"),
    [
        ({"correlation_length": "20 m"}, "neither of them"),
        (
            {"standard_deviation": "4 mm", "bound": "30 mm", "correlation_length": "20 m"},
            "both of them",
        ),
    ],
)
def test_errors_have_one_size(field: dict[str, str], got: str) -> None:
    variables = {"errors": {"field": DROPPERS, "random_field": field}}
    with pytest.raises(ModelError, match=rf"size of the errors: got {got}, expected standard_dev"):
        study(variables=variables, design=SAMPLE)


@BOTH
def test_a_number_gives_the_same_errors_again(path: str) -> None:
    line = study().base.line
    field = RandomField(standard_deviation=SIGMA, correlation_length=LENGTH)
    assert errors(path, field, line, 5.0) == errors(path, field, line, 5.0)
    assert errors(path, field, line, 5.0) != errors(path, field, line, DRAWINGS - 1.0)


def test_droppers_of_tension_lengths_have_processes_of_their_own() -> None:
    line = load_scenario("ac-simple-overlap-275").line
    field = RandomField(standard_deviation=SIGMA, correlation_length=1e5)
    found = errors(DROPPERS, field, line, 1.0)
    each = {one["tension_length"]: one["length_error"] for one in found}
    assert len(each) > 1
    assert len(set(each.values())) == len(each)
    assert len(found) == len(FIELDS[DROPPERS].places(line))


def test_supports_of_an_overlap_have_an_error_for_each_wire() -> None:
    base = load_scenario("ac-simple-overlap-275")
    field = RandomField(standard_deviation=SIGMA, correlation_length=1e5)
    found = errors(SUPPORTS, field, base.line, 1.0)
    each = {one["tension_length"]: one["height_error"] for one in found}
    assert len(set(each.values())) == len(each) > 1
    # Each tension length has supports between its anchors, and the scenario takes them all.
    lengths = base.line.tension_length_list()
    assert len(found) == sum(one.to_span - one.from_span for one in lengths)
    assert len(base.with_(**{SUPPORTS: found}).as_built.support_height_errors) == len(found)


@BOTH
def test_a_study_of_nothing_else(path: str, tmp_path: Path) -> None:
    made = study(variables={"errors": varied(path)}, design=SAMPLE, seed=2)
    assert run(made, tmp_path).counts["done"] == 3
    found = rows(tmp_path / "table.parquet")
    assert len({row["sigma"] for row in found}) == 3
    one = scenario(made, 2)
    drawn = one.to_dict()["as_built"][path.partition(".")[2]]
    assert len(drawn) == len(FIELDS[path].places(made.base.line))
    assert arcless.run(one).assessment.pantographs[0].std_force_N == found[1]["sigma"]
    assert found[1]["errors"] == made.plan.values(1)[0]
    # Over numbers of drawings there is nothing to plot.
    page = html(made, tmp_path)
    assert "<h3>Percentiles</h3>" in page
    assert "Outputs over variables" not in page


def test_two_fields_are_drawn_by_themselves() -> None:
    made = study(
        variables={"lengths": varied(DROPPERS), "heights": varied(SUPPORTS)}, design=SAMPLE
    )
    lengths, heights = made.plan.values(0)
    assert lengths != heights


def test_errors_are_those_of_the_line_of_the_variant() -> None:
    spans = [[{"type": "span", "count": count}] for count in (4, 5, 6)]
    chosen = {"kind": "choice", "values": spans}
    made = study(
        set={"solver.time_step": "4 ms"},
        variables={"spans": {"field": "line.spans", "distribution": chosen}, "errors": varied()},
        design={"kind": "monte-carlo", "count": 12},
    )
    counts = set()
    for number in range(1, 13):
        one = scenario(made, number)
        counts.add(len(one.line.span_list()))
        assert len(one.as_built.dropper_length_errors) == len(FIELDS[DROPPERS].places(one.line))
    assert counts == {4, 5, 6}


def test_only_where_it_belongs() -> None:
    with pytest.raises(ModelError, match=r'random field: got "speed", expected as_built\.dropper'):
        study(variables={"errors": varied("speed")}, design=SAMPLE)
    near = varied("as_built.support_hight_errors")
    with pytest.raises(ModelError, match=r"did you mean as_built\.support_height_errors"):
        study(variables={"errors": near}, design=SAMPLE)


@pytest.mark.parametrize(
    ("design", "title"),
    [
        ({"kind": "grid"}, "a grid"),
        ({"kind": "list"}, "a list"),
        (
            {"kind": "optimise", "trials": 3, "objectives": {"sigma": "minimise"}},
            "an optimisation",
        ),
    ],
)
def test_designs_that_choose_values_refuse_it(design: dict[str, Any], title: str) -> None:
    expected = rf"no values to choose from: got a design that is {title}, expected a sample"
    with pytest.raises(ModelError, match=expected):
        study(variables={"force": VARIABLES["force"], "errors": varied()}, design=design)
