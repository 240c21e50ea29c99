"""Run of a study, new or resumed: missing variants are computed, every row is kept at once."""

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from contextlib import closing, suppress
from dataclasses import replace
from pathlib import Path

from arcless.errors import OutputError, StudyError
from arcless.results import RESULT_NAME
from arcless.study.analysis import findings, sensitivity
from arcless.study.definition.study import Execution, Study
from arcless.study.evaluation.evaluate import Cancel, Task
from arcless.study.evaluation.variants import in_order, key, variant
from arcless.study.evaluation.version import code_version
from arcless.study.executors import Note
from arcless.study.executors import executor as choose
from arcless.study.folder import table
from arcless.study.folder.folder import StudyFolder
from arcless.study.folder.row_writer import Progress, RowWriter, Tell
from arcless.study.journal.journal import in_use, is_locked
from arcless.study.journal.row import Row
from arcless.study.optimisation.optimise import Optimise
from arcless.study.optimisation.pruning import Monitoring
from arcless.study.optimisation.search import Search


def run(
    study: Study,
    folder: Path | None = None,
    *,
    resume: bool = False,
    retry_failed: bool = False,
    executor: Execution | None = None,
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
        Continue the study that was begun there. Without it the folder must not hold rows.
    retry_failed
        Compute those again that failed.
    executor
        Executor, instead of the study's own.
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
        The folder holds a study already, none, or another one; a package is missing.
    ExecutorError
        The scheduler does not answer, or was lost.
    OutputError
        The folder cannot be written, or its disk is full.
    """
    table.check_available()
    sensitivity.check_available(study)
    if isinstance(study.design, Optimise):
        table.needs("optuna", "a study that optimises")
    say = note or (lambda _text: None)
    place = StudyFolder(study, folder)
    before = place.check_same() if resume else None
    if before is None:
        _check_new(place)
    with (
        closing(choose(executor or study.executor, say)) as computing,
        place.open_journal() as kept,
    ):
        for told in (kept.damage, place.take_former()):
            if told is not None:
                say(told)
        there = _valid_rows(study, place, retry_failed=retry_failed)
        if before is None:
            _check_new(place)  # another process may have been faster
            place.write_state(kept.mode)
        else:
            place.note_mode(kept.mode)
            if before["arcless_version"] != code_version():
                say(_other_version(before["arcless_version"]))
        keeper = RowWriter(study, place, kept, Counter(there.values()), tell=tell, note=say)
        task = Task.of(study, place.results if study.keep == "results" else None)
        stop = cancel or (lambda: False)
        try:
            for numbers, watch in _rounds(study, place):
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


def _rounds(study: Study, place: StudyFolder) -> Iterator[tuple[Sequence[int], Monitoring | None]]:
    """Yield numbers of variants in rounds, and the quantities their runs are monitored by.

    Of most designs there is one with all of them.
    """
    if not isinstance(study.plan, Search):
        yield range(1, study.plan.count + 1), None
        return
    for numbers, watch in study.plan.rounds(place.rows):
        _check_rows(study, place, place.rows(numbers[0], numbers[-1]))
        yield numbers, watch


def _check_new(place: StudyFolder) -> None:
    """Refuse a folder with rows; say how far its study is, and what to do with it."""
    if (place.path / RESULT_NAME).exists():
        raise StudyError(
            "a run is in this folder",
            where=str(place.path),
            expected="a folder of its own for a study",
            hint="choose another one with `--out`",
        )
    there, total = sum(1 for _ in place.rows()), place.study.plan.count
    if not there and not place.damage.found:
        return
    if is_locked(place.journal):
        raise in_use(place.path)
    if not place.is_of_this_study:
        what, got, todo = "another study was begun here", "rows of that", "choose another folder"
    elif there < total:
        what, got = "the study was begun here already", f"{there} of {total} variants"
        todo = f"continue with `{place.command('resume')}`, or restart"
    else:
        what, got = "the study is complete already", f"all {total} variants"
        todo = f"see it with `{place.command('report')}`, or restart"
    raise StudyError(
        what,
        where=str(place.path),
        got=got,
        expected="a folder without rows",
        hint=f"{todo} with `--out NEW_FOLDER`",
    )


def _valid_rows(study: Study, place: StudyFolder, *, retry_failed: bool) -> dict[int, str]:
    """Return the status of the rows that need no computing; all must be of this study."""
    if not isinstance(study.plan, Search):  # its rows follow from each other, round by round
        _check_rows(study, place, place.rows())
    elif retry_failed and any(row.status == "failed" for row in place.rows()):
        raise StudyError(
            "an optimisation does not compute failed variants again",
            expected="resume without --retry-failed",
            hint="later choices follow from their failure; restart with `--out`",
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
                hint="restart in another folder with `--out`",
            )


def _other_version(before: str) -> str:
    return (
        f"the study was begun with version {before}, this is {code_version()}: "
        "the rows say which computed them"
    )
