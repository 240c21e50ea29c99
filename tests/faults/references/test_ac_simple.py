"""The checks of AC simple notice a filter that is left out and a search that stops early."""

from collections.abc import Callable
from unittest.mock import patch

from arcless.assess import statistics
from arcless.results import Result
from arcless.simulate.runs import job, mean_force
from tests.support import fresh
from tests.verification.references import test_ac_simple as checks

Noticed = Callable[..., None]


def test_no_filter(noticed: Noticed, run_once: Callable[..., Result]) -> None:
    with patch.object(statistics, "low_pass", lambda signal, *_: signal):
        known = run_once("en50318-ac-simple-275")

        def assessed_anew(_: str) -> Result:
            return Result(known.dataset, known.scenario)

        noticed(
            "the 20 Hz filter left out", checks.test_ranges, run_once=assessed_anew,
            name="en50318-ac-simple-275",
        )  # fmt: skip


def test_search_for_the_static_force_stops_early(noticed: Noticed) -> None:
    # A coarse copy would have told the force before.
    no_copy = patch.object(job, "coarse", lambda _: None)
    with no_copy, patch.object(mean_force, "TOLERANCE", 1.0):
        noticed(
            "search for the static force stops at 1 N", checks.test_mean_force,
            run_once=fresh.run, name="en50318-ac-simple-320",
        )  # fmt: skip
