"""Writer of rows: into the journal at once, into the table now and then, with progress."""

import time
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field

from arcless.study.definition.study import Study
from arcless.study.evaluation.messages import Note
from arcless.study.evaluation.version import code_version
from arcless.study.folder import table
from arcless.study.folder.folder import StudyFolder
from arcless.study.journal.journal import Journal
from arcless.study.journal.row import Row

# The table is written again after this time, and after this many times of what writing it took.
_WRITE_EVERY_S = 5.0
_WRITE_PART = 20.0


@dataclass
class Progress:
    """Progress of a study: counts of its variants, and time.

    Attributes
    ----------
    total, counts
        Variants of the study; rows by status.
    computed, elapsed_s
        Rows of this call, and its time in s so far.
    """

    total: int
    counts: Counter[str] = field(default_factory=Counter)
    computed: int = 0
    elapsed_s: float = 0.0

    @property
    def there(self) -> int:
        """Number of rows that exist."""
        return self.counts.total()

    @property
    def rate(self) -> float | None:
        """Variants per second in this call; None before the first."""
        return self.computed / self.elapsed_s if self.computed and self.elapsed_s > 0.0 else None

    @property
    def remaining_s(self) -> float | None:
        """Time to the end in s at that rate."""
        return None if self.rate is None else (self.total - self.there) / self.rate


Tell = Callable[[Progress], None]


class RowWriter:
    """Keeps rows: in the journal at once, in the table now and then; none stays in memory.

    Parameters
    ----------
    study, place, journal
        The study, its folder, its journal.
    there
        Rows that are there already, by status.
    tell, note
        Told the progress after every row, and what a user should know.
    """

    def __init__(
        self,
        study: Study,
        place: StudyFolder,
        journal: Journal,
        there: Counter[str],
        *,
        tell: Tell | None,
        note: Note,
    ) -> None:
        self._study, self._place, self._journal = study, place, journal
        self._tell, self._note = tell or (lambda _progress: None), note
        table.import_ahead()
        self._versions = {code_version()}
        self._began = self._written = time.monotonic()
        self._writing_s = 0.0
        self.progress = Progress(study.plan.count, there)
        self._tell(self.progress)

    def take(self, row: Row) -> None:
        """Keep a row."""
        self._journal.append(row)
        if row.arcless_version not in self._versions:
            self._versions.add(row.arcless_version)
            self._note(f"a worker has version {row.arcless_version}, here is {code_version()}")
        now = time.monotonic()
        self.progress.counts[row.status] += 1
        self.progress.computed += 1
        self.progress.elapsed_s = now - self._began
        self._tell(self.progress)
        if now - self._written > max(_WRITE_EVERY_S, _WRITE_PART * self._writing_s):
            self.write_table()

    def write_table(self) -> None:
        """Write all rows into the table."""
        began = time.monotonic()
        table.write(self._place.table, self._study, self._place.rows())
        self._written = time.monotonic()
        self._writing_s = self._written - began
