"""Faults that the checks of the elasticity under full weight notice."""

from collections.abc import Callable

from tests.support.faults import scaled
from tests.verification.closed_forms import test_elasticity_with_sag as checks

Noticed = Callable[..., None]


def test_messenger_wire_half_as_stiff(noticed: Noticed) -> None:
    with scaled("wires", "EA", 0.5):
        noticed("EA half as large, so that sag counts half", checks.test_fixed_ends)


def test_tension_1_percent_high(noticed: Noticed) -> None:
    with scaled("wires", "tension", 1.01):
        noticed("tensions 1 % too high", checks.test_fixed_ends)


def test_balance_weights_1_percent_heavy(noticed: Noticed) -> None:
    with scaled("ends", "force", 1.01):
        noticed("forces at the ends 1 % too high", checks.test_ends_under_constant_force)
