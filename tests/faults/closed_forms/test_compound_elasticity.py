"""The checks of a compound line's elasticity notice softer hangers and another tension."""

from collections.abc import Callable

from tests.support.faults import scaled
from tests.verification.closed_forms import test_compound_elasticity as checks

Noticed = Callable[..., None]


def test_hangers_1_percent_softer(noticed: Noticed) -> None:
    with scaled("links", "stiffness", 0.99):
        noticed("hangers 1 % softer", checks.test_elasticity)


def test_tension_1_percent_low(noticed: Noticed) -> None:
    with scaled("segments", "tension", 0.99):
        noticed("all tensions 1 % too low", checks.test_elasticity)
