"""Faults that the checks of the change of state notice."""

from collections.abc import Callable

from tests.support.faults import misbuilt, scaled
from tests.verification.closed_forms import test_change_of_state as checks

Noticed = Callable[..., None]


def test_expansion_1_percent_high(noticed: Noticed) -> None:
    with misbuilt("length_factor", lambda factor: 1.0 + 1.01 * (factor - 1.0)):
        noticed("α 1 % too high", checks.test_the_cubic_equation, state="hot")
        noticed("α 1 % too high", checks.test_tension_of_a_chain, case="fixed ends")
        noticed("α 1 % too high", checks.test_way_of_an_end_under_constant_force, model="hermite")


def test_a_wire_that_grows_heavier_as_it_grows_longer(noticed: Noticed) -> None:
    with misbuilt("mass", lambda mass: mass * (1.0 + 17e-6 * 80.0)):
        noticed(
            "mass per metre as if still cold",
            checks.test_tension_of_cubic_elements,
            case="fixed ends",
        )


def test_ice_1_percent_light(noticed: Noticed) -> None:
    with misbuilt("mass", lambda mass: mass - 0.01 * 1.5 * (mass > 2.0)):
        noticed("ice 1 % too light", checks.test_way_of_an_end_under_constant_force, model="lumped")


def test_axial_stiffness_1_percent_high(noticed: Noticed) -> None:
    for kind, check in (
        ("wires", checks.test_tension_of_cubic_elements),
        ("segments", checks.test_tension_of_a_chain),
    ):
        with scaled(kind, "EA", 1.01):
            noticed(f"EA 1 % too high, {kind}", check, case="fixed ends")


def test_tensioning_spring_1_percent_soft(noticed: Noticed) -> None:
    with scaled("springs", "stiffness", 0.99):
        noticed(
            "spring 1 % too soft",
            checks.test_tension_of_cubic_elements,
            case="tensioning spring",
        )
