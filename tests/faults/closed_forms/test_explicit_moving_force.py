"""Faults that the wire under a moving force must notice with explicit steps."""

from collections.abc import Callable
from unittest.mock import patch

import numpy as np

from tests.support.faults import plain_chains, scaled
from tests.support.pushing import press
from tests.verification.closed_forms import test_explicit_moving_force as checks

Noticed = Callable[..., None]


def test_wire_off(noticed: Noticed) -> None:
    for column in ("tension", "mass"):
        with scaled("segments", column, 1.001):
            noticed(
                f"{column} of the chain 0.1 % too large", checks.test_moving_force, name="string"
            )
    with scaled("bends", "EI", 1.01):
        noticed("EI 1 % too large", checks.test_moving_force, name="contact wire")
    with plain_chains():
        noticed("points yield as those of a chain", checks.test_moving_force, name="contact wire")
        noticed("chords between points", checks.test_moving_force, name="string")


def test_force_is_late(noticed: Noticed) -> None:
    def late(line, force, positions, speed, step, **options):  # type: ignore[no-untyped-def]
        return press(line, force, positions - 0.5 * speed * step, speed, step, **options)

    with patch.object(checks, "press", late):
        noticed("force half a step behind its place", checks.test_moving_force, name="string")


def test_other_elements(noticed: Noticed) -> None:
    with patch.object(checks, "X", np.linspace(0.0, checks.LENGTH, 121)):
        noticed("elements of 0.5 m in place of 0.45 m", checks.test_moving_force, name="string")
