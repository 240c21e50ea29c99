"""Faults that the checks of the tensioned beam notice."""

from collections.abc import Callable

from tests.support.faults import scaled
from tests.verification.closed_forms import test_tensioned_beam as checks

Noticed = Callable[..., None]


def test_bending_stiffness_a_thousandth_high(noticed: Noticed) -> None:
    with scaled("wires", "EI", 1.001):
        noticed("EI 0.1 % too high", checks.test_cubic_elements, load=0.0)
    with scaled("bends", "EI", 1.001):
        noticed("EI 0.1 % too high, chain", checks.test_chain_of_point_masses, load=0.0)


def test_one_bend_soft(noticed: Noticed) -> None:
    with scaled("bends", "EI", 0.99, [9]):
        noticed("one of 19 bends 1 % too soft", checks.test_chain_of_point_masses, load=0.0)


def test_tension_a_thousandth_high(noticed: Noticed) -> None:
    with scaled("wires", "tension", 1.001):
        noticed("tension 0.1 % too high", checks.test_cubic_elements, load=checks.LOAD)


def test_axial_stiffness_1_percent_high(noticed: Noticed) -> None:
    with scaled("wires", "EA", 1.01):
        noticed("EA 1 % too high", checks.test_cubic_elements, load=0.0)


def test_point_mass_a_thousandth_light(noticed: Noticed) -> None:
    with scaled("masses", "mass", 0.999):
        noticed("point mass 0.1 % too light", checks.test_sag_at_the_load)
