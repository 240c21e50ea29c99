"""Faults that a head on a moving contact must notice."""

from collections.abc import Callable
from unittest.mock import patch

import pytest

from tests.support.faults import scaled, unflexible
from tests.support.moving_runs import SPEEDS
from tests.verification.closed_forms import test_moving_head as checks

Noticed = Callable[..., None]
TABLES = {"chain": "segments", "cubic": "wires"}


@pytest.mark.parametrize("name", TABLES)
def test_run_off(noticed: Noticed, name: str) -> None:
    case = {"name": name, "speed": SPEEDS[0]}
    with scaled(TABLES[name], "mass", 1.05):
        noticed(f"{name}: wire 5 % too heavy", checks.test_thrown_head, **case)
        noticed(f"{name}: wire 5 % too heavy", checks.test_head_on_a_spring, **case)
    sound = checks.mass
    with patch.object(checks, "mass", lambda *given: sound(1.02 * given[0], *given[1:])):
        noticed(f"{name}: head 2 % too heavy", checks.test_thrown_head, **case)
    with patch.object(checks, "mass", lambda *given: sound(given[0], 1.05 * given[1])):
        noticed(f"{name}: spring 5 % too stiff", checks.test_head_on_a_spring, **case)


def test_residual_flexibility_left_out(noticed: Noticed) -> None:
    with unflexible():
        noticed("no residual flexibility", checks.test_thrown_head, name="cubic", speed=SPEEDS[0])
        noticed("no residual flexibility", checks.test_head_on_a_spring_in_space, name="cubic")
