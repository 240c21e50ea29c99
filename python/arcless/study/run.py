"""A study, begun or gone on with: what is missing is computed, every row is kept as it comes."""

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import closing, contextmanager, suppress
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from arcless.errors import OutputError, StudyError
from arcless.study import findings, sensitivity, table
from arcless.study.evaluate import Cancel, Task
from arcless.study.executors import Note
from arcless.study.executors import executor as choose
from arcless.study.folder import StudyFolder
from arcless.study.journal import Journal
from arcless.study.keeper import Keeper, Progress, Tell
from arcless.study.model import Execution, Study
from arcless.study.optimise import Optimise
from arcless.study.pruning import Watch
from arcless.study.rows import Row
from arcless.study.search import Search
from arcless.study.variants import in_order, key, variant
from arcless.study.version import code_version

if TYPE_CHECKING:
    from arcless.study.storage import Storage


def run(
    study: Study,
    folder: Path | None = None,
    *,
    resume: bool = False,
    retry_failed: bool = False,
    executor: Execution | None = None,
    storage: str | None = None,
    tell: Tell | None = None,
    note: Note | None = None,
    cancel: Cancel | None = None,
) -> Progress:
    """Compute the variants of a study that are missing in its folder.

    Parameters
    ----------
    study
        From `arcless.study.load`.
    folder
        Its folder; ``runs/studies/NAME`` without.
    resume
        Go on with the study that was begun there. Without it the folder must not hold rows.
    retry_failed
        Compute those again that failed.
    executor
        What computes, in place of what the study says.
    storage
        URL of the database for Optuna's trials, in place of what the study says; only of a study
        that optimises.
    tell
        Called with the progress after every row.
    note
        Told in a sentence what a user should know.
    cancel
        Asked now and then; the call ends with KeyboardInterrupt when it returns True. What was
        computed stays.

    Returns
    -------
    Progress
        At the end.

    Raises
    ------
    StudyError
        The folder or the storage holds a study already, none, or another one; a package is
        missing.
    ExecutorError
        The scheduler does not answer, or went away.
    StorageError
        The database does not answer, or went away.
    OutputError
        The folder cannot be written, or its disk is full.
    """
    table.check_available()
    sensitivity.check_available(study)
    say = note or (lambda _text: None)
    place = StudyFolder(study, folder)
    before = place.check_same() if resume else None
    if before is None:
        _check_new(place)
    computing = choose(executor or study.executor, say)
    with (
        closing(computing),
        _storage(study, place, storage) as trials,
        _journal(place) as journal,
    ):
        journal.mend()
        there = _valid_rows(study, place, retry_failed=retry_failed)
        if before is None:
            _check_new(place)  # another process may have been faster
            place.write_state()
        elif before["arcless_version"] != code_version():
            say(_other_version(before["arcless_version"]))
        also = None
        if trials is not None:
            trials.begin(anew=before is None)
            also = trials.take
        counts = Counter(there.values())
        keeper = Keeper(study, place, journal, counts, tell=tell, note=say, also=also)
        task = Task.of(study, place.results if study.keep == "results" else None)
        stop = cancel or (lambda: False)
        try:
            for numbers, watch in _rounds(study, place, also):
                missing = [number for number in numbers if number not in there]
                if missing:
                    ordered = (variant(study, number) for number in in_order(study, missing))
                    watched = replace(task, watch=watch)
                    computing.compute(watched, ordered, len(missing), keeper.take, stop)
        except BaseException:
            with suppress(OutputError):  # what ended the study is what is told
                keeper.write_table()
            raise
        keeper.write_table()
        findings.write(place, findings.of(study, place.rows()))
    return keeper.progress


def _rounds(
    study: Study, place: StudyFolder, told: Callable[[Row], None] | None
) -> Iterator[tuple[Sequence[int], Watch | None]]:
    """Yield numbers of variants in rounds, and what their runs are watched for.

    Of most designs there is one with all of them. `told` is told the rows that are there already.
    """
    if not isinstance(study.plan, Search):
        yield range(1, study.plan.count + 1), None
        return
    for numbers, watch in study.plan.rounds(place.rows):
        there = [row for row in place.rows() if row.variant in numbers]
        _check_rows(study, place, there)
        for row in there:
            if told is not None:
                told(row)
        yield numbers, watch


@contextmanager
def _storage(study: Study, place: StudyFolder, url: str | None) -> Iterator["Storage | None"]:
    """Open the storage of a study that optimises, before anything is written for it."""
    if not isinstance(study.design, Optimise):
        if url is not None:
            raise StudyError(
                "a study that does not optimise has no storage",
                got=f"design `{study.design.kind}`",
                expected="design `optimise` with `--storage`",
            )
        yield None
        return
    table.needs("optuna", "a study that optimises")
    from arcless.study.storage import Storage

    opened = Storage(study, place, url or study.design.storage)
    try:
        yield opened
    finally:
        opened.close()


@contextmanager
def _journal(place: StudyFolder) -> Iterator[Journal]:
    place.make()
    with Journal(place.journal) as journal:
        yield journal


def _check_new(place: StudyFolder) -> None:
    if next(place.rows(), None) is not None:
        raise StudyError(
            "a study was begun here already",
            where=str(place.path),
            got="rows of it",
            expected="a new folder",
            hint="go on with it by `arcless study resume`, or name another folder with `--out`",
        )


def _valid_rows(study: Study, place: StudyFolder, *, retry_failed: bool) -> dict[int, str]:
    """Return the status of the rows that need no computing; all must be of this study."""
    if not isinstance(study.plan, Search):  # its rows follow from each other, round by round
        _check_rows(study, place, place.rows())
    elif retry_failed and any(row.status == "failed" for row in place.rows()):
        raise StudyError(
            "an optimisation does not compute failed variants again",
            expected="resume without --retry-failed",
            hint="later choices follow from their failure; begin anew with `--out`",
        )
    return {
        row.variant: row.status
        for row in place.rows()
        if not (retry_failed and row.status == "failed")
    }


def _check_rows(study: Study, place: StudyFolder, rows: Iterable[Row]) -> None:
    for row in rows:
        known = 1 <= row.variant <= study.plan.count
        if not known or key(study, row.variant) != row.key:
            raise StudyError(
                "the rows are of another study",
                where=str(place.journal),
                got=f"variant {row.variant} with other values",
                expected="the values that the design gives it",
                hint="begin anew in another folder with `--out`",
            )


def _other_version(before: str) -> str:
    return (
        f"the study was begun with version {before}, this is {code_version()}: "
        "the rows say which computed them"
    )
