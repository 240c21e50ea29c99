"""First screen of a run: verdict in words, criteria as bars."""

from dataclasses import replace

import numpy as np
import pytest

from arcless.assess import assess
from arcless.figures.run.run_data import RunData
from arcless.model import load
from arcless.report.summary import (
    LENGTH,
    bullets,
    grouped,
    identity,
    judged_on,
    leading,
    verdict,
    worst_place,
)
from tests.support.synthetic import scenario_data, synthetic_dataset


def test_an_unverified_limit_is_no_failure() -> None:
    found = verdict(assess(synthetic_dataset()))
    assert (found.state, found.sign) == ("open", "≈")
    assert found.text == "Beyond a limit that is not verified: 1 of 9 criteria"
    assert found.rest == "7 met, 2 of them against unverified limits; 1 not judged"
    (item,) = found.items
    assert item == (
        "mean contact force F_m, upper limit: 100.0 N, limit ≤ 92.4 N, tolerance 1 N,"
        " 7.6 N above it (8 %); the limit is not verified, mark C"
    )


def test_the_least_favourable_verdict_is_the_headline() -> None:
    wild = synthetic_dataset(force=lambda t: 80.0 + 60.0 * np.sin(2.0 * np.pi * t))
    found = verdict(assess(wild))
    assert (found.state, found.sign, found.text) == ("missed", "✘", "Not met: 2 of 9 criteria")
    assert [item.partition(":")[0] for item in found.items] == [
        "standard deviation σ",
        "statistical minimum F_m − 3σ",
    ]


def test_the_leading_criterion_is_the_one_that_is_missed_worst() -> None:
    # σ is 42 N of a mean of 100 N, 41 % beyond 0.3 F_m; F_m − 3σ is −27 N, 27 % of F_m below zero.
    shaken = assess(synthetic_dataset(force=lambda t: 100.0 + 60.0 * np.sin(2.0 * np.pi * t)))
    lead = leading(shaken)
    assert lead is not None
    assert lead.name == "standard_deviation"
    # The wave speed is one half beyond its limit.
    worse = [
        replace(one, value=1.5 * one.limit, passed=False)  # type: ignore[operator]
        if one.name == "wave_speed_use" else one for one in shaken.criteria
    ]  # fmt: skip
    lead = leading(replace(shaken, criteria=worse))
    assert lead is not None
    assert lead.name == "wave_speed_use"
    # Of a force whose limit is zero the mean force is the measure: −60 N of 100 N are 60 %.
    worst = [
        replace(one, value=-60.0, passed=False) if one.name == "statistical_min" else one
        for one in worse
    ]
    lead = leading(replace(shaken, criteria=worst))
    assert lead is not None
    assert lead.name == "statistical_min"


def test_where_all_are_met_the_largest_deviation_leads() -> None:
    met = assess(synthetic_dataset(pantographs=("P1", "P2"), duration_s=40.0))
    criteria = [
        replace(one, value=7.0) if (one.name, one.pantograph) == ("standard_deviation", "P2")
        else replace(one, passed=True) if one.passed is False else one
        for one in met.criteria
    ]  # fmt: skip
    lead = leading(replace(met, criteria=criteria))
    assert lead is not None
    assert (lead.name, lead.pantograph) == ("standard_deviation", "P2")
    assert leading(replace(met, criteria=[])) is None


def test_everything_met() -> None:
    data = scenario_data(line__design={"uplift_space": None})
    calm = assess(synthetic_dataset(scenario=data, force=lambda t: 80.0 + 0.0 * t))
    found = verdict(calm)
    # Limits of a supply that nobody gave are assumed, that of NQ is from memory.
    unverified = ", 4 of them against unverified limits"
    assert (found.state, found.text) == ("met", f"Met: 7 of 9 criteria{unverified}")
    assert found.rest == "2 not judged"
    judged = [one for one in calm.criteria if one.passed]
    assert verdict(replace(calm, criteria=judged)).text == f"Met: all 7 criteria{unverified}"
    assert verdict(replace(calm, criteria=[])).text == "Not judged: all 0 criteria"


def test_a_bar_shows_on_which_side_of_the_limit_a_value_is() -> None:
    assessment = assess(synthetic_dataset())
    by_name = {c.name: c for c in assessment.criteria}
    for name, sign in (("standard_deviation", 1), ("statistical_min", -1)):
        limit = by_name[name].limit
        for value in (limit - 20.0, limit + 20.0):
            one = replace(by_name[name], value=value)
            (bullet,) = bullets(replace(assessment, criteria=[one]))
            begin, width = bullet.bar.beyond[0]
            inside_beyond = begin <= bullet.bar.begin + bullet.bar.width <= begin + width
            assert inside_beyond == (sign * (value - limit) > 0)
            assert 0.0 <= bullet.bar.bound <= LENGTH


def test_a_bar_has_its_uncertainty_and_its_words() -> None:
    assessment = assess(synthetic_dataset())
    (sigma,) = [c for c in assessment.criteria if c.name == "standard_deviation"]
    sure = replace(sigma, value=20.0, limit=30.0, certainty={"spread": 1.0, "discretisation": 0.5})
    (bullet,) = bullets(replace(assessment, criteria=[sure]))
    assert bullet.words == "20.0 ± 1.5 N, limit ≤ 30.0 N = 0.3 F_m: met"
    low, high = bullet.bar.sure
    # From 18.5 to 21.5 N on a bar whose limit, 30 N, stands at 800.
    assert (low, high) == pytest.approx((800.0 * 18.5 / 30.0, 800.0 * 21.5 / 30.0), abs=0.06)


def test_a_criterion_without_a_limit_has_no_bar() -> None:
    data = scenario_data(line__design={"uplift_space": None})
    found = {one.title: one for one in bullets(assess(synthetic_dataset(scenario=data)))}
    uplift = found["space required for the uplift at supports, 2·S0"]
    assert (uplift.bar, uplift.limit, uplift.verdict) == (None, "no limit given", "not judged")


def test_pantographs_are_named_where_there_are_several() -> None:
    two = assess(synthetic_dataset(pantographs=("front", "rear")))
    assert {one.pantograph for one in bullets(two)} == {"", "front", "rear"}
    assert {one.pantograph for one in bullets(assess(synthetic_dataset()))} == {""}


def test_pantographs_stand_together_below_their_criterion() -> None:
    assessment = assess(synthetic_dataset(pantographs=("front", "rear")))
    groups = grouped(bullets(assessment))
    assert sum(map(len, groups)) == len(assessment.criteria)
    titles = [group[0].title for group in groups]
    assert len(set(titles)) == len(titles)
    by_title = {group[0].title: [one.pantograph for one in group] for group in groups}
    assert by_title["standard deviation σ"] == ["front", "rear"]
    assert by_title["space required for the uplift at supports, 2·S0"] == [""]


def test_a_distance_is_that_of_the_numbers_beside_it() -> None:
    assessment = assess(synthetic_dataset())
    (sigma,) = [c for c in assessment.criteria if c.name == "standard_deviation"]
    # 1.62 N apart, and 1.7 N as they are printed.
    missed = replace(sigma, value=35.66, limit=34.04, passed=False)
    assert verdict(replace(assessment, criteria=[missed])).items == [
        "standard deviation σ: 35.7 N, limit ≤ 34.0 N = 0.3 F_m, 1.7 N above it (5 %)"
    ]


def test_the_section_of_a_verdict_is_told_with_its_spans() -> None:
    run = synthetic_dataset()
    for section, words in (
        ((150.0, 450.0), "Judged on 150–450 m, spans 4 to 9 of 12."),
        ((100.0, 149.995), "Judged on 100–150 m, span 3 of 12."),
        ((160.0, 240.0), "Judged on 160–240 m, spans 4 to 5 of 12."),
    ):
        assert judged_on(RunData(run, assess(run, section=section))) == words


def test_the_worst_place_in_words() -> None:
    dataset = synthetic_dataset(
        pantographs=("front", "rear"),
        force=lambda t: 100.0 + 50.0 * np.exp(-(((20.0 * t - 330.0) / 5.0) ** 2)),
    )
    dataset["contact_force"].values[:, 1] = 100.0
    run = RunData(dataset, assess(dataset))
    words = worst_place(run)
    assert (
        words == "maximum contact force of front, 150 N, at 330.0 m, span 7, 5.0 m after dropper 3."
    )


def test_the_first_screen_has_the_static_force_of_the_run() -> None:
    assessment = assess(synthetic_dataset())
    own = load("norway-s25-250")
    told = dict(identity(own, assessment, {"static_force_found": {"P1": 73.25}}))
    assert told["Static force"] == "73.2 N, found for a mean contact force of 130.6 N"
    given = own.with_(**{"pantographs.0.static_force": "70 N"})
    told = dict(identity(given, assessment, {"static_force_found": {"P1": 70.0}}))
    assert told["Static force"] == "70.0 N, given by the scenario"
    # Results of early versions do not have it.
    assert "Static force" not in dict(identity(own, assessment, {"static_force_found": None}))
