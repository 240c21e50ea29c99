"""Numbers of a study's report: four digits, one number of decimals for a column."""

import numpy as np
import pytest

from arcless.study.report.data.numbers import column_texts, decimals, digits, form


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "0"), (200.00000000000003, "200"), (50.7912, "50.79"), (-5.0, "−5"),
        (123456.7, "123457"), (0.00021774, "0.0002177"), (2.5e9, "2.500e+09"),
        (3e-7, "3.000e−07"), (None, "–"), (float("nan"), "–"), (1e-3, "0.001"),
    ],
)  # fmt: skip
def test_four_digits(value: float | None, text: str) -> None:
    assert digits(value) == text


def test_a_column_has_one_number_of_decimals() -> None:
    assert column_texts(np.array([9.5, 10.25, 350.0, np.nan])) == ["9.5", "10.2", "350.0", "–"]
    assert column_texts(np.array([200.0, 320.0])) == ["200", "320"]
    assert form(np.array([9.5, 10.25, 350.0])) == "0.0"
    assert form(np.array([200.0, 320.0])) == "0"


def test_numbers_that_would_be_zero_have_their_own_digits() -> None:
    values = np.array([0.0, 0.0004, 120.0])
    assert decimals(values) is None
    assert column_texts(values) == ["0", "0.0004", "120"]
    assert form(values) == "0.000e+0"
    assert decimals(np.array([np.nan])) == 0
