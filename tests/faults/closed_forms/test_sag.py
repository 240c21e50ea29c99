"""Faults that the checks of the sag notice."""

from collections.abc import Callable

import pytest

from tests.support.faults import gravity, scaled
from tests.verification.closed_forms import test_sag

Noticed = Callable[..., None]


def test_axial_stiffness_1_percent_high(noticed: Noticed) -> None:
    with scaled("wires", "EA", 1.01):
        noticed("EA 1 % too high", test_sag.test_sag_of_a_taut_wire)


def test_mass_1_percent_high(noticed: Noticed) -> None:
    with scaled("wires", "mass", 1.01):
        noticed("mass of the wire 1 % too high", test_sag.test_parabola)
        noticed("mass of the wire 1 % too high", test_sag.test_shape_of_a_slack_wire, rise=3.0)


@pytest.mark.parametrize("kind", ["wires", "segments"])
def test_tension_a_thousandth_high(noticed: Noticed, kind: str) -> None:
    check = {
        "wires": test_sag.test_tension_of_cubic_elements,
        "segments": test_sag.test_shape_of_a_chain,
    }[kind]
    with scaled(kind, "tension", 1.001):
        noticed(f"tension 0.1 % too high, {kind}", check)


def test_gravity_a_thousandth_high(noticed: Noticed) -> None:
    with gravity(1.001):
        noticed("gravity 0.1 % too high", test_sag.test_sag_of_a_taut_wire)
        noticed("gravity 0.1 % too high", test_sag.test_tension_of_a_chain)


def test_one_element_too_light(noticed: Noticed) -> None:
    with scaled("wires", "mass", 0.99, [30]):
        noticed(
            "one of sixty elements 1 % too light", test_sag.test_shape_of_a_slack_wire, rise=0.0
        )
