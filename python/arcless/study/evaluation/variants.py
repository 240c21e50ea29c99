"""Variants: one combination of values each, with an identity, in an order quick to compute."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

from arcless.errors import StudyError
from arcless.model import Scenario
from arcless.study.definition.load import digest
from arcless.study.definition.study import Study

# Fields below these leave the line as it is, so that its matrices can be shared.
_TRAIN = ("speed", "speed_profile", "pantographs", "travel", "analysis", "wear")


@dataclass(frozen=True)
class Variant:
    """A combination of values.

    Attributes
    ----------
    number
        From 1, as the design counts.
    key
        Hash of what it changes: a row of an older state with another key is not of this variant.
    values
        By name of the variable, in SI.
    changes
        By dotted path of the scenario.
    """

    number: int
    key: str
    values: dict[str, Any]
    changes: dict[str, Any]


def variant(study: Study, number: int) -> Variant:
    """Return a variant by its number, from 1."""
    values = study.plan.values(number - 1)
    named = {axis.name: value for axis, value in zip(study.axes, values, strict=True)}
    return Variant(number, _key(study, values), named, study.changes_of(values))


def key(study: Study, number: int) -> str:
    """Return the identity of a variant by its number, from 1, without all that it changes."""
    return _key(study, study.plan.values(number - 1))


def _key(study: Study, values: tuple[Any, ...]) -> str:
    return digest([[axis.field, value] for axis, value in zip(study.axes, values, strict=True)])


def scenario(study: Study, number: int) -> Scenario:
    """Return the scenario of a variant by its number, from 1.

    Raises
    ------
    StudyError
        The study has no such variant.
    ModelError
        Its values make none that is valid.
    """
    if not 1 <= number <= study.plan.count:
        raise StudyError(
            "no such variant", got=str(number), expected=f"a number from 1 to {study.plan.count}"
        )
    return study.base.with_(**variant(study, number).changes)


def in_order(study: Study, numbers: Iterable[int]) -> list[int]:
    """Return numbers of variants so that those that share a line stand together."""
    on_line = [
        place for place, axis in enumerate(study.axes) if axis.field.partition(".")[0] not in _TRAIN
    ]
    if not on_line:
        return sorted(numbers)

    def line(number: int) -> list[str]:
        values = study.plan.values(number - 1)
        return [repr(values[place]) for place in on_line]

    return sorted(numbers, key=lambda number: (line(number), number))


def variants(study: Study, numbers: Iterable[int]) -> Iterator[Variant]:
    """Yield variants one by one: a study of a million holds none of them."""
    return (variant(study, number) for number in numbers)
