"""A comparison as columns."""

from types import SimpleNamespace
from typing import Any

from arcless.comparison.indicators import Indicator
from arcless.comparison.tables import number_columns


def compared(*, sure: float | None) -> Any:
    """Return what the columns are made of, of two runs with one number each."""
    one = Indicator("std_force_N", "standard deviation σ", "N", 1, "P1", (60.0, 45.0),
                    (None, None), (0.0, -15.0), (0.0, -25.0), (None, sure))  # fmt: skip
    return SimpleNamespace(names=("fast", "slow"), indicators=(one,))


def test_differences_are_to_the_first_run() -> None:
    columns = {one.header: one.values for one in number_columns(compared(sure=None))}
    assert columns["fast"] == [60.0]
    assert columns["slow: difference"] == [-15.0]
    assert columns["slow: difference [%]"] == [-25.0]
    assert "fast: difference" not in columns
    assert "slow: ± of the difference" not in columns


def test_how_sure_a_difference_is_has_a_column_where_that_is_known() -> None:
    columns = {one.header: one.values for one in number_columns(compared(sure=1.5))}
    assert columns["slow: ± of the difference"] == [1.5]
