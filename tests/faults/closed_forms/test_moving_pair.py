"""Faults that two strips on one wire must notice."""

from collections.abc import Callable
from unittest.mock import patch

import pytest

from tests.support.faults import scaled, unflexible
from tests.support.moving_runs import SPEEDS
from tests.verification.closed_forms import test_moving_pair as checks

Noticed = Callable[..., None]
TABLES = {"chain": "segments", "cubic": "wires"}


@pytest.mark.parametrize("name", TABLES)
def test_run_off(noticed: Noticed, name: str) -> None:
    case = {"name": name, "speed": SPEEDS[0]}
    with scaled(TABLES[name], "mass", 1.02):
        noticed(f"{name}: wire 2 % too heavy", checks.test_free_follower, slant=None, **case)
    sound = checks.mass
    with patch.object(
        checks, "mass", lambda *given: sound(*given[:2], *(1.05 * c for c in given[2:]))
    ):
        noticed(f"{name}: damper 5 % too strong", checks.test_damped_follower, **case)
    apart = checks.asked
    with patch.object(checks, "asked", lambda moving: apart(moving) * 1.02):
        noticed(f"{name}: closed form 2 % off", checks.test_damped_follower, **case)


def test_residual_flexibility_left_out(noticed: Noticed) -> None:
    with unflexible():
        noticed(
            "no residual flexibility", checks.test_damped_follower, name="cubic", speed=SPEEDS[0]
        )
