"""Faults that the checks of a shipped line's elasticity notice."""

from collections.abc import Callable

from tests.support.faults import scaled
from tests.verification.closed_forms import test_elasticity_shipped as checks

Noticed = Callable[..., None]


def test_tension_1_percent_high(noticed: Noticed) -> None:
    with scaled("wires", "tension", 1.01):
        noticed("tensions 1 % too high", checks.test_shipped_line, elements=(0.25, 0.25))


def test_arms_and_supports_20_percent_stiff(noticed: Noticed) -> None:
    with scaled("springs", "stiffness", 1.2):
        noticed("arms and supports 20 % too stiff", checks.test_shipped_line, elements=(1.45, 2.9))
