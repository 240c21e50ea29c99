"""Faults that the speed of waves must notice."""

from collections.abc import Callable

from tests.support.faults import scaled
from tests.verification.closed_forms import test_wave_speed as checks

Noticed = Callable[..., None]


def test_wire_1_percent_off(noticed: Noticed) -> None:
    for column in ("tension", "mass"):
        with scaled("wires", column, 1.01):
            noticed(f"{column} of the wire 1 % too large", checks.test_centre_of_a_pulse)
        with scaled("segments", column, 1.01):
            noticed(
                f"{column} of the chain 1 % too large",
                checks.test_phase_speed_on_a_chain_of_point_masses,
            )
    with scaled("wires", "tension", 1.01):
        checked = checks.test_phase_speed_with_period_correction
        noticed("tension of the wire 1 % too large", checked, scheme=("generalised-alpha", [0.9]))
    with scaled("wires", "EI", 1.01):
        noticed("EI 1 % too large", checks.test_phase_speed, bending=200.0)


def test_axial_stiffness_1_percent_off(noticed: Noticed) -> None:
    with scaled("wires", "EA", 0.99):
        noticed("EA of the wire 1 % too small", checks.test_speed_along_the_wire, lumped=False)
        noticed("EA of the wire 1 % too small", checks.test_centre_of_a_pulse)
    with scaled("segments", "EA", 0.99):
        noticed("EA of the chain 1 % too small", checks.test_speed_along_the_wire, lumped=True)
