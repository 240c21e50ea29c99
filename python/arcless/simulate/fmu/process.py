"""Process in which an FMU runs, as Arcless sees it: started, asked, watched and ended."""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import threading
import time
import zipfile
from contextlib import suppress
from importlib.util import find_spec
from pathlib import Path
from typing import IO, Any

from arcless.errors import FmuError
from arcless.platforms.children import environment
from arcless.platforms.ends import why_ended
from arcless.simulate.fmu import fmu_process

# Interval in s between two looks at the clock of an answer: a limit is kept within that.
_LOOK_EVERY_S = 0.05
# Time in s that Python may take to start in the process, on a machine that has much else to do.
_START_S = 120.0
# Characters of the last words of an FMU that a message quotes.
_LAST_WORDS = 300


class FmuProcess:
    """An FMU that runs alone in its process.

    Parameters
    ----------
    file
        The FMU. It is copied and unpacked into a folder that is removed at the end.
    time_limit_s
        Time in s that each answer may take.

    Attributes
    ----------
    file
        The copy, which nobody changes any more.
    """

    def __init__(self, file: Path, time_limit_s: float) -> None:
        if find_spec("fmpy") is None:
            raise FmuError("FMPy is not there, which runs FMUs", hint="pip install 'arcless[fmi]'")
        self._limit = time_limit_s
        self._folder = Path(tempfile.mkdtemp(prefix="arcless-fmu-"))
        self._deadline: float | None = None
        self._hung = self._closed = False
        self._words = self._folder / "words.txt"
        try:
            self.file = _copied(file, self._folder)
            self._process = self._started()
        except BaseException:
            shutil.rmtree(self._folder, ignore_errors=True)
            raise
        threading.Thread(target=self._watch, daemon=True).start()

    def _started(self) -> "subprocess.Popen[bytes]":
        program = Path(fmu_process.__file__).resolve()
        with self._words.open("wb") as words:
            return subprocess.Popen(
                [sys.executable, "-P", str(program), str(os.getpid())],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=words,
                env=environment(),
                cwd=self._folder,
            )

    def load(self, given: dict[str, Any]) -> tuple[float, ...]:
        """Load and initialise the FMU; return the heights of its strips in its unit.

        Raises
        ------
        FmuError
            It cannot be loaded.
        """
        folder = _unpacked(self.file, self._folder / "fmu")
        self._answer(_START_S, b"")
        content = json.dumps({**given, "folder": str(folder)}).encode()
        return fmu_process.doubles(self.ask(fmu_process.LOAD, content))

    def ask(self, kind: bytes, content: bytes) -> bytes:
        """Return the answer to a request.

        Raises
        ------
        FmuError
            The FMU refused, crashed, ended, or took too long.
        """
        return self._answer(self._limit, fmu_process.frame(kind, content))

    def _answer(self, within_s: float, asked: bytes) -> bytes:
        """Send what is asked, and return the next answer, which may take a time in s."""
        self._deadline = time.monotonic() + within_s
        try:
            to = _raw(self._process.stdin)
            to.write(asked)
            to.flush()
            answer = fmu_process.read_frame(_raw(self._process.stdout))
        except OSError:
            answer = None
        finally:
            self._deadline = None
        if answer is None:
            raise self._gone(within_s)
        how, found = answer
        if how == fmu_process.FAILED:
            said = json.loads(found)
            raise FmuError("the FMU failed", got=said["text"] or said["error"], hint=self._hint())
        return found

    def close(self) -> None:
        """End the process and remove what was unpacked."""
        if self._closed:
            return
        self._closed = True
        self._process.kill()
        self._process.wait()
        for stream in (self._process.stdin, self._process.stdout):
            with suppress(OSError):
                _raw(stream).close()
        shutil.rmtree(self._folder, ignore_errors=True)

    def _watch(self) -> None:
        """Kill a process that does not answer in time."""
        while self._process.poll() is None:
            deadline = self._deadline
            if deadline is not None and time.monotonic() > deadline:
                self._hung = True
                self._process.kill()
                return
            time.sleep(_LOOK_EVERY_S)

    def _gone(self, within_s: float) -> FmuError:
        """Return why the process ended."""
        code = self._process.wait()
        if self._hung:
            return FmuError(
                "the FMU hangs",
                got=f"no answer within {within_s:g} s",
                hint="give a longer time_limit if it only is slow",
            )
        words, _ = why_ended(code)
        return FmuError("the FMU is gone", got=words, hint=self._hint())

    def _hint(self) -> str | None:
        """Return the last words of the FMU as a hint."""
        try:
            with self._words.open("rb") as words:
                words.seek(max(0, self._words.stat().st_size - 4 * _LAST_WORDS))
                written = words.read()
        except OSError:
            return None
        text = written.decode("utf-8", "replace").strip()
        return f"its last words: {' '.join(text.split())[-_LAST_WORDS:]}" if text else None


def _raw(stream: IO[bytes] | None) -> Any:
    assert stream is not None
    return stream


def _copied(file: Path, folder: Path) -> Path:
    """Copy an FMU into a folder, and return the copy."""
    copy = folder / "copy.fmu"
    try:
        shutil.copyfile(file, copy)
    except OSError as error:
        raise FmuError(
            "the FMU cannot be copied", where=str(file), got=error.strerror or str(error)
        ) from error
    return copy


def _unpacked(file: Path, folder: Path) -> Path:
    """Unpack an FMU into a new folder, and return that."""
    try:
        with zipfile.ZipFile(file) as archive:
            archive.extractall(folder)
    except (OSError, zipfile.BadZipFile, RuntimeError, NotImplementedError, ValueError) as error:
        raise FmuError("the FMU cannot be unpacked", got=str(error)) from error
    return folder
