"""Status of a study, read from its folder alone."""

from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from arcless.display import cards
from arcless.study.definition.study import Study
from arcless.study.folder.folder import StudyFolder
from arcless.study.journal import journal
from arcless.study.journal.row import Row
from arcless.study.optimisation.pruning import Saving


class DamagedJournalWarning(UserWarning):
    """Rows of a study are left out as they are damaged."""


@dataclass(frozen=True)
class StudyStatus:
    """Status of a study: counts, damage, steps, times, errors.

    Attributes
    ----------
    name, folder
        The study and its folder.
    running
        Whether a process computes it just now.
    journal
        How SQLite keeps the journal whole; None of a study of an older version.
    damaged
        Number of damaged rows of the journal, which `resume` computes again; None where its file is
        damaged, and the number cannot be told.
    total, done, pruned, invalid, failed, missing
        Variants: of the study, and by outcome.
    steps_taken, steps_saved
        Steps of all runs, and those not taken as runs were pruned; None where nobody looked.
    wall_time_s
        Sum of the wall times of the rows, in s.
    errors
        The reasons of rows without values, with how many rows have each; most frequent first.
    versions
        The versions that computed the rows, with how many each.
    """

    name: str
    folder: str
    running: bool
    journal: str | None
    damaged: int | None
    total: int
    done: int
    pruned: int
    invalid: int
    failed: int
    missing: int
    steps_taken: int | None
    steps_saved: int | None
    wall_time_s: float
    errors: dict[str, int]
    versions: dict[str, int]

    @property
    def damage(self) -> str | None:
        """Damage of the journal, in a sentence; None where there is none."""
        if self.damaged == 0:
            return None
        what = "its file" if self.damaged is None else f"rows left out: {self.damaged}"
        todo = "`arcless study resume` computes again what is missing"
        return f"the journal is damaged, {what}; {todo}"

    @property
    def sentence(self) -> str:
        """Numbers of variants by outcome, in a sentence."""
        pruned = "" if self.steps_saved is None else f"{self.pruned} pruned, "
        return (
            f"{self.done} of {self.total} done, {pruned}{self.invalid} invalid, "
            f"{self.failed} failed, {self.missing} missing; "
            f"{'being computed now' if self.running else 'not being computed'}"
        )

    def __repr__(self) -> str:
        return f"<StudyStatus {self.name}: {self.sentence}>"

    def _repr_html_(self) -> str:
        titles = ("variants", "error")
        errors = [(str(count), text) for text, count in self.errors.items()]
        parts = [cards.table(titles, errors, numbers=titles[:1])] if errors else []
        parts += [] if self.damage is None else [cards.listed([self.damage])]
        about = f"{self.sentence}; {self.folder}"
        return cards.card(f"Study {self.name}", *parts, about=about)

    def to_dict(self) -> dict[str, Any]:
        """Return it as plain values."""
        return asdict(self)


def status(study: Study, folder: Path | None = None) -> StudyStatus:
    """Return the status of a study.

    Parameters
    ----------
    study
        From `arcless.study.load`.
    folder
        Its folder; ``runs/studies/NAME`` without.

    Raises
    ------
    StudyError
        No study was begun there, or another one.
    """
    place = StudyFolder(study, folder)
    place.check_same()
    tally = RowCounter()
    for _ in tally.of(place.rows()):
        pass
    return tally.status(study, place)


class RowCounter:
    """Counter of rows while they are read by another consumer."""

    def __init__(self) -> None:
        self._counts: Counter[str] = Counter()
        self._errors: Counter[str] = Counter()
        self._versions: Counter[str] = Counter()
        self._steps: Counter[str] = Counter()
        self._of_run: Counter[str] = Counter()
        self._wall_time_s = 0.0

    def of(self, rows: Iterable[Row]) -> Iterator[Row]:
        """Yield rows as they are, and count each."""
        for row in rows:
            self._counts[row.status] += 1
            self._versions[row.arcless_version] += 1
            self._wall_time_s += row.wall_time_s
            self._steps[row.status] += row.steps
            self._of_run[row.status] += row.steps_of_run
            if row.status in ("invalid", "failed"):
                self._errors[row.error] += 1
            yield row

    def status(self, study: Study, place: StudyFolder) -> StudyStatus:
        """Return the status that the rows read so far add up to."""
        counts, state = self._counts, place.state()
        saving = Saving.of_counts(self._steps, self._of_run) if study.watched else None
        return StudyStatus(
            name=study.name,
            folder=str(place.path),
            running=journal.is_locked(place.journal),
            journal=None if state is None else state.get("journal"),
            damaged=None if place.damage.file else len(place.damage.rows),
            total=study.plan.count,
            done=counts["done"],
            pruned=counts["pruned"],
            invalid=counts["invalid"],
            failed=counts["failed"],
            missing=study.plan.count - counts.total(),
            steps_taken=None if saving is None else saving.taken,
            steps_saved=None if saving is None else round(saving.saved),
            wall_time_s=self._wall_time_s,
            errors=dict(self._errors.most_common()),
            versions=dict(self._versions.most_common()),
        )


def saving_of(study: Study, place: StudyFolder) -> Saving | None:
    """Return what pruning has saved so far; None of a study whose runs nobody looks at."""
    return Saving.of(place.rows()) if study.watched else None
