"""Faults that the Doppler factor must notice."""

from collections.abc import Callable
from unittest.mock import patch

from tests.support.faults import scaled
from tests.support.pushing import mass as one_mass
from tests.support.pushing import press
from tests.verification.closed_forms import test_doppler as checks

Noticed = Callable[..., None]


def test_string_1_percent_off(noticed: Noticed) -> None:
    with scaled("wires", "tension", 1.01):
        fault = "tension 1 % too large"
        noticed(fault, checks.test_tone_of_a_moving_force)
        noticed(fault, checks.test_echo_under_the_force)
        noticed(fault, checks.test_wave_thrown_back_by_a_moving_mass)


def test_force_is_late(noticed: Noticed) -> None:
    def late(line, force, positions, speed, step, **options):  # type: ignore[no-untyped-def]
        return press(line, force, positions - 0.5 * speed * step, speed, step, **options)

    with patch.object(checks, "press", late):
        noticed("force half a step behind its place", checks.test_tone_of_a_moving_force)


def test_moving_mass_1_percent_off(noticed: Noticed) -> None:
    with patch.object(checks, "mass", lambda kilograms: one_mass(1.01 * kilograms)):
        noticed("moving mass 1 % too heavy", checks.test_wave_thrown_back_by_a_moving_mass)
