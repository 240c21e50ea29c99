"""The checks of remembered elasticities notice tensions that are far off."""

from collections.abc import Callable

from tests.support.python_faults import tension
from tests.verification.references import test_mean_elasticity as checks

Noticed = Callable[..., None]


def test_tensions_15_percent_low(noticed: Noticed) -> None:
    with tension(0.85):
        noticed("all tensions 15 % too low", checks.test_remembered, line="norway-s25")
