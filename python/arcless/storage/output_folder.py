"""An output folder that holds finished files or none."""

import os
import shutil
import time
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Self

from arcless.errors import OutputError
from arcless.platforms.moving import move
from arcless.storage.deferred_signals import deferred_signals

if TYPE_CHECKING:
    from arcless.storage.hidden_files import Claim
    from arcless.storage.lock import Lock

# Makes the error for a folder that holds some of the files already.
Refusal = Callable[[Path, Sequence[str]], OutputError]

_OLD = "old-"
# Intervals for an interrupted run to notice that its folder is gone: 0.2 s in all.
_TRIES, _BETWEEN_TRIES_S = 20, 0.01


class OutputFolder:
    """Files are made in a hidden folder inside and moved to their names when all are done.

    Entering proves that the folder can be written, before any computing. Leaving without
    `publish` removes whatever was made, the folder itself included if it is new. Of the `files`
    that belong together the others follow from the first: those of an older run go when it is
    replaced, so that none ever tells of another run than the first does. A link that has the
    name of a file is itself replaced, not the file it leads to. A folder there is refused.

    Two processes cannot have one folder at the same time: the second one is refused.

    Parameters
    ----------
    path
        The folder.
    *files
        Names of the files that belong together.
    refusal
        Makes the error where any of the files is there, before the computing and when the files
        are moved. Without it they are replaced.
    """

    def __init__(self, path: Path, *files: str, refusal: Refusal | None = None) -> None:
        self.path = path
        self._files = files
        self._refusal = refusal
        self._made: list[Path] = []  # folders that did not exist before, outermost first
        self._claim: Claim | None = None
        self._lock: Lock | None = None

    def __enter__(self) -> Self:
        """Make the folder and a hidden one inside it."""
        from arcless.storage import hidden_files

        self._staging = self.path / hidden_files.new_name()
        self._check_free()
        try:
            for folder in reversed([self.path, *self.path.parents]):
                if not os.path.exists(folder):  # noqa: PTH110 - `Path.exists` fails on long names
                    self._made.append(folder)
                    folder.mkdir(exist_ok=True)
            hidden_files.sweep(self.path)
            self._lock = hidden_files.claim_folder(self.path)
            if self._lock is None:
                raise self._in_use()
            self._check_free()  # another process may have been faster
            self._claim = hidden_files.create_folder(self._staging)
        except BaseException as error:
            self._clear()
            if isinstance(error, OSError):
                raise self._cannot_write(error) from error
            raise
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        """Remove what was not published; name files in an error as the user knows them."""
        self._clear()
        if isinstance(error, OutputError) and error.where:
            error.where = error.where.replace(str(self._staging), str(self.path))

    def file(self, name: str) -> Path:
        """Return the path at which to write one of the files."""
        return self._staging / name

    def publish(self) -> list[Path]:
        """Move all files that were made to their names and return these."""
        from arcless.storage.whole_files import sync_folder

        try:
            published = sorted(self.path / staged.name for staged in self._staging.iterdir())
            with deferred_signals():
                self._check_free()
                self._move()
            sync_folder(self.path)
        except OSError as error:
            raise self._cannot_write(error) from error
        return published

    def _move(self) -> None:
        first, *others = self._files
        made = [name for name in others if (self._staging / name).exists()]
        aside: list[str] = []
        try:
            for name in others:
                if os.path.lexists(self.path / name):
                    move(self.path / name, self._staging / f"{_OLD}{name}")
                    aside.append(name)
            move(self._staging / first, self.path / first)
        except OSError:
            for name in aside:
                move(self._staging / f"{_OLD}{name}", self.path / name)
            raise
        for name in made:
            move(self._staging / name, self.path / name)

    def _check_free(self) -> None:
        """Refuse folders where files are to be, which are not ours to move, and files to keep."""
        for name in self._files:
            if os.path.isdir(self.path / name):  # noqa: PTH112 - `Path.is_dir` fails on long names
                raise OutputError(
                    "the file cannot be written",
                    where=str(self.path / name),
                    got="a folder",
                    expected="a file, or nothing",
                    hint="move it away, or choose another folder with `--out`",
                )
        there = [name for name in self._files if os.path.lexists(self.path / name)]
        if there and self._refusal is not None:
            raise self._refusal(self.path, there)

    def _in_use(self) -> OutputError:
        return OutputError(
            "another process writes into the output folder",
            where=str(self.path),
            expected="a folder of its own for each run",
            hint="wait for the other one, or choose another folder with `--out`",
        )

    def _clear(self) -> None:
        from arcless.storage import hidden_files

        with deferred_signals():
            self._remove()
            if self._claim is not None:
                self._claim.close()
            if self._lock is not None:
                hidden_files.release(self._lock)
            for folder in reversed(self._made):
                with suppress(OSError):  # it holds published files, or was not made after all
                    folder.rmdir()

    def _remove(self) -> None:
        """Remove the hidden folder, although a run that is cut off may still write into it."""
        for _ in range(_TRIES):
            shutil.rmtree(self._staging, ignore_errors=True)
            if not os.path.lexists(self._staging):
                return
            time.sleep(_BETWEEN_TRIES_S)

    def _cannot_write(self, error: OSError) -> OutputError:
        what, hint = "the output folder cannot be written", "choose another one with `--out`"
        return OutputError.of(error, what, self.path, hint)
