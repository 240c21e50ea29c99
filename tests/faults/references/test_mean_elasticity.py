"""The checks of remembered elasticities notice tensions and arms that are far off."""

from collections.abc import Callable

from tests.support import fresh
from tests.support.faults import scaled
from tests.support.python_faults import tension
from tests.verification.references import test_mean_elasticity as checks

Noticed = Callable[..., None]


def test_tension_of_one_wire_only(noticed: Noticed) -> None:
    with tension(0.85):
        noticed("all tensions 15 % too low", checks.test_rule_of_thumb, at_rest=fresh.at_rest)
    with tension(0.85):
        noticed("all tensions 15 % too low", checks.test_remembered, line="norway-s25")


def test_stiff_arms(noticed: Noticed) -> None:
    with scaled("springs", "stiffness", 10.0):
        noticed("arms ten times stiffer", checks.test_scratch_program, at_rest=fresh.at_rest)
