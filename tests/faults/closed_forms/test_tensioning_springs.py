"""The checks of tensioning springs notice what is wrong with wire or spring."""

from collections.abc import Callable

from tests.support.faults import misbuilt, scaled
from tests.verification.closed_forms import test_tensioning_springs as checks

Noticed = Callable[..., None]
STIFF = {"stiffness": 2e4, "difference": 30.0}


def test_axial_stiffness_5_percent_low(noticed: Noticed) -> None:
    with scaled("wires", "EA", 0.95):
        noticed("EA 5 % too low", checks.test_spring, **STIFF)


def test_spring_5_percent_soft(noticed: Noticed) -> None:
    with scaled("springs", "stiffness", 0.95):
        noticed("springs 5 % softer", checks.test_spring, **STIFF)


def test_expansion_1_percent_high(noticed: Noticed) -> None:
    with misbuilt("length_factor", lambda factor: 1.0 + 1.01 * (factor - 1.0)):
        noticed("wires expand 1 % too much", checks.test_travel_of_free_ends)
