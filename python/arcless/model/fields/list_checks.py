"""Checks that lists of several parts of a model share."""

from collections.abc import Sequence
from itertools import pairwise
from typing import Any, Protocol

from arcless.errors import ModelError
from arcless.model.fields.part import Path


class Stretch(Protocol):
    """A piece of the track, positions in m."""

    from_: float
    to: float


def check_count(values: Sequence[Any] | None, count: int, of: str, field: Path) -> None:
    """Raise `ModelError` unless there is one value for each of another list, or no list."""
    if values is not None and len(values) != count:
        raise ModelError(
            "wrong number of values",
            got=f"{len(values)} values",
            expected=f"{count}, one for each of {of}",
            field=field,
        )


def check_increasing(
    values: Sequence[float], unit: str, field: str, what: str, expected: str | None = None
) -> None:
    """Raise `ModelError` unless values increase; `what` is their plural, `field` their list."""
    for index, (before, after) in enumerate(pairwise(values), start=1):
        if after <= before:
            raise ModelError(
                f"{what} out of order",
                got=f"{after:g} {unit} after {before:g} {unit}",
                expected=expected or f"{what} that increase",
                field=(field, index),
            )


def check_behind(stretches: Sequence[Stretch], what: str, field: Path) -> None:
    """Raise `ModelError` unless stretches lie one behind the other; `what` is their plural."""
    for index, (before, behind) in enumerate(pairwise(stretches), start=1):
        if behind.from_ < before.to:
            raise ModelError(
                f"{what} overlap or are out of order",
                got=f"a start at {behind.from_:g} m before the end of the last one,"
                f" {before.to:g} m",
                expected=f"{what} along the track, one behind the other",
                field=(*field, index, "from"),
            )
