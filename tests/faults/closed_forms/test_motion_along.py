"""The checks of motion along the wire notice another tension, and an end that does not move."""

from collections.abc import Callable

from tests.support.python_faults import set_gravity, tension
from tests.verification.closed_forms import test_motion_along as checks

Noticed = Callable[..., None]


def test_tension_1_percent_high(noticed: Noticed) -> None:
    check = checks.test_slopes_draw_the_wire_towards_its_fixed_end
    with tension(1.01):
        noticed("tension 1 % too high", check)


def test_a_wire_that_is_not_straight(noticed: Noticed) -> None:
    with set_gravity(9.81):
        noticed("weight, and so a sag", checks.test_linearised_motion_has_no_such_part)
