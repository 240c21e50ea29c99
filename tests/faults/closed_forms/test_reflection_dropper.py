"""Faults that the scattering at a dropper must notice."""

from collections.abc import Callable
from typing import Any

from tests.support.faults import COLUMNS, scaled, spoiled
from tests.verification.closed_forms import test_reflection_dropper as checks

Noticed = Callable[..., None]


def test_dropper_1_percent_off(noticed: Noticed) -> None:
    for column in ("stiffness", "damping", "mass"):
        with scaled("links", column, 1.01):
            noticed(f"{column} of the dropper 1 % too large", checks.test_taut_dropper)
    with scaled("masses", "mass", 0.0):
        noticed("clamps forgotten", checks.test_taut_dropper)


def test_other_wire_1_percent_heavy(noticed: Noticed) -> None:
    def spoil(arguments: dict[str, Any]) -> bool:
        mass = arguments["parts"]["wires"][1][:, COLUMNS["wires"].index("mass")]
        other = mass == checks.WIRES[1].mass
        mass[other] *= 1.01
        return bool(other.any())

    with spoiled(spoil):
        noticed("other wire 1 % too heavy", checks.test_taut_dropper)
        noticed("other wire 1 % too heavy", checks.test_dropper_that_goes_slack)


def test_dropper_that_pushes(noticed: Noticed) -> None:
    def spoil(arguments: dict[str, Any]) -> bool:
        arguments["parts"]["links"][0][:, 2] = 0
        return len(arguments["parts"]["links"][0]) > 0

    with spoiled(spoil):
        noticed("the dropper can push", checks.test_dropper_that_goes_slack)
    with scaled("links", "stiffness", 1.01):
        noticed("stiffness of the dropper 1 % too large", checks.test_dropper_that_goes_slack)
