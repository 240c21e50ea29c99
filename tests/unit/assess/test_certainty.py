"""Certainty of a number, by hand; and verdicts that the next run might turn."""

import math
from dataclasses import asdict, replace
from typing import Any

import pytest

from arcless.assess import (
    MET,
    NOT_JUDGED,
    NOT_MET,
    TOO_CLOSE,
    assess,
    uncertainty_of,
    verdict_of,
)
from arcless.assess.assessment import draw_of
from arcless.assess.certainty import Certainty, Draw, Draws, certainty, student_factor
from arcless.assess.certainty_words import explained
from arcless.assess.criteria import Criterion, evaluate
from arcless.assess.rules import MEAN_FORCE_TOLERANCE_N
from arcless.assess.statistics import PantographAssessment
from arcless.errors import ResultFormatError
from tests.support.synthetic import synthetic_dataset
from tests.unit.assess.test_criteria import FACTS, GOOD


@pytest.mark.parametrize("freedom", [1, 2, 3, 4, 5, 7, 8, 30, 99])
@pytest.mark.parametrize("coverage", [0.5, 0.95, 0.99])
def test_the_factor_is_that_of_student(freedom: int, coverage: float) -> None:
    from scipy.stats import t

    expected = t.ppf(0.5 + coverage / 2, freedom)
    # SciPy's own is known to some 1e-12.
    assert student_factor(freedom, coverage) == pytest.approx(expected, rel=1e-9)


def test_spread_and_discretisation_by_hand() -> None:
    found = certainty(10.0, [12.0, 14.0], 9.5)
    assert found.spread == pytest.approx(4.302652729749462 * 2.0)  # s = 2, two degrees of freedom
    assert found.discretisation == 0.5
    assert found.uncertainty == pytest.approx(found.spread + 0.5)


def test_equal_numbers_have_no_spread_by_rounding() -> None:
    assert certainty(0.1 + 0.2, [0.1 + 0.2] * 7, 0.1 + 0.2) == Certainty(0.0, 0.0)


def test_what_is_not_known_is_not_added() -> None:
    assert certainty(1.0, [], None) == Certainty(None, None)
    assert certainty(1.0, [], None).uncertainty is None
    assert certainty(1.0, [None], 0.75).uncertainty == 0.25
    assert certainty(1.0, [1.0], None).uncertainty == 0.0
    assert uncertainty_of(None) is None


def draw(**numbers: float) -> Draw:
    """Return what is kept of a run with other numbers than the good one."""
    other = replace(GOOD, **numbers)
    found = {(c.name, c.pantograph): (c.value, c.limit) for c in evaluate(FACTS, [other])}
    return Draw({"P1": {}}, {}, found)


def judged(name: str, draws: Draws, facts: Any = FACTS, **numbers: float) -> Criterion:
    own: PantographAssessment = replace(GOOD, **numbers)
    [found] = [c for c in evaluate(facts, [own], draws) if c.name == name]
    return found


def test_a_value_nearer_to_its_limit_than_it_is_sure_is_too_close_to_tell() -> None:
    # Two draws 1 N apart: s = 0.707 N, t = 12.7, spread 8.98 N; discretisation 1 N.
    reach = student_factor(1) * math.sqrt(0.5) + 1.0
    for value, verdict in (
        (350.0 - 1.001 * reach, MET),
        (350.0 + 1.001 * reach, NOT_MET),
    ):
        moved = Draws([draw(statistical_max_N=value + 1.0)], draw(statistical_max_N=value - 1.0))
        found = judged("statistical_max", moved, statistical_max_N=value)
        assert verdict_of(asdict(found)) == verdict, found
        assert found.reason is None
    close = Draws([draw(statistical_max_N=350.0)], draw(statistical_max_N=348.0))
    found = judged("statistical_max", close, statistical_max_N=349.0)
    assert found.passed is None
    assert verdict_of(asdict(found)) == TOO_CLOSE
    assert found.reason is not None
    assert found.reason.startswith("too close to tell: 1 N from the limit, and sure to 10 N only")
    assert found.certainty == {
        "spread": pytest.approx(reach - 1.0),
        "discretisation": pytest.approx(1.0),
    }


def test_value_and_limit_go_up_together() -> None:
    """The limit of σ is 0.3 F_m: a run with both higher is as far from it."""
    draws = Draws([draw(std_force_N=43.0, mean_force_N=440.0 / 3.0)], None)
    found = judged("standard_deviation", draws, std_force_N=39.0, mean_force_N=400.0 / 3.0)
    # Rounding of numbers of some hundred newtons.
    assert found.certainty == {"spread": pytest.approx(0.0, abs=1e-12), "discretisation": None}
    assert found.passed is True


def test_a_tolerance_belongs_to_the_limit() -> None:
    limit = 0.00097 * FACTS.speed_km_h**2 + 70.0
    draws = Draws([draw(mean_force_N=limit)], draw(mean_force_N=limit + 0.5))
    found = judged("mean_force", draws, mean_force_N=limit)
    assert (found.passed, found.certainty) == (True, {"spread": 0.0, "discretisation": 0.5})
    nearer = limit + MEAN_FORCE_TOLERANCE_N - 0.25
    draws = Draws([draw(mean_force_N=nearer)], draw(mean_force_N=nearer + 0.5))
    found = judged("mean_force", draws, mean_force_N=nearer)
    assert found.passed is None
    assert "from the limit with its tolerance" in (found.reason or "")


def test_what_has_no_limit_is_not_judged_and_says_why() -> None:
    facts = replace(FACTS, uplift_space_mm=None)
    [found] = [c for c in evaluate(facts, [GOOD], Draws([draw()], None)) if c.limit is None]
    assert verdict_of(asdict(found)) == NOT_JUDGED
    assert found.reason == "the line's design data give no limit"
    assert found.certainty is None


def facts_of(**changes: Any) -> dict[str, Any]:
    """Return the data that a result keeps of its additional runs."""
    own = draw_of(assess(synthetic_dataset()))
    moved = {name: dict(values) for name, values in own.pantographs.items()}
    for values in moved.values():
        values["mean_force_N"] = (values["mean_force_N"] or 0.0) + 2.0
    other = Draw(moved, own.run, own.criteria).to_dict()
    return {
        "starts_m": [50.0, 75.0],
        "static_force_N": [[60.0], [61.0]],
        "draws": [other],
        "refined": other,
        "other_family": {
            "scheme": "generalised-alpha",
            "wire_model": "hermite",
            "contact_wire_element_m": 0.725,
            "messenger_wire_element_m": 0.725,
            "time_step_s": 5e-4,
        },
        "wall_time_s": {"starts": 1.0, "other_family": 2.0, "elapsed": 2.5},
        "notes": [],
        **changes,
    }


def test_a_dataset_with_runs_beside_it_says_how_sure_it_is() -> None:
    found = assess(synthetic_dataset(attrs={"certainty": facts_of()})).to_dict()
    sure = found["pantographs"][0]["certainty"]["mean_force_N"]
    assert sure == {
        "spread": pytest.approx(student_factor(1) * math.sqrt(2.0)),
        "discretisation": pytest.approx(2.0),
    }
    assert found["certainty"]["max_uplift_at_support_mm"]["discretisation"] == 0.0
    assert found["certainty_method"]["runs"] == 2
    assert found["certainty_method"]["coverage"] == 0.95
    assert "draws" not in found["certainty_method"]
    text = " ".join(explained(found["certainty_method"]))
    assert "12.71 standard deviations of 2 runs" in text
    assert "cubic elements of 0.725 m" in text


def test_nothing_is_said_of_what_nobody_asked_for() -> None:
    found = assess(synthetic_dataset()).to_dict()
    parts = [found, *found["pantographs"], *found["criteria"]]
    assert not any("certainty" in part or "certainty_method" in part for part in parts)


def test_another_section_has_no_certainty_and_a_note() -> None:
    dataset = synthetic_dataset(attrs={"certainty": facts_of()})
    for options in ({"section": (200.0, 300.0)}, {"low_pass_Hz": 10.0}):
        found = assess(dataset, **options)
        assert found.certainty is None
        assert any("own section and filter alone" in note for note in found.notes)
    assert assess(dataset, section=(200.0, 400.0)).certainty is not None


def test_words_for_what_is_not_known() -> None:
    failed = facts_of(draws=[], refined=None, notes=["7 of 7 runs from other starts failed"])
    found = assess(synthetic_dataset(attrs={"certainty": failed}))
    assert found.certainty_method is not None
    assert "no spread is known" in " ".join(explained(found.certainty_method))
    assert "7 of 7 runs from other starts failed" in found.notes
    alone = facts_of(other_family=None, refined=None)
    alone["wall_time_s"]["other_family"] = None
    found = assess(synthetic_dataset(attrs={"certainty": alone}))
    assert found.certainty_method is not None
    assert "was not requested" in " ".join(explained(found.certainty_method))


@pytest.mark.parametrize(
    "spoilt",
    [
        {"draws": None},
        {"draws": [{}]},
        {"draws": [3]},
        {"draws": [{"pantographs": {}, "run": {}, "criteria": [[1]]}]},
        {"refined": []},
    ],
)
def test_damaged_facts_are_refused(spoilt: dict[str, Any]) -> None:
    with pytest.raises(ResultFormatError, match="damaged"):
        assess(synthetic_dataset(attrs={"certainty": facts_of(**spoilt)}))
    with pytest.raises(ResultFormatError, match="damaged"):
        assess(synthetic_dataset(attrs={"certainty": [1, 2]}))
    without = {key: value for key, value in facts_of().items() if key != "starts_m"}
    with pytest.raises(ResultFormatError, match="damaged"):
        assess(synthetic_dataset(attrs={"certainty": without}))
