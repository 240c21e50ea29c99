"""Faults that the checks of a wire that sags notice."""

from collections.abc import Callable

from tests.support.faults import gravity, scaled
from tests.verification.closed_forms import test_frequencies_with_sag as checks

Noticed = Callable[..., None]


def test_axial_stiffness_5_percent_low(noticed: Noticed) -> None:
    with scaled("wires", "EA", 0.95):
        noticed("EA 5 % too low", checks.test_frequencies)


def test_no_weight_on_the_shape(noticed: Noticed) -> None:
    with gravity(0.9):
        noticed("gravity 10 % too low, as if sag did not matter", checks.test_frequencies)


def test_mass_1_percent_high(noticed: Noticed) -> None:
    with scaled("wires", "mass", 1.01):
        noticed("mass 1 % too high", checks.test_frequencies)
