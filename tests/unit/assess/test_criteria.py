"""Verdicts at their boundaries, for every supply and every band of speed."""

import math
from dataclasses import asdict, replace

import pytest

from arcless.assess.criteria import (
    NOT_MET,
    NOT_MET_UNVERIFIED,
    decimals_of,
    evaluate,
    shown_verdict,
    verdict_of,
)
from arcless.assess.facts import speed_notes
from arcless.assess.rules import ANY_SUPPLY, MEAN_FORCE_TOLERANCE_N, RULES, Facts, HeadLimit
from arcless.assess.statistics import PantographAssessment
from arcless.assess.tables import headline

FACTS = Facts(
    "AC 25 kV",
    300.0,
    wave_speed_use=0.5,
    uplift_mm=40.0,
    uplift_space_mm=100.0,
    heads={"P1": HeadLimit(400.0, "A"), "P2": HeadLimit(400.0, "A")},
)
GOOD = PantographAssessment(
    name="P1",
    mean_force_N=150.0,
    std_force_N=30.0,
    std_force_0_5Hz_N=20.0,
    std_force_5_20Hz_N=20.0,
    max_force_N=240.0,
    min_force_N=70.0,
    statistical_max_N=240.0,
    statistical_min_N=60.0,
    contact_loss_percent=0.0,
    NQ_percent=0.0,
    longest_loss_s=0.0,
    max_gap_mm=0.0,
    contact_point_range_mm=40.0,
    unfiltered_max_force_N=260.0,
    unfiltered_min_force_N=50.0,
    max_lateral_position_mm=250.0,
)


def verdict(name: str, facts: Facts = FACTS, **numbers: float):
    [found] = [c for c in evaluate(facts, [replace(GOOD, **numbers)]) if c.name == name]
    return found


def just_above(value: float) -> float:
    return math.nextafter(value, math.inf)


def just_below(value: float) -> float:
    return math.nextafter(value, -math.inf)


def test_a_good_run_meets_every_criterion() -> None:
    assert all(c.passed for c in evaluate(FACTS, [GOOD]))


def test_standard_deviation_boundary() -> None:
    assert verdict("standard_deviation", mean_force_N=100.0, std_force_N=30.0).passed
    assert not verdict("standard_deviation", mean_force_N=100.0, std_force_N=just_above(30)).passed


def test_statistical_minimum_is_strict() -> None:
    assert not verdict("statistical_min", statistical_min_N=0.0).passed
    assert verdict("statistical_min", statistical_min_N=just_above(0.0)).passed


@pytest.mark.parametrize(
    ("supply", "speed", "limit", "mark"),
    [
        ("AC 25 kV", 200.0, 300.0, "A"),
        ("AC 25 kV", 200.1, 350.0, "A"),
        ("AC 25 kV", 320.0, 350.0, "A"),
        ("AC 25 kV", 320.1, 400.0, "A"),
        ("AC 15 kV", 320.0, 350.0, "C"),
        ("DC 3 kV", 200.0, 300.0, "A"),
        ("DC 3 kV", 201.0, 400.0, "A"),
        ("DC 1.5 kV", 201.0, 400.0, "C"),
    ],
)
def test_statistical_maximum_by_supply_and_speed(supply, speed, limit, mark) -> None:
    facts = replace(FACTS, supply=supply, speed_km_h=speed)
    at = verdict("statistical_max", facts, statistical_max_N=limit)
    assert (at.passed, at.limit, at.mark) == (True, limit, mark)
    assert not verdict("statistical_max", facts, statistical_max_N=just_above(limit)).passed


@pytest.mark.parametrize("km_h", [200.0, 250.0, 320.0])
def test_a_round_speed_survives_the_way_through_metres_per_second(km_h: float) -> None:
    exact = verdict("statistical_max", replace(FACTS, speed_km_h=km_h))
    for there_and_back in (3.6 * (km_h / 3.6), just_above(km_h), just_below(km_h)):
        facts = replace(FACTS, speed_km_h=there_and_back)
        assert verdict("statistical_max", facts).limit == exact.limit
        assert (
            verdict("contact_loss", facts).limit
            == verdict("contact_loss", replace(FACTS, speed_km_h=km_h)).limit
        )


# Values of the law as printed where it was read, to the 0.1 N given there.
@pytest.mark.parametrize(
    ("supply", "km_h", "limit"),
    [
        ("AC 25 kV", 250.0, 130.6),
        ("AC 25 kV", 300.0, 157.3),
        ("AC 15 kV", 320.0, 169.3),
        ("AC 25 kV", 350.0, 188.8),
        ("AC 25 kV", 380.0, 210.1),
        ("AC 25 kV", 400.0, 225.2),
        ("AC 25 kV", 160.0, 0.00047 * 160.0**2 + 90.0),
        ("DC 3 kV", 200.0, 0.00097 * 200.0**2 + 110.0),
        ("DC 1.5 kV", 160.0, 0.00097 * 160.0**2 + 140.0),
    ],
)
def test_mean_force_law(supply: str, km_h: float, limit: float) -> None:
    facts = replace(FACTS, supply=supply, speed_km_h=km_h)
    found = verdict("mean_force", facts, mean_force_N=100.0)
    # Limits are printed with one decimal.
    assert found.limit == pytest.approx(limit, abs=0.05)
    over = found.limit + MEAN_FORCE_TOLERANCE_N
    assert verdict("mean_force", facts, mean_force_N=over).passed
    assert not verdict("mean_force", facts, mean_force_N=just_above(over)).passed


def test_the_rounded_target_of_a_reference_case_meets_its_own_law() -> None:
    # 143.4 N at 275 km/h is the law's 143.36 N, rounded up.
    assert verdict("mean_force", replace(FACTS, speed_km_h=275.0), mean_force_N=143.4).passed


def test_lower_mean_force_law_belongs_to_slow_alternating_current() -> None:
    slow = replace(FACTS, speed_km_h=160.0)
    limit = 0.00047 * 160.0**2 + 60.0
    low = limit - MEAN_FORCE_TOLERANCE_N
    assert verdict("mean_force_lower", slow, mean_force_N=just_above(low)).passed
    assert not verdict("mean_force_lower", slow, mean_force_N=low - 1e-9).passed
    assert "mean_force_lower" not in {c.name for c in evaluate(FACTS, [GOOD])}


@pytest.mark.parametrize(("km_h", "limit"), [(250.0, 0.1), (251.0, 0.2)])
def test_loss_of_contact(km_h: float, limit: float) -> None:
    facts = replace(FACTS, speed_km_h=km_h)
    assert verdict("contact_loss", facts, NQ_percent=limit).passed
    found = verdict("contact_loss", facts, NQ_percent=just_above(limit))
    assert found.passed is False
    assert found.mark == "C"


def test_losses_that_are_no_arcs_are_not_judged() -> None:
    assert verdict("contact_loss", contact_loss_percent=50.0, NQ_percent=0.0).passed


@pytest.mark.parametrize("mark", ["C", "C*", "assumed"])
def test_a_limit_that_was_not_read_shows_a_verdict_and_decides_nothing(mark: str) -> None:
    missed = replace(verdict("standard_deviation", std_force_N=80.0), mark=mark)
    assert (missed.passed, missed.fails) == (False, False)
    assert verdict_of(asdict(missed)) == NOT_MET_UNVERIFIED
    read = replace(missed, mark="A")
    assert read.fails
    assert verdict_of(asdict(read)) == NOT_MET


@pytest.mark.parametrize("mark", ["A", "A'", "B", "D"])
def test_a_limit_that_was_read_or_computed_decides(mark: str) -> None:
    assert replace(verdict("standard_deviation", std_force_N=80.0), mark=mark).fails


@pytest.mark.parametrize("name", ["mean_force", "statistical_max"])
def test_limits_of_a_supply_that_nobody_gave_decide_nothing(name: str) -> None:
    facts = replace(FACTS, supply_given=False)
    found = verdict(name, facts, mean_force_N=500.0, statistical_max_N=900.0)
    assert (found.passed, found.mark, found.fails) == (False, "assumed", False)
    # What holds for any supply goes on to decide.
    assert verdict("standard_deviation", facts, std_force_N=80.0).fails


def test_lateral_position_boundary() -> None:
    assert verdict("lateral_position", max_lateral_position_mm=400.0).passed
    found = verdict("lateral_position", max_lateral_position_mm=just_above(400.0))
    assert found.fails
    unsure = replace(FACTS, heads={"P1": HeadLimit(400.0, "C")})
    found = verdict("lateral_position", unsure, max_lateral_position_mm=500.0)
    assert (found.passed, found.mark, found.fails) == (False, "C", False)


def test_a_head_of_unknown_width_is_not_judged() -> None:
    found = verdict("lateral_position", replace(FACTS, heads={}))
    assert found.passed is None
    assert "head_width" in (found.reason or "")


@pytest.mark.parametrize(("limited", "highest"), [(False, 50.0), (True, 100.0 / 1.5)])
def test_uplift_needs_twice_or_one_and_a_half_times_its_space(limited, highest) -> None:
    facts = replace(FACTS, uplift_limited=limited, uplift_mm=highest * (1.0 - 1e-12))
    assert verdict("uplift_space", facts).passed
    assert not verdict("uplift_space", replace(facts, uplift_mm=highest * (1.0 + 1e-12))).passed


def test_wave_speed_boundary() -> None:
    assert verdict("wave_speed_use", replace(FACTS, wave_speed_use=0.7)).passed
    assert not verdict("wave_speed_use", replace(FACTS, wave_speed_use=just_above(0.7))).passed


@pytest.mark.parametrize(
    ("change", "reason"),
    [({"uplift_space_mm": None}, "design data"), ({"uplift_mm": None}, "record")],
)
def test_what_cannot_be_judged_has_no_verdict_and_a_reason(change: dict, reason: str) -> None:
    found = verdict("uplift_space", replace(FACTS, **change))
    assert found.passed is None
    assert reason in found.note


def test_no_uplift_at_all_is_judged() -> None:
    assert verdict("uplift_space", replace(FACTS, uplift_mm=0.0)).passed


def test_each_pantograph_is_judged_and_the_run_once() -> None:
    found = evaluate(FACTS, [GOOD, replace(GOOD, name="P2", std_force_N=80.0)])
    by_pantograph = {(c.name, c.pantograph): c.passed for c in found}
    assert by_pantograph["standard_deviation", "P1"] is True
    assert by_pantograph["standard_deviation", "P2"] is False
    assert ("wave_speed_use", None) in by_pantograph
    assert len(by_pantograph) == len(found)


@pytest.mark.parametrize("supply", ANY_SUPPLY)
@pytest.mark.parametrize("km_h", [0.0, 80.0, 200.0, 200.5, 250.0, 320.0, 320.5, 500.0])
def test_every_supply_and_speed_has_the_full_set(supply: str, km_h: float) -> None:
    names = [c.name for c in evaluate(replace(FACTS, supply=supply, speed_km_h=km_h), [GOOD])]
    everywhere = {rule.name for rule in RULES} - {"mean_force_lower"}
    assert everywhere <= set(names)
    assert len(names) == len(set(names))


def test_every_rule_has_source_and_mark() -> None:
    for rule in RULES:
        assert rule.source
        assert rule.mark in {"A", "B", "C"}
        assert ("memory" in rule.source) == (rule.mark == "C") or "taken over" in rule.note


@pytest.mark.parametrize("supply", ANY_SUPPLY)
def test_the_law_of_the_mean_force_says_that_tunnels_have_another(supply: str) -> None:
    found = verdict("mean_force", replace(FACTS, supply=supply))
    assert "open line" in found.note
    assert "tunnels" in found.note


@pytest.mark.parametrize(
    ("value", "limit", "unit", "decimals"),
    [
        (50.83, 50.79, "N", 2), (50.7912, 50.7902, "N", 1), (20.0, 50.0, "N", 1),
        (50.0, 50.0, "N", 1), (None, 50.0, "N", 1), (0.6961, 0.7, "1", 3), (190.0, 400.0, "mm", 0),
    ],
)  # fmt: skip
def test_two_numbers_that_differ_look_different(
    value: float | None, limit: float, unit: str, decimals: int
) -> None:
    assert decimals_of({"value": value, "limit": limit, "unit": unit}) == decimals


@pytest.mark.parametrize(
    ("certainty", "decimals", "words"),
    [
        # Known to 3 N: tenths are two digits of it, and hide the thousandth of a difference.
        ({"spread": 3.0, "discretisation": 0.0}, 1, "met, at the limit"),
        (None, 1, "met, at the limit"),
        # Known to 0.003 N: the difference of 0.001 N is shown.
        ({"spread": 0.003, "discretisation": 0.0}, 3, "met"),
    ],
)
def test_no_more_digits_than_are_known(certainty, decimals: int, words: str) -> None:
    near = replace(
        verdict("mean_force"), value=178.799, limit=178.8, passed=True, certainty=certainty
    )
    assert decimals_of(asdict(near)) == decimals
    assert shown_verdict(asdict(near)) == words
    assert repr(near).endswith(f": {words}>")


def test_only_a_hidden_difference_is_at_the_limit() -> None:
    for value, words in [(30.0, "met"), (30.004, "not met, at the limit"), (30.2, "not met")]:
        found = verdict("standard_deviation", mean_force_N=100.0, std_force_N=value)
        assert shown_verdict(asdict(found)) == words


def test_the_headline_counts_limits_that_are_not_verified() -> None:
    at_15_kV = evaluate(replace(FACTS, supply="AC 15 kV"), [GOOD])
    unverified = [one for one in at_15_kV if one.mark == "C"]
    assert len(unverified) > 1
    found = headline(at_15_kV)
    assert found.state == "met"
    assert found.text == (
        f"Met: all {len(at_15_kV)} criteria, {len(unverified)} of them against unverified limits"
    )
    (one, *_), sure = unverified, [each for each in at_15_kV if each.mark == "A"]
    assert headline([*sure, one]).text.endswith(", 1 of them against an unverified limit")
    assert headline(sure).text == f"Met: all {len(sure)} criteria"
    # A criterion that is not met leads, and the rest says the same of those that are.
    missed = replace(sure[0], value=1e4, passed=False)
    assert headline([missed, *sure[1:], one]).rest == (
        f"{len(sure)} met, 1 of them against an unverified limit"
    )
    assert headline([missed, one]).rest == "1 met against an unverified limit"


@pytest.mark.parametrize(
    ("km_h", "known_to", "chosen"),
    [
        (124.27424 * 1.609344, 0.05, 200.0),  # miles per hour, 2e-6 km/h above
        (200.0, 0.05, 200.0),
        (200.1, 0.05, 200.1),
        (250.0002, 0.5, 250.0),  # a measured mean
        (249.9998, 0.5, 250.0),
        (251.0, 0.5, 251.0),
    ],
)
def test_a_rounding_error_of_the_speed_chooses_no_limits(km_h, known_to, chosen) -> None:
    facts = Facts(supply="AC 25 kV", speed_km_h=km_h, speed_known_to_km_h=known_to)
    assert facts.class_speed_km_h == chosen
    assert bool(speed_notes(facts)) == (km_h > chosen)
