"""The coarse copy of a run: what is longer, when there is none, and that lines are shared."""

from typing import Any

import pytest

import arcless
from arcless.model import Scenario
from arcless.model.scenario.coarse_copy import MOST_OF_CHAIN, MOST_STEP, coarse
from arcless.simulate.batches.fingerprints import shared_key

SCENARIO = arcless.load("france-lgv-est-320")
MATRIX = {"solver.scheme": "generalised-alpha"}


def copied(scenario: Scenario) -> Scenario:
    found = coarse(scenario)
    assert found is not None
    return found


def ratios(scenario: Scenario) -> list[float]:
    """Return how much longer contact wire elements, other elements and the step of a copy are."""
    copy = copied(scenario)
    one, other = copy.stepping, scenario.stepping
    return [
        one.contact_wire_element_m / other.contact_wire_element_m,
        one.messenger_wire_element_m / other.messenger_wire_element_m,
        copy.time_step_s / scenario.time_step_s,
    ]


def test_explicit_steps_have_all_twice_as_long() -> None:
    assert ratios(SCENARIO) == pytest.approx([2.0, 2.0, 2.0])
    assert copied(SCENARIO).stepping.scheme.name == "central-difference"


def test_a_matrix_has_elements_half_as_long_again() -> None:
    assert ratios(SCENARIO.with_(**MATRIX)) == pytest.approx([1.5, 1.5, 2.0])


def test_a_copy_records_every_step_and_repeats_nothing() -> None:
    asked = SCENARIO.with_(**{"output.contact_every": 4, "certainty": 3})
    copy = copied(asked)
    assert copy.output.contact_every == 1
    assert copy.certainty is None
    assert copy.analysis_range() == asked.analysis_range()
    assert copy.travel_range() == asked.travel_range()


def test_no_copy_is_coarser_than_what_was_measured() -> None:
    long = {"contact_wire_element": 0.6, "messenger_wire_element": 0.6}
    given = {"scheme": "central-difference", "time_step": "1.3 ms", **long}
    scenario = SCENARIO.with_(**{f"solver.{key}": value for key, value in given.items()})
    copy = copied(scenario)
    assert copy.stepping.contact_wire_element_m == MOST_OF_CHAIN
    assert copy.time_step_s == MOST_STEP


@pytest.mark.parametrize(
    "changes",
    [
        {"solver.kinematics": "updated"},
        {**MATRIX, "solver.residual_flexibility": False},
        {**MATRIX, "solver.wire_model": "lumped"},
        {"solver.scheme": "backward-difference"},
        {"solver.scheme": {"name": "generalised-alpha", "spectral_radius": 0.5}},
        {"solver.scheme": {"name": "newmark", "beta": 0.3025, "gamma": 0.6}},
        {"solver.scheme": {"name": "hht", "alpha": -0.3}},
        {**MATRIX, "solver.time_step": "5 ms"},
        {"solver.time_step": "1 ms", "analysis.low_pass": "120 Hz"},
    ],
    ids=["updated", "not flexible", "chains", "first order", "damped", "newmark", "hht", "long",
         "filter"],
)  # fmt: skip
def test_what_a_copy_would_not_serve_has_none(changes: dict[str, Any]) -> None:
    assert coarse(SCENARIO.with_(**changes)) is None


@pytest.mark.parametrize("scheme", ["trapezoidal", "newmark", "hht"])
def test_schemes_that_hardly_damp_have_one(scheme: str) -> None:
    assert coarse(SCENARIO.with_(**{"solver.scheme": scheme})) is not None


@pytest.mark.parametrize(
    "changes",
    [{"speed": "319 km/h"}, {"analysis.low_pass": "21 Hz"}, {"output.contact_every": 2},
     {"pantographs.0.mean_force": "150 N"}],
    ids=["speed", "filter", "record", "force"],
)  # fmt: skip
def test_scenarios_that_share_a_line_share_that_of_their_copies(changes: dict[str, Any]) -> None:
    other = SCENARIO.with_(**changes)
    assert shared_key(other) == shared_key(SCENARIO)
    assert shared_key(copied(other)) == shared_key(copied(SCENARIO))
