"""The check of uplifts notices an uplift that is read over the wrong length of wire."""

from collections.abc import Callable
from unittest.mock import patch

from tests.verification.references import test_uplift_of_pairs as checks

Noticed = Callable[..., None]


def test_40_percent_of_the_uplift_lost(noticed: Noticed) -> None:
    # As measured: 42 mm.
    with patch.object(checks, "uplift", lambda _, __: 0.6 * 42.0):
        noticed(
            "40 % of the uplift lost", checks.test_published, run_once=None,
            scenario="spain-ca-200-200",
        )  # fmt: skip
