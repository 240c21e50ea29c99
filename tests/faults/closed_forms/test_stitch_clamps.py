"""The checks of stitch wires notice another weight, and a tension that is not the one asked for."""

from collections.abc import Callable

from tests.support.faults import gravity, scaled
from tests.verification.closed_forms import test_stitch_clamps as checks

Noticed = Callable[..., None]


def test_gravity_a_ten_thousandth_too_large(noticed: Noticed) -> None:
    with gravity(1.0001):
        noticed("gravity 0.01 % too large", checks.test_balance, kind="straight")


def test_one_tension_1_percent_high(noticed: Noticed) -> None:
    with scaled("segments", "tension", 1.01, rows=slice(40, 41)):
        noticed("tension of one segment 1 % too high", checks.test_balance, kind="staggered")
