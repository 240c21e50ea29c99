"""Faults that the checks of the natural frequencies notice."""

from collections.abc import Callable

from tests.support.faults import scaled
from tests.verification.closed_forms import test_frequencies as checks

Noticed = Callable[..., None]


def test_bending_stiffness_a_thousandth_high(noticed: Noticed) -> None:
    with scaled("wires", "EI", 1.001):
        noticed("EI 0.1 % too high", checks.test_across)
    with scaled("bends", "EI", 1.001):
        noticed("EI 0.1 % too high, chain", checks.test_a_chain_has_its_own)


def test_mass_a_thousandth_high(noticed: Noticed) -> None:
    with scaled("wires", "mass", 1.001):
        noticed("mass 0.1 % too high", checks.test_across)
    with scaled("wires", "mass", 1.01):
        noticed("mass 1 % too high", checks.test_wave_speed_of_the_shipped_wire)
    with scaled("segments", "mass", 1.001, [7]):
        noticed("one of 40 segments 0.1 % too heavy", checks.test_a_chain_has_its_own)


def test_axial_stiffness_1_percent_high(noticed: Noticed) -> None:
    with scaled("wires", "EA", 1.01):
        noticed("EA 1 % too high", checks.test_cubic_elements_have_their_own)
        noticed("EA 1 % too high", checks.test_along)


def test_tension_a_thousandth_low(noticed: Noticed) -> None:
    with scaled("wires", "tension", 0.999):
        noticed("tension 0.1 % too low", checks.test_across)


def test_one_element_a_thousandth_stiff(noticed: Noticed) -> None:
    with scaled("wires", "EI", 1.001, [3]):
        noticed(
            "one of 40 elements bends too little by 0.1 %",
            checks.test_cubic_elements_have_their_own,
        )
