"""Percentiles of a sample: the intervals hold what they promise."""

import json
from pathlib import Path

import numpy as np
import pytest

from arcless.errors import OutputError
from arcless.study import StudyFolder, run
from arcless.study.analysis.findings import FILES, findings
from arcless.study.analysis.percentiles import PERCENT, binomial_quantiles, of_values, percentiles
from arcless.study.report import html, write
from tests.support.studies import VARIABLES, filled, study


@pytest.mark.parametrize("count", [40, 300])
def test_intervals_hold_the_percentile_as_often_as_they_say(count: int) -> None:
    trials, random = 400, np.random.Generator(np.random.PCG64(3))
    inside = np.zeros(len(PERCENT))
    for _ in range(trials):
        for place, one in enumerate(of_values(random.exponential(size=count))):
            exact = -np.log1p(-PERCENT[place] / 100.0)
            low = -np.inf if one["low"] is None else one["low"]
            high = np.inf if one["high"] is None else one["high"]
            inside[place] += low <= exact <= high
    # At least 95 %; 400 trials find that to 3·√(0.95·0.05/400) = 3.3 %.
    assert (inside / trials >= 0.95 - 0.033).all()
    # No interval that is far too wide: of the median it holds for at most 97.5 % or so.
    assert inside[2] / trials < 0.995


def test_known_order_statistics() -> None:
    median = of_values(np.arange(1.0, 101.0))[2]
    # The textbook's interval of the median of 100 values: the 40th and the 61st.
    assert median == {"percent": 50.0, "value": 50.5, "low": 40.0, "high": 61.0}


@pytest.mark.parametrize("count", [1, 2, 7, 72, 368, 1000, 100_000])
def test_binomial_quantiles_are_those_of_scipy(count: int) -> None:
    from scipy.stats import binom

    ends = (0.025, 0.975)
    for percent in PERCENT:
        exact = [int(binom.ppf(end, count, percent / 100.0)) for end in ends]
        assert binomial_quantiles(count, percent / 100.0, ends) == exact


def test_too_few_values_have_no_bound() -> None:
    found = of_values(np.array([1.0, 2.0, 3.0]))
    assert (found[-1]["value"], found[-1]["high"]) == (2.98, None)
    # Two of three values above a percentile of 95 happen in 0.7 % of cases.
    assert [one["low"] for one in found] == [None, None, None, 2.0, 2.0]
    assert of_values(np.array([]))[2] == {
        "percent": 50.0, "value": None, "low": None, "high": None,
    }  # fmt: skip


def test_of_a_study_and_in_its_report(tmp_path: Path) -> None:
    force = {"force": {"field": "pantographs.0.static_force", "range": [60, 90]}}
    made = filled(tmp_path, variables=force, design={"kind": "monte-carlo", "count": 200})
    found = percentiles(made, StudyFolder(made, tmp_path).rows())
    assert found is not None
    sigma = found["outputs"]["sigma"]
    assert (sigma["values"], sigma["without_value"]) == (200, 0)
    assert sigma["percentiles"][2]["low"] < 0.075 < sigma["percentiles"][2]["high"]
    assert "<h3>Percentiles</h3>" in html(made, tmp_path)
    grid = study(variables=VARIABLES)
    assert percentiles(grid, []) is None


SAMPLE = {
    "variables": {"force": {"field": "pantographs.0.static_force", "range": [60, 90]}},
    "design": {"kind": "monte-carlo", "count": 3},
}


def test_a_study_leaves_them_beside_its_table(tmp_path: Path) -> None:
    made = study(**SAMPLE)
    run(made, tmp_path)
    state, found = findings(made, tmp_path)
    assert state.done == 3
    assert json.loads((tmp_path / "percentiles.json").read_text("utf-8")) == found["percentiles"]
    assert found["sensitivity"] is None
    assert not (tmp_path / FILES["sensitivity"]).exists()


def test_a_report_writes_them_too_where_it_can(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    made = filled(tmp_path, of=2, **SAMPLE)
    file = tmp_path / FILES["percentiles"]
    write(made, tmp_path)
    assert json.loads(file.read_text("utf-8"))["outputs"]["sigma"]["values"] == 2

    def full(*_: object) -> None:
        raise OutputError("the file cannot be written")

    monkeypatch.setattr("arcless.study.analysis.findings.write_bytes", full)
    assert write(made, tmp_path, tmp_path / "page.html").exists()
