"""An output folder that holds finished files or none."""

import shutil
import tempfile
from pathlib import Path
from types import TracebackType
from typing import Self

from arcless.errors import OutputError
from arcless.units import show


def check_place(file: Path, suffix: str, option: str) -> None:
    """Refuse a file that could not be written after the computing, before it."""
    if file.suffix.lower() != suffix:
        raise OutputError(
            f"not a {suffix} file",
            where=str(file),
            got=show(file.suffix) if file.suffix else "a name without an ending",
            expected=f"a name that ends in {suffix}",
            hint=f"this is the only form that `{option}` writes; a browser can print it",
        )
    folder = file.parent
    if not folder.is_dir() or file.is_dir():
        raise OutputError(
            "the file cannot be written",
            where=str(file),
            got="a folder" if file.is_dir() else f"no folder {folder}",
            expected="a file in a folder that exists",
        )


class OutputFolder:
    """Files are made in a hidden folder inside and moved to their names when all are done.

    Entering proves that the folder can be written, before any computing. Leaving without
    `publish` removes whatever was made, the folder itself included if it is new.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self._made: list[Path] = []  # folders that did not exist before, outermost first

    def __enter__(self) -> Self:
        """Make the folder and a hidden one inside it."""
        try:
            for folder in reversed([self.path, *self.path.parents]):
                if not folder.exists():
                    folder.mkdir(exist_ok=True)
                    self._made.append(folder)
            self._staging = Path(tempfile.mkdtemp(prefix=".arcless-", dir=self.path))
        except OSError as error:
            self._remove_made()
            raise self._cannot_write(error) from error
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        """Remove what was not published."""
        shutil.rmtree(self._staging, ignore_errors=True)
        self._remove_made()

    def file(self, name: str) -> Path:
        """Return the path at which to write a file called `name`."""
        return self._staging / name

    def publish(self) -> list[Path]:
        """Move all files to their names and return these."""
        try:
            published = [self.path / staged.name for staged in sorted(self._staging.iterdir())]
            for target in published:
                (self._staging / target.name).replace(target)
        except OSError as error:
            raise self._cannot_write(error) from error
        return published

    def _remove_made(self) -> None:
        for folder in reversed(self._made):
            try:
                folder.rmdir()
            except OSError:  # it holds published files
                return

    def _cannot_write(self, error: OSError) -> OutputError:
        return OutputError(
            "the output folder cannot be written",
            where=str(self.path),
            got=error.strerror or str(error),
            expected="a folder that can be made and written",
            hint="choose another one with `--out`",
        )
