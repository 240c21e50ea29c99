"""Each distribution: quantiles against closed forms, and moments of many evenly spread points."""

import math
from typing import Any

import numpy as np
import pytest

from arcless.errors import ModelError
from arcless.model.fields.part import Unit
from arcless.study.variables.variables import Axis, Variable, axis

FORCE = Unit("N")
# Midpoints of 20 000 equal parts: what they leave out of a tail shows in the fourth digit.
POINTS = (np.arange(20_000) + 0.5) / 20_000


def made(unit: Unit | None = FORCE, **distribution: Any) -> Axis:
    variable = Variable(field="speed", distribution=distribution)  # type: ignore[arg-type]
    return axis("x", variable, "speed", unit)


def drawn(**distribution: Any) -> np.ndarray:
    quantile = made(**distribution).quantile
    return np.array([quantile(u) for u in POINTS])


@pytest.mark.parametrize(
    ("distribution", "mean", "deviation"),
    [
        ({"kind": "uniform", "low": "1 kN", "high": 3000}, 2000.0, 2000.0 / math.sqrt(12)),
        ({"kind": "normal", "mean": "1 kN", "standard_deviation": "50 N"}, 1000.0, 50.0),
        ({"kind": "lognormal", "mean": "1 kN", "standard_deviation": "300 N"}, 1000.0, 300.0),
        # Symmetric about its mode: variance w²/24.
        (
            {"kind": "triangular", "low": 0, "mode": 60, "high": 120},
            60.0,
            120.0 / math.sqrt(24.0),
        ),
        # A half-normal: mean σ√(2/π), variance σ²(1 − 2/π).
        (
            {
                "kind": "truncated-normal",
                "mean": 0,
                "standard_deviation": 10,
                "low": 0,
                "high": 1e3,
            },
            10.0 * math.sqrt(2.0 / math.pi),
            10.0 * math.sqrt(1.0 - 2.0 / math.pi),
        ),
    ],
    ids=lambda value: value["kind"] if isinstance(value, dict) else "",
)
def test_moments(distribution: dict[str, Any], mean: float, deviation: float) -> None:
    values = drawn(**distribution)
    assert np.all(np.diff(values) > 0.0)
    # The ends of 20 000 parts carry some 1e-4 of a mean and a thousandth of a spread.
    assert values.mean() == pytest.approx(mean, rel=2e-4)
    assert values.std() == pytest.approx(deviation, rel=3e-3)


def test_a_truncated_tail_keeps_its_digits() -> None:
    quantile = made(kind="truncated-normal", mean=0, standard_deviation=1, low=12, high=13).quantile
    # Far out the density falls as exp(−12 x): the median is ln 2/12 beyond the bound, within its
    # own curvature 1/12².
    assert quantile(0.5) == pytest.approx(12.0 + math.log(2.0) / 12.0, abs=1.0 / 144.0)
    assert 12.0 < quantile(0.1) < quantile(0.9) < 13.0


def test_choice_by_weights() -> None:
    values = drawn(kind="choice", values=["1 kN", 2000], weights=[1, 3])
    assert sorted(set(values.tolist())) == [1000.0, 2000.0]
    assert (values == 2000.0).mean() == 0.75


@pytest.mark.parametrize(
    ("distribution", "message"),
    [
        ({"kind": "uniform", "low": 3, "high": 3}, "empty range"),
        ({"kind": "triangular", "low": 1, "mode": 4, "high": 3}, "empty range"),
        ({"kind": "normal", "mean": 1, "standard_deviation": 0}, "not positive"),
        ({"kind": "normal", "mean": "1 kg", "standard_deviation": 1}, "a force"),
        ({"kind": "lognormal", "mean": -1, "standard_deviation": 1}, "not positive"),
        (
            {"kind": "truncated-normal", "mean": 0, "standard_deviation": 1, "low": 50, "high": 60},
            "nothing between the bounds",
        ),
        ({"kind": "choice", "values": [1], "weights": [1, 2]}, "wrong weights"),
    ],
    ids=lambda value: value if isinstance(value, str) else value["kind"],
)
def test_refused(distribution: dict[str, Any], message: str) -> None:
    with pytest.raises(ModelError, match=message):
        made(**distribution)


def test_a_field_without_unit_takes_plain_numbers() -> None:
    with pytest.raises(ModelError, match="a number without unit"):
        made(None, kind="uniform", low="1 N", high=2)
    assert made(None, kind="uniform", low=1, high=2).quantile(0.5) == 1.5
