"""Faults that the checks of the balance of forces notice."""

from collections.abc import Callable
from typing import Any
from unittest.mock import patch

import pytest

import arcless
from tests.support.faults import scaled, spoiled
from tests.verification.closed_forms import test_force_balance as checks

Noticed = Callable[..., None]
EACH = pytest.mark.parametrize("wires", checks.WIRES)


def afresh(name: str, changes: dict[str, Any]) -> arcless.simulate.StaticsResult:
    return arcless.statics(arcless.load(name).with_(**changes))


@EACH
def test_lower_clamps_lost(noticed: Noticed, wires: str) -> None:
    check = checks.test_droppers_carry_the_contact_wire
    with scaled("masses", "mass", 0.99):
        noticed("clamps 1 % too light", check, at_rest=afresh, wires=wires)


@EACH
def test_droppers_weigh_1_percent_less(noticed: Noticed, wires: str) -> None:
    with scaled("links", "mass", 0.99):
        noticed(
            "droppers 1 % too light", checks.test_supports_carry_all, at_rest=afresh, wires=wires
        )


@EACH
def test_wires_a_thousandth_heavy(noticed: Noticed, wires: str) -> None:
    with scaled("segments" if wires == "chains" else "wires", "mass", 1.001):
        noticed(
            "wires 0.1 % too heavy", checks.test_supports_carry_all, at_rest=afresh, wires=wires
        )


def test_the_other_law_of_stretching(noticed: Noticed) -> None:
    of_chains = {"chains": ({}, checks.green)}
    with patch.object(checks, "WIRES", of_chains):
        noticed(
            "chains that stretch like cubic elements",
            checks.test_supports_carry_all, at_rest=afresh, wires="chains",
        )  # fmt: skip


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
