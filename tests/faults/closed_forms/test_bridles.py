"""The checks of bridles notice what is wrong at their clamps."""

from collections.abc import Callable

from tests.support.faults import gravity, scaled
from tests.verification.closed_forms import test_bridles as checks

Noticed = Callable[..., None]


def test_gravity_too_large(noticed: Noticed) -> None:
    with gravity(1.01):
        noticed("gravity 1 % too large", checks.test_heights)
    with gravity(1.0001):
        noticed("gravity 0.01 % too large", checks.test_balance_at_the_clamps, kind="straight")


def test_bridles_too_loose(noticed: Noticed) -> None:
    with scaled("wires", "tension", 0.99, rows=slice(-40, None)):
        noticed("tension of the last wires 1 % too low", checks.test_heights)
