"""Places and series that are asked for by name, and what is said of those that are none."""

from typing import Any

import pytest

import arcless
from arcless.dataset.recorded_series import asked_for
from arcless.errors import ModelError
from arcless.results import Result
from tests.support.synthetic import scenario_data, synthetic_dataset


@pytest.fixture(scope="module")
def result() -> Result:
    return Result(synthetic_dataset(), arcless.load(scenario_data()))


def test_a_place_and_a_series_that_are_there(result: Result) -> None:
    names = result.dataset["support"].values.tolist()
    assert asked_for(result.latest, "support", names[2]) == (2, "support_uplift")
    assert asked_for(result.latest, "dropper", "span 1 dropper 2", "dropper_force")[0] == 1


@pytest.mark.parametrize(
    ("asked", "words"),
    [
        (("support", "support 99"), r'unknown support: got "support 99", expected one of \d+, '
         r"support 1 to support \d+; hint: did you mean support 9\?"),
        (("support", 9), r"unknown support: got 9, .*did you mean support 9\?"),
        (("supports", "support 9"), 'unknown kind of place: got "supports", expected dropper or '
         r"support; hint: did you mean support\?"),
        (([], "support 9"), "unknown kind of place: got a list of 0"),
        (("dropper", "span 1 droper 2"), r"unknown dropper.*did you mean span 1 dropper 2\?"),
        (("support", "support 9", "suport_uplift"),
         r'unknown series of a support: got "suport_uplift", expected support_uplift.*'
         r"did you mean support_uplift\?"),
        (("support", "support 9", "dropper_force"), "unknown series of a support"),
        (("support", "support 9", "steady_arm_force"),
         "series of a support that was not recorded.*output.supports: true"),
    ],
)  # fmt: skip
def test_a_name_that_is_none_is_told_with_those_that_are(
    result: Result, asked: tuple[Any, ...], words: str
) -> None:
    with pytest.raises(ModelError, match=words):
        result.passage(*asked)


def test_a_line_without_droppers_has_none() -> None:
    bare = synthetic_dataset(without=("dropper_force",)).drop_dims("dropper")
    with pytest.raises(ModelError, match="the run has no dropper"):
        Result(bare, arcless.load(scenario_data())).passage("dropper", "span 1 dropper 1")
