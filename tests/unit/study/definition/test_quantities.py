"""Keys of outputs: of the leading pantograph, of one by name, of the one where it is worst."""

from dataclasses import replace

import numpy as np
import pytest

import arcless
from arcless.assess import Assessment
from arcless.assess.criteria import RELATIONS
from arcless.model import Scenario
from arcless.study.definition.quantities import (
    WORST,
    criterion_of,
    keys,
    owner_of_key,
    unit_of_key,
    values,
)
from tests.support.studies import study


@pytest.fixture(scope="module")
def two() -> Assessment:
    """Return an assessment with two pantographs, of which the second one has other numbers."""
    found = arcless.run(study().base).assessment
    (first,) = found.pantographs
    second = replace(
        first, name="rear", std_force_N=first.std_force_N + 1.0, min_force_N=first.min_force_N + 2.0
    )
    return replace(found, pantographs=[first, second])


def scenario() -> Scenario:
    return arcless.load("ac-simple-320-two-pantographs")


def test_the_worst_is_the_highest_or_the_lowest(two: Assessment) -> None:
    found = values(two)
    assert found["worst.std_force_N"] == found["P2.std_force_N"] == found["rear.std_force_N"]
    assert found["worst.std_force_N"] != found["std_force_N"]
    assert found["worst.min_force_N"] == found["min_force_N"] == found["P1.min_force_N"]


def test_without_one_of_them_there_is_no_worst(two: Assessment) -> None:
    first, second = two.pantographs
    found = values(replace(two, pantographs=[first, replace(second, max_gap_mm=None)]))
    assert found["worst.max_gap_mm"] is None
    assert found["max_gap_mm"] == first.max_gap_mm


def test_a_pantograph_that_is_called_worst_keeps_its_name(two: Assessment) -> None:
    first, second = two.pantographs
    found = values(replace(two, pantographs=[replace(first, name=WORST), second]))
    assert found["worst.std_force_N"] == first.std_force_N
    named = scenario().with_(**{"pantographs.0.name": WORST})
    assert keys(named).count("worst.std_force_N") == 1
    assert owner_of_key("worst.std_force_N", named) == 0


def test_keys_and_their_pantographs() -> None:
    made = scenario()
    known = keys(made)
    assert "worst.std_force_N" in known
    assert "worst.mean_force_N" not in known  # too high or too low: no end is the worse one
    assert "worst.wear_total_mm3_km" not in known  # the scenario has no coefficients of wear
    owners = {
        "std_force_N": 0, "P1.std_force_N": 0, "trailing.std_force_N": 1, "P2.max_force_N": 1,
        "worst.max_force_N": WORST, "max_uplift_at_support_mm": None, "passed": None,
        "criteria.mean_force": None,
    }  # fmt: skip
    assert {key: owner_of_key(key, made) for key in owners} == owners


def test_numbers_of_criteria_are_those_nearest_to_the_limit(two: Assessment) -> None:
    # The second pantograph is the nearer one to every other limit.
    rear = [
        replace(item, pantograph="rear", value=item.value + (-1.0) ** place)
        for place, item in enumerate(two.criteria)
        if item.value is not None
    ]
    two = replace(two, criteria=[*two.criteria, *rear])
    found, known = values(two), keys(scenario())
    for name in {item.name for item in two.criteria}:
        items = [item for item in two.criteria if item.name == name]
        judged = [item for item in items if item.value is not None and item.limit is not None]
        margin = found[f"criteria.{name}.margin"]
        assert {f"criteria.{name}.{key}" for key in ("value", "limit", "margin")} <= set(known)
        if not judged:
            assert margin is None
            continue
        left = {
            item.pantograph: (item.limit + item.tolerance) - item.value
            if item.relation == "<="
            else item.value - (item.limit - item.tolerance)
            for item in judged
        }
        assert margin == min(left.values())
        nearest = next(item for item in judged if left[item.pantograph] == margin)
        assert found[f"criteria.{name}.value"] == nearest.value
        assert found[f"criteria.{name}.limit"] == nearest.limit
    assert unit_of_key("criteria.statistical_max.margin") == "N"
    assert unit_of_key("criteria.statistical_max") == ""
    assert unit_of_key("criteria.wave_speed_use.limit") == ""
    assert criterion_of("criteria.statistical_max.middle") is None


def test_a_margin_has_the_tolerance_of_its_limit_in_it(two: Assessment) -> None:
    made = replace(two.criteria[0], name="mean_force", relation="<=", limit=116.948, tolerance=1.0)
    ends = [117.496, 117.948, np.nextafter(117.948, 200.0), 119.0]
    for value, met in zip(ends, [True, True, False, False], strict=True):
        one = replace(made, value=float(value))
        found = values(replace(two, criteria=[one]))
        margin = found["criteria.mean_force.margin"]
        assert margin is not None
        assert (margin >= 0.0) is met is RELATIONS["<="](one.value or 0.0, 116.948, 1.0)
        assert found["criteria.mean_force.limit"] == 116.948


def test_an_output_may_be_the_worst() -> None:
    made = study(scenario="ac-simple-320-two-pantographs", set={},
                 outputs={"s": "worst.std_force_N / 2"})  # fmt: skip
    assert made.expressions["s"].names == {"worst.std_force_N"}
