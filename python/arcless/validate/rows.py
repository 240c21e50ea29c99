"""Comparison of one value with its allowed range."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Self

from arcless.validate.reference import OUTSIDE, Range

Progress = Callable[[float, str], None]


@dataclass(frozen=True, slots=True)
class Row:
    """One comparison: `value` against `limit`, in `unit`; verdict as in `Range`.

    `uncertainty` is how sure the value is, None where nobody asked.

    `low` and `high` are the limit's bounds, None where there is none. `note` says where or how
    the value was found, `checked` and `assumption` what the row is a part of, where that is more
    than the comparison itself.
    """

    case: str
    key: str
    quantity: str
    unit: str
    value: float | None
    digits: int
    low: float | None
    high: float | None
    limit: str
    mark: str
    verdict: str
    note: str = ""
    checked: str = ""
    assumption: str = ""
    uncertainty: float | None = None

    @property
    def violates(self) -> bool:
        """True when the value is outside of a range that was read in a source."""
        return self.verdict == OUTSIDE

    @classmethod
    def of(
        cls,
        case: str,
        allowed: Range,
        value: float | None,
        uncertainty: float | None = None,
        **texts: str,
    ) -> Self:
        """Compare a value with what is allowed; further fields are texts."""
        return cls(
            case=case,
            key=allowed.key,
            quantity=allowed.label,
            unit=allowed.unit,
            value=value,
            digits=allowed.digits,
            low=allowed.low,
            high=allowed.high,
            limit=allowed.limit,
            mark=allowed.mark,
            verdict=allowed.verdict(value, uncertainty),
            uncertainty=uncertainty,
            **texts,
        )


def part(progress: Progress | None, begin: float, end: float) -> Progress | None:
    """Map the progress of a part onto its share of the whole."""
    if progress is None:
        return None
    whole = progress
    return lambda fraction, text: whole(begin + fraction * (end - begin), text)
