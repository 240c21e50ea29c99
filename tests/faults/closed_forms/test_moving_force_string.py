"""Faults that the wire under a moving force must notice."""

from collections.abc import Callable
from unittest.mock import patch

from tests.support import moving_force
from tests.support.faults import scaled
from tests.support.pushing import press
from tests.verification.closed_forms import test_moving_force_string as checks

Noticed = Callable[..., None]


def test_wire_1_percent_off(noticed: Noticed) -> None:
    for column in ("tension", "mass"):
        with scaled("wires", column, 1.01):
            noticed(
                f"{column} of the wire 1 % too large",
                checks.test_at_half_of_the_wave_speed, name="string",
            )  # fmt: skip
    with scaled("wires", "EI", 1.01):
        noticed(
            "EI 1 % too large",
            checks.test_at_half_of_the_wave_speed, name="contact wire",
        )  # fmt: skip


def test_force_is_late(noticed: Noticed) -> None:
    def late(line, force, positions, speed, step, **options):  # type: ignore[no-untyped-def]
        return press(line, force, positions - 0.5 * speed * step, speed, step, **options)

    with patch.object(moving_force, "press", late):
        noticed(
            "force half a step behind its place",
            checks.test_at_half_of_the_wave_speed, name="contact wire",
        )  # fmt: skip
