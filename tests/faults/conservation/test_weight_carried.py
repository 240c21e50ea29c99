"""The check of carried weight notices gravity that is off, and wires that are too heavy."""

from collections.abc import Callable

from tests.support.faults import gravity, scaled
from tests.verification.conservation import test_weight_carried as checks

Noticed = Callable[..., None]


def test_gravity_5_percent_high(noticed: Noticed) -> None:
    with gravity(1.05):
        noticed("gravity 5 % too large", checks.test_weight, name="norway-s20a")


def test_a_rail_5_percent_heavier(noticed: Noticed) -> None:
    with scaled("wires", "mass", 1.05):
        noticed("wires 5 % too heavy", checks.test_weight, name="conductor-rail-1")
