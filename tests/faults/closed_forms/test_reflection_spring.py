"""Faults that reflections at springs and dampers must notice."""

from collections.abc import Callable

from tests.support.faults import scaled
from tests.verification.closed_forms import test_reflection_spring as checks

Noticed = Callable[..., None]


def test_spring_1_percent_stiff(noticed: Noticed) -> None:
    with scaled("springs", "stiffness", 1.01):
        fault = "spring 1 % too stiff"
        noticed(fault, checks.test_obstacle_on_a_wire, name="spring 5 kN/m")
        noticed(fault, checks.test_a_tuned_mass_on_a_spring_is_invisible)
        noticed(fault, checks.test_spring_on_a_chain_of_point_masses)


def test_damper_1_percent_off_or_forgotten(noticed: Noticed) -> None:
    name = "2 kg on 7.9 kN/m and 100 N s/m"
    with scaled("springs", "damping", 1.01):
        fault = "damper 1 % too strong"
        noticed(fault, checks.test_obstacle_on_a_wire, name="damper 300 N s/m")
        noticed(fault, checks.test_damper_at_the_end, share=1.0)
    with scaled("springs", "damping", 0.0):
        noticed("damper forgotten", checks.test_obstacle_on_a_wire, name=name)


def test_wire_1_percent_heavy(noticed: Noticed) -> None:
    with scaled("wires", "mass", 1.01):
        noticed("wire 1 % too heavy", checks.test_damper_at_the_end, share=0.5)
