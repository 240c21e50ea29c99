"""Streams of text: data to standard output, everything else to standard error."""

import errno
import json
import os
import re
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from io import TextIOBase
from typing import IO, TYPE_CHECKING, Any, TextIO, cast

if TYPE_CHECKING:
    from rich.console import Console, RenderableType

Progress = Callable[[float, str], None]

_TRAILING = re.compile(r"[ \t]+$", re.MULTILINE)
PIPE_WIDTH = 120  # columns of a table that no terminal limits


def write(stream: TextIO, text: str) -> None:
    """Write text; a reader that went away (`arcless library | head`) is no error."""
    try:
        stream.write(text)
        stream.flush()
    except OSError as error:
        if not _has_left(error):
            raise
        _lead_nowhere(stream)


def data(text: str) -> None:
    """Write one block of data to standard output."""
    write(sys.stdout, text + "\n")


def json_text(value: Any) -> str:
    """Return JSON; a NaN in it is a fault of ours and raises."""
    return json.dumps(value, indent=2, ensure_ascii=False, allow_nan=False)


def show(*blocks: "RenderableType", fold: bool = True) -> None:
    """Write tables and text to standard output, coloured only on a terminal.

    Without `fold` lines are as long as they are, and names in them can be copied as a whole.
    """
    write(sys.stdout, _render(sys.stdout, *blocks, fold=fold))


def note(text: str) -> None:
    """Write one line to standard error."""
    _say(text + "\n")


def warn(text: str) -> None:
    """Write a warning to standard error."""
    _labelled("warning", "yellow", text)


def fail(text: str, hint: str | None = None) -> None:
    """Write an error and its hint to standard error."""
    _labelled("error", "bold red", text)
    if hint:
        _labelled("hint", "cyan", hint)


@contextmanager
def progress(*, quiet: bool = False) -> Iterator[Progress | None]:
    """Show a bar on standard error while work is done; nothing if that is no terminal."""
    if quiet or not sys.stderr.isatty():
        yield None
        return
    from rich.console import Console
    from rich.progress import BarColumn, TaskProgressColumn, TextColumn, TimeRemainingColumn
    from rich.progress import Progress as Bar

    columns = (TextColumn("{task.description}"), BarColumn(), TaskProgressColumn())
    with Bar(
        *columns, TimeRemainingColumn(), console=Console(file=lasting()), transient=True
    ) as bar:
        task = bar.add_task("", total=1.0)

        def advance(fraction: float, text: str) -> None:
            bar.update(task, completed=fraction, description=text)

        yield advance


def _labelled(label: str, style: str, text: str) -> None:
    from rich.text import Text

    line = Text.assemble((label, style), ": ", text)
    _say(_render(sys.stderr, line, fold=False))


def lasting() -> IO[str]:
    """Return standard error for text that is drawn repeatedly, also after it was closed."""
    return cast(IO[str], _Lasting(sys.stderr))


class _Lasting(TextIOBase):
    def __init__(self, stream: TextIO) -> None:
        self._stream = stream  # while a bar is drawn, `sys.stderr` is the bar's

    def write(self, text: str) -> int:
        _say(text, self._stream)
        return len(text)

    def isatty(self) -> bool:
        return self._stream.isatty()

    def fileno(self) -> int:
        return self._stream.fileno()


def _say(text: str, stream: TextIO | None = None) -> None:
    """Write to standard error; work continues where nobody can read it any more."""
    stream = stream or sys.stderr
    try:
        write(stream, text)
    except OSError:
        _lead_nowhere(stream)


def _has_left(error: OSError) -> bool:
    """Return whether the reader of a pipe went away, which Windows calls an invalid argument."""
    return isinstance(error, BrokenPipeError) or (
        sys.platform == "win32" and error.errno == errno.EINVAL
    )


def _lead_nowhere(stream: TextIO) -> None:
    """Discard the text that is still to be written to a stream, also by Python when it ends."""
    with suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


def _render(stream: TextIO, *blocks: "RenderableType", fold: bool) -> str:
    console = _console(stream)
    with console.capture() as captured:
        for block in blocks:
            console.print(block, soft_wrap=not fold)
    text = captured.get()
    # Cells are filled up with blanks; in a pipe or a file nobody wants them.
    return text if stream.isatty() else _TRAILING.sub("", text)


def _console(stream: TextIO) -> "Console":
    from rich.console import Console

    width = None if stream.isatty() or "COLUMNS" in os.environ else PIPE_WIDTH
    return Console(file=stream, width=width, highlight=False, markup=False, emoji=False)
