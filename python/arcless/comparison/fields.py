"""Fields in which scenarios differ: of the scenario, its line and its pantographs."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from arcless.model import Scenario
from arcless.report.model_data import Row, rows_of


@dataclass(frozen=True)
class Field:
    """One field that differs.

    Attributes
    ----------
    path
        Dotted path in the scenario, as `--set` takes it.
    values
        Value in each run as it was typed, with its unit; None where a run has no such field.
    si
        Value in SI with its unit where it was typed otherwise, else empty.
    is_default
        Whether nobody gave the value.
    """

    path: str
    values: tuple[str | None, ...]
    si: tuple[str, ...]
    is_default: tuple[bool, ...]


def changed_fields(scenarios: Sequence[Scenario]) -> list[Field]:
    """Return the fields whose content differs, in the order of the first scenario that has them.

    Names and descriptions of scenario, line and pantograph, sources, marks and notes are left out:
    models of other names and equal content are equal. A value that was typed in another unit is
    equal as well; so is a word such as ``auto``, whatever followed from it.
    """
    tables = [_by_path(one) for one in scenarios]
    paths = dict.fromkeys(path for table in tables for path in table)
    found = []
    for path in paths:
        rows = [table.get(path) for table in tables]
        first = rows[0]
        if all(_same(first, row) for row in rows[1:]):
            continue
        found.append(
            Field(
                path,
                tuple(None if row is None else row.value for row in rows),
                tuple("" if row is None else row.si for row in rows),
                tuple(row is not None and row.is_default for row in rows),
            )
        )
    return found


def _by_path(scenario: Scenario) -> dict[str, Row]:
    parts: list[tuple[str, Any]] = [("", scenario), ("line.", scenario.line)]
    for place, one in enumerate(scenario.pantographs):
        parts.append((f"pantographs.{place}.model.", one.model))
    return {f"{start}{row.path}": row for start, part in parts for row in rows_of(part)}


def _same(one: Row | None, other: Row | None) -> bool:
    if one is None or other is None:
        return one is other
    # 2 and 2.0 are one number, but True is not 1: a switch is no count.
    mixed = isinstance(one.content, bool) is not isinstance(other.content, bool)
    return bool(one.content == other.content) and not mixed
