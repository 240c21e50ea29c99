"""The check of uplifts notices an uplift that is read from the wrong wire's support."""

from collections.abc import Callable

import pytest

from arcless.results import Result
from tests.support.python_faults import wrong
from tests.verification.references import test_uplift_of_pairs as checks

Noticed = Callable[..., None]


@pytest.mark.evidence
def test_half_of_the_uplift(noticed: Noticed, run_once: Callable[..., Result]) -> None:
    with wrong(checks, "uplift", lambda millimetres: 0.6 * millimetres):
        noticed(
            "40 % of the uplift lost", checks.test_published, run_once=run_once,
            scenario="spain-ca-200-200",
        )  # fmt: skip
