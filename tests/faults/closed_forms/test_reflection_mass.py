"""Faults that the reflection at a mass must notice."""

from collections.abc import Callable

from tests.support.faults import scaled
from tests.verification.closed_forms import test_reflection_mass as checks

Noticed = Callable[..., None]


def test_mass_1_percent_heavy(noticed: Noticed) -> None:
    with scaled("masses", "mass", 1.01):
        noticed("mass 1 % too heavy", checks.test_mass_on_a_wire, mass=2.0)
        noticed("mass 1 % too heavy", checks.test_mass_on_a_chain_of_point_masses)
        noticed("mass 1 % too heavy", checks.test_standing_waves_of_a_line_with_a_mass)


def test_wire_1_percent_off(noticed: Noticed) -> None:
    for column in ("tension", "mass", "EI"):
        with scaled("wires", column, 1.01):
            noticed(f"{column} of the wire 1 % too large", checks.test_mass_on_a_wire, mass=8.0)
    for column in ("tension", "mass"):
        with scaled("segments", column, 1.01):
            noticed(
                f"{column} of the chain 1 % too large",
                checks.test_mass_on_a_chain_of_point_masses,
            )
