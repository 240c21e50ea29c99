"""Faults that the checks of the balance of forces notice."""

from collections.abc import Callable

import arcless
from tests.support.faults import scaled, spoiled
from tests.verification.closed_forms import test_force_balance as checks

Noticed = Callable[..., None]


def afresh(name: str) -> arcless.simulate.StaticsResult:
    return arcless.statics(arcless.load(name))


def test_lower_clamps_lost(noticed: Noticed) -> None:
    with scaled("masses", "mass", 0.99):
        noticed("clamps 1 % too light", checks.test_droppers_carry_the_contact_wire, at_rest=afresh)


def test_droppers_weigh_1_percent_less(noticed: Noticed) -> None:
    with scaled("links", "mass", 0.99):
        noticed("droppers 1 % too light", checks.test_supports_carry_all, at_rest=afresh)


def test_messenger_wire_a_thousandth_heavy(noticed: Noticed) -> None:
    with scaled("wires", "mass", 1.001):
        noticed("wires 0.1 % too heavy", checks.test_supports_carry_all, at_rest=afresh)


def test_one_support_shifted_across(noticed: Noticed) -> None:
    def shift(arguments: dict) -> bool:
        across = arguments["positions"][:, 1]
        across[across > 0.15] += 1e-3
        return bool((across > 0.15).any())

    with spoiled(shift):
        noticed("stagger 1 mm too large on one side", checks.test_arms_hold_the_stagger)


def test_tension_a_thousandth_high(noticed: Noticed) -> None:
    with scaled("segments", "tension", 1.001):
        noticed("tension 0.1 % too high", checks.test_arms_hold_the_stagger)
