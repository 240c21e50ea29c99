"""What other units notice: terms that do not belong together."""

from collections.abc import Callable
from unittest.mock import patch

from tests.support import scaling
from tests.verification.conservation import test_units

Noticed = Callable[..., None]


def exponents(kind: str, column: int, powers: scaling.Powers) -> dict[str, object]:
    columns = list(scaling.COLUMNS[kind])
    assert columns[column] != powers
    columns[column] = powers
    return {kind: tuple(columns)}


def test_a_stiffness_without_its_length(noticed: Noticed) -> None:
    test_units.in_si()
    # As if a formula took EI for N m.
    with patch.dict(scaling.COLUMNS, exponents("wires", 2, scaling.ENERGY)):
        noticed("EI counted in N m", test_units.test_length)


def test_a_damping_without_its_time(noticed: Noticed) -> None:
    test_units.in_si()
    with patch.dict(scaling.COLUMNS, exponents("wires", 5, scaling.NUMBER)):
        noticed("β counted as a number", test_units.test_mass_and_time)


def test_a_rate_without_its_time(noticed: Noticed) -> None:
    test_units.in_si()
    with patch.dict(scaling.COLUMNS, exponents("masses", 1, scaling.NUMBER)):
        noticed("α of the clamps counted as a number", test_units.test_decimal_units)
