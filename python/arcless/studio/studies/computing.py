"""Studies that this server computes, each in a process of its own.

The process keeps its journal itself; the server only starts it, and stops it as Ctrl-C would. So a
study is continued as well from a terminal, and the other way round.
"""

import os
from collections.abc import AsyncIterator
from concurrent.futures import Future
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

from arcless import study
from arcless.errors import ArclessError, StudyError
from arcless.studio.answers.page_words import in_page_words
from arcless.studio.processes.ends import Cancelled, Failed
from arcless.studio.processes.talk import Talk
from arcless.studio.processes.worker import Worker

# Time in s for a study to write its table when the server ends. Its rows are on the disk already;
# shorter, the table is older than the rows; longer, a study that hangs outlives the server.
LAST_TABLE = 5.0
# Time in s for a study that is stopped to put its table and its workers in order, before it is
# ended by force: a cluster of Dask takes the longest.
STOPS_WITHIN = 20.0


class Computing:
    """Processes by the folder of their study."""

    def __init__(self) -> None:
        self._all: dict[Path, tuple[Worker, Future[Any]]] = {}

    def start(
        self, file: Path, folder: Path, project: Path, *,
        resume: bool = False, retry_failed: bool = False,
    ) -> None:  # fmt: skip
        """Start a study, or continue it, as `arcless study` does.

        Parameters
        ----------
        file
            The study file.
        folder, project
            The study's folder, and the folder below which it is the usual one.
        resume, retry_failed
            See `arcless.study.run`.

        Raises
        ------
        StudyError
            It is computed already.
        """
        if self.is_running(folder):
            raise already(folder)
        worker = Worker(LAST_TABLE)
        end = worker.do(_compute, file, project, resume, retry_failed)
        end.add_done_callback(lambda _: worker.leave())
        self._all[folder] = worker, end

    def write_report(self, folder: Path) -> None:
        """Write the report of a study, in a process of its own: it takes seconds.

        Raises
        ------
        StudyError
            It cannot be written; the message says why.
        """
        worker = Worker()
        try:
            worker.do(_report, folder).result()
        except (ArclessError, Failed) as error:
            raise StudyError("no report of the study", got=str(error)) from None
        finally:
            worker.leave()

    def is_running(self, folder: Path) -> bool:
        """Return whether a study is being computed."""
        one = self._all.get(folder)
        return one is not None and not one[1].done()

    def stop(self, folder: Path) -> None:
        """Stop a study, which keeps its rows.

        Raises
        ------
        StudyError
            This server does not compute it.
        """
        if not self.is_running(folder):
            raise StudyError(
                "the study is not computed by this studio", where=folder.name,
                hint="stop it where it was started",
            )  # fmt: skip
        self._all[folder][0].cancel(STOPS_WITHIN)

    def error(self, folder: Path) -> str | None:
        """Return what ended a study before its time, in a sentence; None where nothing did."""
        one = self._all.get(folder)
        error = one[1].exception() if one is not None and one[1].done() else None
        if error is None or isinstance(error, Cancelled):
            return None
        return in_page_words(str(error))

    @asynccontextmanager
    async def at_work(self) -> AsyncIterator[None]:
        """Be there while the server is; stop all studies with it, which keep their rows."""
        yield
        for worker, _ in self._all.values():
            worker.leave(LAST_TABLE)


def already(folder: Path) -> StudyError:
    """Return the error of a study that this server computes."""
    what = "the study is being computed already"
    return StudyError(what, where=folder.name, hint="stop it first")


def _compute(talk: Talk, file: Path, project: Path, resume: bool, retry_failed: bool) -> None:
    os.chdir(project)  # the usual folder of a study is below the current one
    asked = study.load(file)
    done = study.run(asked, resume=resume, retry_failed=retry_failed, cancel=talk.cancel)
    if not done.counts["done"]:
        raise StudyError("no variant has a value", where=asked.name, hint="each row says why")


def _report(_talk: Talk, folder: Path) -> None:
    from arcless.study.folder.started_studies import located
    from arcless.study.report import write

    write(*located(folder))
