"""The checks of the conductor rail notice what is wrong with the rail or its supports."""

from collections.abc import Callable

from tests.support.faults import scaled
from tests.support.python_faults import tension
from tests.verification.closed_forms import test_conductor_rail as checks

Noticed = Callable[..., None]


def test_bending_stiffness_1_percent_high(noticed: Noticed) -> None:
    with scaled("wires", "EI", 1.01):
        noticed("EI 1 % too high", checks.test_sag, model="hermite")
    with scaled("bends", "EI", 1.01):
        noticed("EI of bends 1 % too high", checks.test_sag, model="lumped")
    with scaled("wires", "EI", 1.01):
        noticed("EI 1 % too high", checks.test_force_in_the_middle)
    with scaled("wires", "EI", 1.05):
        noticed("EI 5 % too high", checks.test_buckling_of_a_heated_rail)


def test_mass_1_percent_high(noticed: Noticed) -> None:
    with scaled("wires", "mass", 1.01):
        noticed("mass 1 % too high", checks.test_first_frequency)


def test_a_tension_left_over(noticed: Noticed) -> None:
    with tension(more=10.0):
        noticed("10 N of tension", checks.test_sag, model="hermite")
