"""What starts within a span notice: another pantograph, a spread of a mean, starts all alike."""

from collections.abc import Callable
from typing import Any

import pytest

from arcless.assess import certainty as sums
from arcless.simulate.certainty import other_starts
from tests.support.python_faults import wrong
from tests.verification.conservation import test_starts_within_a_span as topic

Noticed = Callable[..., None]


def test_a_force_that_is_not_carried_over(noticed: Noticed) -> None:
    with wrong(other_starts, "base_stiffness", lambda _stiffness: 0.0):
        noticed(
            "static force kept as a number at other starts",
            topic.test_the_mean_force_stays_what_was_asked_for,
        )


@pytest.mark.evidence
def test_a_spread_of_the_mean_over_starts(noticed: Noticed) -> None:
    with wrong(sums, "student_factor", lambda factor: factor / 8**0.5):
        noticed(
            "standard deviation divided by the root of the number of starts",
            topic.test_most_runs_lie_within_the_spread_of_their_mean,
        )


@pytest.mark.evidence
def test_starts_that_are_all_alike(noticed: Noticed) -> None:
    def alike(places: list[float]) -> list[float]:
        return [place if place == places[0] else places[0] + 0.5 for place in places]

    from arcless.simulate.certainty import runs_beside

    with wrong(runs_beside.starts, "places", alike):
        noticed(
            "other starts all half a metre further on",
            topic.test_the_spread_is_that_of_starts_at_random,
        )


def test_a_verdict_by_half_of_the_spread(noticed: Noticed) -> None:
    half: Any = property(lambda self: 0.5 * (self.spread or 0.0))
    real = sums.Certainty.uncertainty
    sums.Certainty.uncertainty = half  # type: ignore[method-assign]
    try:
        noticed(
            "half of the spread counts",
            topic.test_a_limit_within_the_spread_is_too_close_to_tell,
        )
    finally:
        sums.Certainty.uncertainty = real  # type: ignore[method-assign]
