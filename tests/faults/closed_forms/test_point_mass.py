"""The checks of a mass on a wire notice another mass, density or tension."""

from collections.abc import Callable

from tests.support.faults import scaled
from tests.support.python_faults import tension
from tests.verification.closed_forms import test_point_mass as checks

Noticed = Callable[..., None]


def test_mass_1_percent_light(noticed: Noticed) -> None:
    with scaled("masses", "mass", 0.99):
        noticed("mass 1 % too light", checks.test_sag_below_a_mass, model="hermite")


def test_tension_1_percent_high(noticed: Noticed) -> None:
    with tension(1.01):
        noticed("tension 1 % too high", checks.test_sag_below_a_mass, model="lumped")


def test_density_1_percent_high(noticed: Noticed) -> None:
    with scaled("wires", "mass", 1.01):
        noticed("mass of the wires 1 % too high", checks.test_frequencies_with_an_insert)
