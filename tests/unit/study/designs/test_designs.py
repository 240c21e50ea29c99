"""Each design: which points it gives, how even they are, and that a seed gives the same ones."""

from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest

from arcless.errors import ModelError
from arcless.study.designs import MAX_VARIANTS, Grid, LatinHypercube, Listed, MonteCarlo, Sobol
from arcless.study.variables.variables import Axis, spaced

SAMPLES = {
    "monte-carlo": MonteCarlo,
    "latin-hypercube": LatinHypercube,
    "sobol": Sobol,
}


def counted(name: str, levels: Sequence[Any]) -> Axis:
    return Axis(name, "speed", "m/s", tuple(levels), lambda u: levels[int(u * len(levels))])


def open_ended(name: str) -> Axis:
    return Axis(name, "speed", "m/s", None, lambda u: u)


def points(kind: str, count: int, variables: int, seed: int = 1) -> np.ndarray:
    design = SAMPLES[kind](kind=kind, count=count)
    plan = design.plan([open_ended(f"x{i}") for i in range(variables)], seed)
    return np.array([plan.values(number) for number in range(plan.count)])


def test_grid_counts_the_last_variable_fastest() -> None:
    plan = Grid(kind="grid").plan([counted("a", "xyz"), counted("b", [1, 2])], 0)
    found = [plan.values(number) for number in range(plan.count)]
    assert found == [("x", 1), ("x", 2), ("y", 1), ("y", 2), ("z", 1), ("z", 2)]


def test_list_takes_values_side_by_side() -> None:
    plan = Listed(kind="list").plan([counted("a", "xy"), counted("b", [1, 2])], 0)
    assert [plan.values(number) for number in range(plan.count)] == [("x", 1), ("y", 2)]
    with pytest.raises(ModelError, match="3 values, expected 2, as a has"):
        Listed(kind="list").plan([counted("a", "xy"), counted("b", [1, 2, 3])], 0)


def test_a_huge_grid_is_refused_with_its_count_and_costs_nothing() -> None:
    axes = [counted(name, range(1000)) for name in "abc"]
    with pytest.raises(ModelError, match=r"got 1 000 000 000 variants, expected at most 1 000 000"):
        Grid(kind="grid").plan(axes, 0)
    with pytest.raises(ModelError, match="too many variants"):
        MonteCarlo(kind="monte-carlo", count=MAX_VARIANTS + 1).plan(axes, 0)


def test_a_grid_of_what_cannot_be_counted_is_refused() -> None:
    with pytest.raises(ModelError, match="values, or range with count"):
        Grid(kind="grid").plan([open_ended("a")], 0)


@pytest.mark.parametrize("kind", SAMPLES)
def test_a_sample_is_that_of_its_seed(kind: str) -> None:
    one = points(kind, 32, 3)
    assert np.array_equal(one, points(kind, 32, 3))
    assert not np.array_equal(one, points(kind, 32, 3, seed=2))
    assert np.all((one > 0.0) & (one < 1.0))


@pytest.mark.parametrize("kind", ["monte-carlo", "sobol"])
def test_more_points_leave_the_first_ones(kind: str) -> None:
    assert np.array_equal(points(kind, 40, 3)[:20], points(kind, 20, 3))


@pytest.mark.parametrize("kind", ["latin-hypercube", "sobol"])
@pytest.mark.parametrize("count", [1, 16, 64])
def test_one_point_in_each_of_equal_parts(kind: str, count: int) -> None:
    for column in points(kind, count, 4).T:
        assert sorted((column * count).astype(int)) == list(range(count))


def test_sobol_points_fill_squares_evenly() -> None:
    # 64 points of a (t, 6, 2) net with t = 0: one in each of 8 × 8 squares.
    squares = (points("sobol", 64, 2) * 8).astype(int)
    assert len({tuple(square) for square in squares}) == 64


def test_known_points_stay() -> None:
    # The stream of PCG64 with seed 1; another one would change every study without a word.
    first = points("monte-carlo", 1, 2)[0]
    assert first.tolist() == [0.5118216247002567, 0.9504636963259353]


def test_values_of_a_range_end_where_it_ends() -> None:
    values = spaced(0.1, 0.7, 7)
    assert values is not None
    assert (values[0], values[-1], len(values)) == (0.1, 0.7, 7)
    assert spaced(0.0, 1.0, None) is None
