"""Journals of version 1: one line of JSON a row, without seals, as studies had them before.

What can be known to be wrong in a line: names, types, and values that are not those of its variant.
A changed output that is still a number cannot be distinguished from a right one.
"""

import json
from collections.abc import Iterator
from pathlib import Path

from arcless.study.definition.load import digest
from arcless.study.definition.study import Study
from arcless.study.evaluation.variants import key
from arcless.study.journal.row import Row, row_of
from arcless.study.journal.salvage import Damage
from arcless.study.optimisation.search import Search


def rows(path: Path, study: Study, damage: Damage) -> Iterator[Row]:
    """Yield the rows of a journal in the order of the variants, of several of one the last.

    Parameters
    ----------
    path, study
        The journal and its study.
    damage
        Is told the numbers of lines that were left out.
    """
    found: dict[int, Row] = {}
    with path.open("rb") as file:
        for number, line in enumerate(file, start=1):
            row = _row(line)
            if row is not None and _fits(study, row):
                found[row.variant] = row
            elif line.endswith(b"\n"):  # else a kill cut it short
                damage.rows.add(number)
    yield from (found[number] for number in sorted(found))


def _row(line: bytes) -> Row | None:
    try:
        return row_of(json.loads(line)) if line.endswith(b"\n") else None
    except (ValueError, RecursionError):
        return None


def _fits(study: Study, row: Row) -> bool:
    """Return whether a row has the outputs of a study, and the values of its variant."""
    names = [axis.name for axis in study.axes]
    if row.variant > study.plan.count or row.outputs.keys() - study.outputs.keys():
        return False
    if row.values.keys() != set(names):
        return False
    own = digest([[axis.field, row.values[axis.name]] for axis in study.axes])
    chosen = isinstance(study.plan, Search)  # what it chooses follows from the rows before
    return row.key == own and (chosen or own == key(study, row.variant))
