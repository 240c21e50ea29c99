"""Faults that the beam on a foundation must notice."""

from collections.abc import Callable

from tests.support.faults import scaled
from tests.verification.closed_forms import test_moving_force_beam as checks

Noticed = Callable[..., None]


def test_foundation_1_percent_off(noticed: Noticed) -> None:
    for column in ("stiffness", "damping"):
        with scaled("springs", column, 1.01):
            noticed(
                f"{column} of the foundation 1 % too large",
                checks.test_steady_state, name="rail", speed=60.0,
            )  # fmt: skip


def test_beam_1_percent_off(noticed: Noticed) -> None:
    for column in ("EI", "mass"):
        with scaled("wires", column, 1.01):
            noticed(
                f"{column} of the rail 1 % too large",
                checks.test_steady_state, name="rail", speed=30.0,
            )  # fmt: skip
    with scaled("wires", "tension", 1.01):
        noticed(
            "tension of the wire 1 % too large",
            checks.test_steady_state, name="contact wire", speed=60.0,
        )  # fmt: skip
