"""Studies that this server computes: `arcless study run`, each in a process of its own.

The process keeps its journal itself; the server only starts it, and stops it as Ctrl-C would. So a
study is continued as well from a terminal, and the other way round.
"""

import os
import signal
import subprocess
import sys
import tempfile
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import IO

from arcless.errors import StudyError
from arcless.studio.answers.wording import in_words_of_the_page

# Time in s for a study to write its table when the server ends. Its rows are on the disk already;
# shorter, the table is older than the rows.
LAST_TABLE = 3.0
# Bytes of what a study said last that are looked at.
_LAST_WORDS = 4096


@dataclass
class _Process:
    process: subprocess.Popen[bytes]
    said: IO[bytes]
    is_stopped: bool = False


class Computing:
    """Processes by the folder of their study."""

    def __init__(self) -> None:
        self._all: dict[Path, _Process] = {}

    def start(self, words: list[str], folder: Path, project: Path) -> None:
        """Start `arcless study WORDS`.

        Parameters
        ----------
        words
            Of the command line, after `study`.
        folder, project
            The study's folder, and the folder the command runs in.

        Raises
        ------
        StudyError
            It is computed already.
        """
        if self.is_running(folder):
            raise already(folder)
        said = tempfile.TemporaryFile()  # noqa: SIM115 - closed with the process
        process = subprocess.Popen(
            [sys.executable, "-m", "arcless", "study", *words],
            cwd=project,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=said,
            env={**os.environ, "NO_COLOR": "1"},
            # Ctrl-C of the server's terminal is not for it: the server stops it.
            start_new_session=True,
        )
        self._all[folder] = _Process(process, said)

    def write_report(self, folder: Path) -> None:
        """Write the report of a study, in a process of its own: it takes seconds.

        Raises
        ------
        StudyError
            It cannot be written; the message says why.
        """
        command = [sys.executable, "-m", "arcless", "study", "report", os.fspath(folder)]
        done = subprocess.run(command, capture_output=True, check=False, stdin=subprocess.DEVNULL)
        if done.returncode:
            raise StudyError("no report of the study", got=_last_error(done.stderr))

    def is_running(self, folder: Path) -> bool:
        """Return whether the process of a study runs."""
        one = self._all.get(folder)
        return one is not None and one.process.poll() is None

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
        one = self._all[folder]
        one.is_stopped = True
        one.process.send_signal(signal.SIGINT)

    def error(self, folder: Path) -> str | None:
        """Return what ended a study before its time, in a sentence; None where nothing did."""
        one = self._all.get(folder)
        if one is None or one.is_stopped or not one.process.poll():
            return None
        one.said.seek(0)
        return _last_error(one.said.read())

    @asynccontextmanager
    async def at_work(self) -> AsyncIterator[None]:
        """Be there while the server is; stop all studies with it, which keep their rows."""
        yield
        running = [one for one in self._all.values() if one.process.poll() is None]
        for one in running:
            one.process.send_signal(signal.SIGINT)
        for one in running:
            try:
                one.process.wait(LAST_TABLE)
            except subprocess.TimeoutExpired:
                one.process.kill()


def already(folder: Path) -> StudyError:
    """Return the error of a study that this server computes."""
    what = "the study is being computed already"
    return StudyError(what, where=folder.name, hint="stop it first")


def _last_error(said: bytes) -> str:
    lines = said[-_LAST_WORDS:].decode("utf-8", "replace").strip().splitlines()
    errors = [line for line in lines if line.startswith("error: ")]
    last = (errors or lines or ["the process ended"])[-1].removeprefix("error: ")
    return in_words_of_the_page(last)
