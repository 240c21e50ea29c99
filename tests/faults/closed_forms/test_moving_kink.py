"""Faults that a kink under a moving head must notice."""

from collections.abc import Callable
from unittest.mock import patch

import pytest

from tests.support.faults import plain_chains, scaled, unflexible
from tests.support.moving_runs import SPEEDS
from tests.verification.closed_forms import test_moving_kink as checks

Noticed = Callable[..., None]
TABLES = {"chain": "segments", "cubic": "wires"}


@pytest.mark.parametrize("name", TABLES)
def test_run_off(noticed: Noticed, name: str) -> None:
    case = {"name": name, "speed": SPEEDS[0]}
    with scaled("loads", "force", 1.03):
        noticed(f"{name}: kink 3 % too large", checks.test_kink, **case)
    with scaled(TABLES[name], "mass", 1.05):
        noticed(f"{name}: wire 5 % too heavy", checks.test_kink, **case)
    sound = checks.mass
    with patch.object(checks, "mass", lambda kilograms: sound(1.02 * kilograms)):
        noticed(f"{name}: head 2 % too heavy", checks.test_kink, **case)


def test_elements_off(noticed: Noticed) -> None:
    with unflexible():
        noticed("no residual flexibility", checks.test_kink, name="cubic", speed=SPEEDS[0])
    with plain_chains():
        noticed("points yield as those of a chain", checks.test_kink, name="chain", speed=SPEEDS[0])


def test_closed_form_of_another_speed(noticed: Noticed) -> None:
    sound = checks.closed_form
    with patch.object(checks, "closed_form", lambda w, v, k, t: sound(w, 1.02 * v, k, t)):
        noticed("wire across the track: 2 % too fast", checks.test_kink_in_space, name="cubic")
        noticed("rigid contact: 2 % too fast", checks.test_kink_under_a_rigid_contact, number=0)
        noticed("formula of another speed", checks.test_string_without_elements)
