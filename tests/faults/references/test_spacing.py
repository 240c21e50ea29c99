"""The checks of spacing notice deviations that belong to the wrong pantograph or speed."""

from collections.abc import Callable
from typing import Any
from unittest.mock import patch

from tests.verification.references import test_spacing as checks

Noticed = Callable[..., None]


def test_columns_swapped(noticed: Noticed) -> None:
    # As measured at 200 m: a single one 27.8 N, leading 27.9 N, trailing 61 N.
    def swapped(_: Any, distance: float | None) -> list[float]:
        return [27.8] if distance is None else [61.0, 27.9]

    with patch.object(checks.spacing, "deviations", swapped):
        noticed(
            "leading and trailing pantograph swapped",
            checks.test_the_trailing_pantograph_is_the_worse_one,
        )


def test_the_same_speed_twice(noticed: Noticed) -> None:
    # Trough and crest at 300 km/h, for both speeds.
    def one_speed(_: Any, distance: float | None) -> list[float]:
        return [27.9, 30.0 if distance == 160.0 else 60.0]

    with patch.object(checks.spacing, "deviations", one_speed):
        noticed("the same speed run twice", checks.test_good_and_bad_spacings_swap_with_the_speed)
