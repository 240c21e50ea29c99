"""Expressions: what they give, what they refuse, and that nothing in them is executed."""

import pytest

from arcless.errors import ModelError
from arcless.study.definition.expressions import MAX_LENGTH, Expression, UndefinedError

VALUES = {"a": 3.0, "b": 4.0, "P2.a": 5.0, "none": None, "zero": 0.0}


def value(text: str) -> float | None:
    return Expression(text, list(VALUES)).value(VALUES)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a", 3.0),
        ("a + b * 2 - 1e1", 1.0),
        ("(a + b) / 2", 3.5),
        ("-a ** 2", -9.0),
        ("sqrt(a*a + b*b)", 5.0),
        ("max(a, b, P2.a) - min(a, b)", 2.0),
        ("abs(a - b)", 1.0),
        ("a < b", 1.0),
        ("1 < a <= 2", 0.0),
        ("(a > 2) * b", 4.0),
        ("a + none", None),
    ],
)
def test_values(text: str, expected: float | None) -> None:
    assert value(text) == expected


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("a / zero", "division by zero"),
        ("sqrt(-a)", "negative number"),
        ("(-a) ** 0.5", "negative number"),
        ("(9 ** 99) ** 99", "out of the range"),
        ("1e308 * 10", "out of the range"),
    ],
)
def test_undefined(text: str, reason: str) -> None:
    with pytest.raises(UndefinedError, match=reason):
        value(text)


@pytest.mark.parametrize(
    "text",
    [
        "", "a +", "a b", "a; b", "__import__('os')", "().__class__", "a.b.c.d", "[a]", "lambda: a",
        "a if b else 1", "'text'", "a and b", "True", "sqrt(a, b)", "max(a)", "max(a, key=b)",
        "min()", "exp(a)", "a := 1", "f'{a}'", "a[0]", "a @ b", "~a", "a % b", "1j", "a in b",
        "(" * 300 + "a" + ")" * 300, "a\0", "+" * (MAX_LENGTH + 1) + "a", "-" * MAX_LENGTH,
    ],
    ids=lambda text: text[:12],
)  # fmt: skip
def test_refused(text: str) -> None:
    with pytest.raises(ModelError, match=r"not an expression|unknown key"):
        Expression(text, list(VALUES))


def test_unknown_key_names_the_nearest() -> None:
    with pytest.raises(ModelError, match=r"did you mean mean_force_N\?"):
        Expression("2 * meanforce_N", ["mean_force_N", "std_force_N"])
