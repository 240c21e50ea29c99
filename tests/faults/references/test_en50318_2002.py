"""The checks of EN 50318:2002 notice supports and forces that are not the model's."""

from collections.abc import Callable

from tests.support import fresh
from tests.support.faults import scaled
from tests.support.run_faults import rider_scaled, start_force
from tests.verification.references import test_en50318_2002 as checks

Noticed = Callable[..., None]


def test_supports_ten_times_stiffer(noticed: Noticed) -> None:
    # The page's own table of choices: the standard deviation and three more go outside.
    with scaled("springs", "stiffness", 10.0):
        noticed(
            "all supports ten times stiffer", checks.test_ranges, run_once=fresh.run,
            speed="250 km/h",
        )  # fmt: skip


def test_a_softer_rider(noticed: Noticed) -> None:
    with rider_scaled("stiffness", 0.5):
        noticed(
            "springs of the pantograph halved", checks.test_ranges, run_once=fresh.run,
            speed="300 km/h",
        )  # fmt: skip


def test_less_preload(noticed: Noticed) -> None:
    with start_force(0.97):
        noticed(
            "3 % less preload than asked for", checks.test_mean_force_is_the_static_one,
            run_once=fresh.run, speed="300 km/h",
        )  # fmt: skip
