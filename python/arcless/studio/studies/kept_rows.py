"""Rows of a study as the page reads them: in the order in which they came, after a number.

The journal has them in the order of the variants. What was read once is kept, and only gaps are
read again: looking at a study of 10⁴ variants every second costs what has come since.
"""

import secrets
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from arcless import study
from arcless.assess import NOT_JUDGED
from arcless.errors import ArclessError
from arcless.model.files.yaml_reader import parse
from arcless.studio.studies.fields import words_of_field
from arcless.studio.studies.verdicts import RowVerdict, RowVerdicts
from arcless.study.folder.table import unit_of_output
from arcless.study.journal.journal import is_locked
from arcless.study.journal.row import Row
from arcless.study.optimisation.optimise import Optimise
from arcless.study.report.data.record import decimals_of, pantograph_of, quantity_of

# Ranges of missing variants that are read one by one; with more of them all is read at once, which
# is quicker than many small questions.
MOST_GAPS = 64
# Rows of an answer; a row is about 100 bytes.
MOST_ROWS = 5000


class KeptRows:
    """Rows of the study of a folder.

    Attributes
    ----------
    folder
        The folder.
    edition
        Name of this reading: rows numbered by another one are read from the start.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self._begin()

    def _begin(self) -> None:
        self.place = study.open(self.folder)
        self.edition = secrets.token_hex(4)
        self._verdicts = RowVerdicts(self.place.study)
        self._rows: list[list[Any]] = []
        self._there: set[int] = set()
        self._counts: Counter[str] = Counter()
        self._time = 0.0
        self._state, self._stamp = self._state_now(), ()
        self._was_running = False

    def after(self, number: int, edition: str, most: int) -> dict[str, Any]:
        """Return rows after a number of rows, and how far the study is."""
        running = is_locked(self.place.journal)
        if self._state_now() != self._state or (running and not self._was_running and self._rows):
            self._begin()  # begun again, or resumed: rows that failed may be others now
        self._was_running = running
        self._read()
        first = number if edition == self.edition else 0
        end = first + max(1, min(most, MOST_ROWS))
        missing = self.place.study.plan.count - len(self._rows)
        return {
            "edition": self.edition,
            "rows": self._rows[first:end],
            "next": min(end, len(self._rows)),
            "there": len(self._rows),
            "total": self.place.study.plan.count,
            "counts": dict(self._counts),
            "running": running,
            "wall_time_s": self._time,
            "missing": missing,
            "criteria": self._verdicts.criteria,
            "not_judged": self._verdicts.unknown,
        }

    def _read(self) -> None:
        stamp = self._stamp_now()
        if stamp == self._stamp:
            return
        found = {
            row.variant: row
            for first, last in self._gaps()
            for row in self.place.rows(first, last)
            if row.variant not in self._there
        }
        verdicts = self._verdicts.of(list(found.values()))
        for number, row in found.items():
            self._there.add(number)
            self._rows.append(self._plain(row, verdicts.get(number)))
            self._counts[row.status] += 1
            self._time += row.wall_time_s
        self._stamp = stamp

    def _plain(self, row: Row, verdict: RowVerdict | None) -> list[Any]:
        asked = self.place.study
        values = [row.values.get(axis.name) for axis in asked.axes]
        outputs = [row.outputs.get(name) for name in asked.outputs]
        judged = (NOT_JUDGED, []) if verdict is None else (verdict.word, verdict.criteria)
        return [row.variant, row.status, *values, *outputs, *judged, row.error, row.wall_time_s]

    def _gaps(self) -> list[tuple[int, int]]:
        total = self.place.study.plan.count
        gaps = list(_ranges(self._there, total))
        return gaps if len(gaps) <= MOST_GAPS else [(gaps[0][0], gaps[-1][1])]

    def _stamp_now(self) -> tuple[Any, ...]:
        journal = self.place.journal
        return tuple(
            (file.stat().st_mtime_ns, file.stat().st_size) if file.exists() else None
            for file in (journal, journal.with_name(f"{journal.name}-wal"))
        )

    def _state_now(self) -> tuple[int, int]:
        about = (self.folder / "study.json").stat()
        return about.st_mtime_ns, about.st_ino


def _ranges(there: set[int], total: int) -> Iterator[tuple[int, int]]:
    """Yield first and last of each range of numbers from 1 to total that are not there."""
    first = 1
    for number in sorted(there):
        if number > first:
            yield first, number - 1
        first = number + 1
    if first <= total:
        yield first, total


def definition(place: study.StudyFolder) -> dict[str, Any]:
    """Return what a study asks, as the page shows its columns."""
    asked, design = place.study, place.study.design
    bounds: dict[str, dict[str, float | None]] = {}
    objectives: dict[str, str] = {}
    if isinstance(design, Optimise):
        objectives = dict(design.objectives)
        bounds = {
            one.output: {"at_least": one.at_least, "at_most": one.at_most}
            for one in design.constraints
        }
    return {
        "name": asked.name,
        "description": asked.description,
        "scenario": asked.scenario.name,
        "design": design.kind,
        "count": asked.plan.count,
        "variables": [
            {"name": axis.name, "field": axis.field, "unit": axis.typed_unit, "scale": axis.scale,
             "label": words_of_field(axis.field),
             "description": asked.variables[axis.name].description}
            for axis in asked.axes
        ],
        "outputs": [
            {"name": name, "expression": output.expression, "unit": unit_of_output(asked, name),
             "label": quantity_of(output.expression) or name, "of": pantograph_of(asked, name),
             "decimals": decimals_of(output.expression),
             "description": output.description, "objective": objectives.get(name),
             "bounds": bounds.get(name)}
            for name, output in asked.outputs.items()
        ],
    }  # fmt: skip


def written_scenario(folder: Path) -> str | None:
    """Return the scenario that the study file of a folder names; None where it holds it whole."""
    file = folder / "study.yaml"
    try:
        named = (
            parse(file.read_text("utf-8"), file.name)[0].get("scenario") if file.exists() else None
        )
    except (ArclessError, OSError, ValueError):
        return None
    return named if isinstance(named, str) else None
