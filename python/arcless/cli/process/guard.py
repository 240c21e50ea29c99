"""The one place where a failure becomes a message and an exit code."""

import os
import sys
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import typer
from typer.core import TyperGroup
from typer.exceptions import TyperException

from arcless.cli.process import interrupts
from arcless.cli.process.background import unfinished
from arcless.cli.terminal import console
from arcless.errors import ArclessError

FAILED = 1  # the computation failed, and nothing was written
WRONG_INPUT = 2
NOT_MET = 3  # done and written, and a limit that decides is not met
_INTERRUPTED_BY_TYPER = 130  # what typer turns Ctrl-C into; ours is documented as FAILED


class GuardedGroup(TyperGroup):
    """The commands, with every exception turned into a message: no user sees a traceback."""

    def main(self, *args: Any, **options: Any) -> Any:
        """Run one command line and leave the process with the documented exit code."""
        options["standalone_mode"] = False
        for stream in (sys.stdout, sys.stderr):
            if hasattr(stream, "reconfigure"):
                # On a terminal that cannot show σ; a file or a pipe of Windows could not hold it.
                own = sys.platform == "win32" and not stream.isatty()
                stream.reconfigure(errors="replace", encoding="utf-8" if own else None)
        with _own_warnings():
            code = exit_code_of(lambda: super(GuardedGroup, self).main(*args, **options))
        if unfinished():  # a thread in native code would hold up, or break, an orderly exit
            os._exit(code)
        sys.exit(code)


def exit_code_of(command: Callable[[], Any]) -> int:
    """Run a command; report what goes wrong on standard error; return the exit code."""
    try:
        code = int(command() or 0)
    except (Exception, KeyboardInterrupt) as error:
        if os.environ.get("ARCLESS_TRACEBACK"):
            raise
        # A failure after a signal has ended the work follows from that: a closed terminal.
        return _report(KeyboardInterrupt() if interrupts.ended() else error)
    return _report(KeyboardInterrupt()) if code == _INTERRUPTED_BY_TYPER else code


@contextmanager
def _own_warnings() -> Iterator[None]:
    """Print warnings of Arcless as sentences; those of libraries stay as Python prints them."""
    others = warnings.showwarning

    def show(message: Warning | str, category: type[Warning], *rest: Any, **named: Any) -> None:
        if category.__module__.startswith("arcless"):
            console.warn(str(message))
        else:
            others(message, category, *rest, **named)

    warnings.showwarning = show
    try:
        yield
    finally:
        warnings.showwarning = others


def _report(error: BaseException) -> int:
    """Print one message for a failure; return its exit code."""
    match error:
        case ArclessError():
            code = error.exit_code
            console.fail(str(error))
        case TyperException():
            code = WRONG_INPUT
            console.fail(error.format_message().rstrip("."), _usage_hint(error))
        case KeyboardInterrupt() | typer.Abort():
            code = interrupts.exit_code(FAILED)
            console.note(interrupts.word())
        case MemoryError():
            code = FAILED
            hint = "record less (`--set output.line_every=50`) or shorten the line"
            console.fail("not enough memory for this run", hint)
        case OSError():
            code = WRONG_INPUT
            place = f"{error.filename}: " if error.filename else ""
            console.fail(f"{place}{error.strerror or error}")
        case _:
            code = FAILED
            console.fail(
                f"internal fault: {type(error).__name__}: {error}",
                "set ARCLESS_TRACEBACK=1 to see where, and please report it",
            )
    return code


def _usage_hint(error: TyperException) -> str | None:
    context = getattr(error, "ctx", None)
    return f"see `{context.command_path} --help`" if context else None
