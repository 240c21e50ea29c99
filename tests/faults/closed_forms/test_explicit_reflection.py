"""Faults that reflections under explicit steps must notice."""

from collections.abc import Callable
from unittest.mock import patch

import numpy as np

from tests.support.faults import plain_chains, scaled
from tests.verification.closed_forms import test_explicit_reflection as checks

Noticed = Callable[..., None]
SPRING, DAMPER = checks.OBSTACLES


def test_obstacle_1_percent_off(noticed: Noticed) -> None:
    with scaled("springs", "stiffness", 1.01):
        noticed("spring 1 % too stiff", checks.test_spring_and_damper, name=SPRING)
    with scaled("springs", "damping", 1.01):
        noticed("damper 1 % too strong", checks.test_spring_and_damper, name=DAMPER)
    with scaled("masses", "mass", 1.01):
        noticed("mass 1 % too heavy", checks.test_mass, mass=2.0)
    for column in ("stiffness", "damping"):
        with scaled("links", column, 1.01):
            noticed(f"{column} of the dropper 1 % too large", checks.test_taut_dropper)


def test_wire_off(noticed: Noticed) -> None:
    for column in ("tension", "mass"):
        with scaled("segments", column, 1.001):
            noticed(f"{column} of the chain 0.1 % too large", checks.test_mass, mass=8.0)
    with scaled("bends", "EI", 1.01):
        noticed("EI 1 % too large", checks.test_taut_dropper)
    with plain_chains():
        noticed("points yield as those of a chain", checks.test_spring_and_damper, name=SPRING)


def test_other_elements(noticed: Noticed) -> None:
    with patch.object(checks, "X", np.arange(-40.0, 280.2, 0.4)):
        noticed("masses 0.4 m apart in place of 0.5 m", checks.test_taut_dropper)
