"""Faults that the checks of the elasticity notice."""

from collections.abc import Callable

from tests.support.faults import scaled
from tests.verification.closed_forms import test_elasticity as checks

Noticed = Callable[..., None]


def test_tension_a_thousandth_high(noticed: Noticed) -> None:
    with scaled("wires", "tension", 1.001):
        noticed("tension 0.1 % too high", checks.test_string_of_cubic_elements)
    with scaled("segments", "tension", 1.001):
        noticed("tension 0.1 % too high, chain", checks.test_string_of_point_masses)


def test_bending_stiffness_1_percent_high(noticed: Noticed) -> None:
    with scaled("wires", "EI", 1.01):
        noticed("EI 1 % too high", checks.test_beam)
        noticed("EI 1 % too high", checks.test_simple_line_of_beams)


def test_one_dropper_1_percent_soft(noticed: Noticed) -> None:
    with scaled("links", "stiffness", 0.99, [14]):
        noticed("one dropper 1 % too soft", checks.test_simple_line_of_strings, force=0.0)


def test_arms_and_supports_1_percent_stiff(noticed: Noticed) -> None:
    with scaled("springs", "stiffness", 1.01):
        noticed("arms and supports 1 % too stiff", checks.test_simple_line_of_strings, force=0.0)


def test_droppers_that_carry_too_little(noticed: Noticed) -> None:
    with scaled("segments", "mass", 0.999):
        noticed(
            "wires 0.1 % too light: droppers slacken earlier",
            checks.test_simple_line_of_strings,
            force=0.8,
        )
