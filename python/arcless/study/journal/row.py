"""A row of a study: the outcome of one variant."""

from collections.abc import Callable
from dataclasses import MISSING, dataclass, field, fields
from math import isfinite
from typing import Any, Literal, get_args

Status = Literal["done", "pruned", "invalid", "failed"]
# Fields that a row has only where runs were observed while they stepped.
_WATCHED = ("so_far", "steps", "steps_of_run", "stopped_at_m", "stopped_after_s")


@dataclass(frozen=True)
class Row:
    """Outcome of a variant.

    Attributes
    ----------
    variant, key, values
        Number from 1, identity, and values by name of the variable, in SI.
    status
        `done`; `pruned`, stopped as it could not become good any more; `invalid`, the values make
        no valid scenario; `failed`, the computation failed.
    outputs
        By name; None for what is not defined or was not recorded.
    error
        Why there is no value, in a sentence; empty when all is well.
    wall_time_s
        From the start of the variant to its end, in s.
    arcless_version
        Version that computed it, with a digest of the program's files.
    so_far
        Values of outputs over the part of the section travelled at each look, by name.
    steps, steps_of_run
        Steps of all its runs, and of one run to its end; 0 where nobody looked.
    stopped_at_m, stopped_after_s
        Where the first pantograph was when the run was stopped, and the time since its start.
    """

    variant: int
    key: str
    values: dict[str, Any]
    status: Status
    outputs: dict[str, float | None]
    error: str
    wall_time_s: float
    arcless_version: str
    so_far: dict[str, list[float | None]] = field(default_factory=dict)
    steps: int = 0
    steps_of_run: int = 0
    stopped_at_m: float | None = None
    stopped_after_s: float | None = None

    def to_dict(self) -> dict[str, Any]:
        """Return it as plain values, the row's own; without those of looks if there were none."""
        return {name: v for name, v in vars(self).items() if v or name not in _WATCHED}


def row_of(data: Any) -> Row | None:
    """Return a row from plain data; None where a name is missing or unknown, or a type is wrong."""
    if not isinstance(data, dict) or not _NEEDED <= data.keys() <= _FITS.keys():
        return None
    fits = all(_FITS[name](value) for name, value in data.items())
    return Row(**data) if fits else None


def _is_finite(value: Any) -> bool:
    if isinstance(value, bool) or not isinstance(value, int | float):
        return False
    try:
        return isfinite(value)
    except OverflowError:
        return False


def _is_finite_or_none(value: Any) -> bool:
    return value is None or _is_finite(value)


def _is_count(value: Any) -> bool:
    return type(value) is int and 0 <= value < _TOO_MANY


def _is_text(value: Any) -> bool:
    return isinstance(value, str)


def _is_named(fits: Callable[[Any], bool]) -> Callable[[Any], bool]:
    """Return whether a value is a mapping whose values fit by their names."""
    return lambda value: (
        isinstance(value, dict) and all(map(_is_text, value)) and all(map(fits, value.values()))
    )


def _is_list(value: Any) -> bool:
    return isinstance(value, list) and all(map(_is_finite_or_none, value))


# Whole numbers in tables have 64 bits.
_TOO_MANY = 1 << 63
_FITS: dict[str, Callable[[Any], bool]] = {
    "variant": lambda value: _is_count(value) and value > 0,
    "key": _is_text,
    "values": _is_named(lambda _value: True),
    "status": lambda value: value in get_args(Status),
    "outputs": _is_named(_is_finite_or_none),
    "error": _is_text,
    "wall_time_s": lambda value: _is_finite(value) and value >= 0.0,
    "arcless_version": _is_text,
    "so_far": _is_named(_is_list),
    "steps": _is_count,
    "steps_of_run": _is_count,
    "stopped_at_m": _is_finite_or_none,
    "stopped_after_s": _is_finite_or_none,
}
_NEEDED = {
    one.name for one in fields(Row) if one.default is MISSING and one.default_factory is MISSING
}
