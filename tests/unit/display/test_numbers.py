"""Numbers as text."""

from arcless.display.numbers import difference, number, pair, real_minus, signed


def test_a_number_has_a_real_minus_sign_and_a_dash_where_there_is_none() -> None:
    assert number(None) == "–"
    assert number(-1.25, 2) == "−1.25"
    assert number(0.12345, 3) == "0.123"
    assert number(-0.04) == "0.0"


def test_a_signed_number_has_a_plus_or_a_real_minus_and_zero_has_none() -> None:
    assert [signed(value) for value in (10.73, -10.73, 0.0, -0.04)] == [
        "+10.7",
        "−10.7",
        "0.0",
        "0.0",
    ]
    assert signed(-0.04, 2) == "−0.04"
    assert signed(None) == "–"
    assert real_minus(f"{-1.2e-3:.3g}") == "−0.0012"


def test_an_uncertainty_is_shown_where_the_decimals_show_it() -> None:
    assert pair(60.82, 1.46, 1) == "60.8 ± 1.5"
    assert pair(60.82, 0.04, 1) == "60.8"
    assert pair(60.82, None, 1) == "60.8"
    assert pair(0.0, 0.0, 2) == "0.00"
    assert pair(None, None, 2) == "–"


def test_a_difference_is_that_of_the_numbers_as_they_are_printed() -> None:
    # 35.66 and 34.04 are 1.62 apart, and stand as 35.7 and 34.0.
    assert difference(35.66, 34.04, 1) == "1.7"
    assert difference(34.04, 35.66, 1) == "−1.7"
    assert difference(35.66, None, 1) == "–"
