"""The sheet of supports → heights of the contact wire, and staggers, as a model file has them."""

from collections.abc import Sequence
from typing import Any

from arcless.errors import ModelError
from arcless.model.line.parts.heights import HeightChange, heights_at
from arcless.model.tables.grids import Table
from arcless.model.tables.spans import short


def check_supports(table: Table, count: int) -> None:
    """Raise `ModelError` unless there is one row for each support, in order."""
    table.check_numbers("support")
    if len(table) != count:
        raise ModelError(
            "wrong number of supports", where=table.grid.where, got=f"{len(table)} rows",
            expected=f"{count}: one more than spans, with both ends of the line",
        )  # fmt: skip


def stretches(heights: Sequence[float], supports: Sequence[float]) -> list[dict[str, Any]]:
    """Return the changes of height that give a height in m at each support, to the last bit.

    A stretch is as long as the heights on it are what `heights_at` interpolates. Between two
    neighbours h₀ + (h₁ − h₀) is h₁ exactly where neither is more than twice the other (Sterbenz).
    """
    found: list[dict[str, Any]] = []
    start, last = 0, len(heights) - 1
    while start < last:
        if heights[start + 1] == heights[start]:
            start += 1
            continue
        end = start + 1
        while end < last and _is_straight(heights, supports, start, end + 1):
            end += 1
        height = short(heights[end])
        found.append({"from_support": start + 1, "to_support": end + 1, "height": height})
        start = end
    return found


def _is_straight(heights: Sequence[float], supports: Sequence[float], start: int, end: int) -> bool:
    """Return whether one change of height gives all heights from one support to another."""
    if heights[end] == heights[end - 1]:
        return False
    change = HeightChange.model_construct(
        from_support=1, to_support=end - start + 1, height=heights[end]
    )
    made = heights_at(heights[start], [change], supports[start : end + 1])
    return made == list(heights[start : end + 1])


def pattern(values: Sequence[float]) -> list[float | int]:
    """Return the shortest list that gives the values when it is repeated."""
    count = next(n for n in range(1, len(values) + 1) if _repeats(values, n))
    return [short(value) for value in values[:count]]


def _repeats(values: Sequence[float], count: int) -> bool:
    return all(
        value == values[index - count] for index, value in enumerate(values) if index >= count
    )
