"""Faults that a moving harmonic force and a trapped mode must notice."""

from collections.abc import Callable
from unittest.mock import patch

import pytest

from tests.support.faults import plain_chains, scaled, unflexible
from tests.support.moving_runs import SPEEDS
from tests.support.moving_wire import MovingWire
from tests.verification.closed_forms import test_moving_stiffness as checks

Noticed = Callable[..., None]
TABLES = {"chain": "segments", "cubic": "wires"}


@pytest.mark.parametrize("name", TABLES)
def test_wire_off(noticed: Noticed, name: str) -> None:
    with scaled(TABLES[name], "mass", 1.02):
        noticed(
            f"{name}: wire 2 % too heavy",
            checks.test_harmonic_force, name=name, speed=SPEEDS[0],
        )  # fmt: skip
    with scaled("springs", "stiffness", 1.02):
        noticed(f"{name}: foundation 2 % too stiff", checks.test_trapped_mode, name=name, speed=0.0)


def test_elements_off(noticed: Noticed) -> None:
    with unflexible():
        noticed("no residual flexibility", checks.test_harmonic_force_in_space, name="cubic")
    with plain_chains():
        noticed(
            "points yield as those of a chain", checks.test_harmonic_force_in_space, name="chain"
        )


def test_formula_off(noticed: Noticed) -> None:
    with patch.object(MovingWire, "stiffness", lambda own, omega: 344.7j * omega):
        noticed("a string's K without its foundation", checks.test_string)
