"""The progress bar of a study: rate, time to the end, failures."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from arcless.study import Progress


@contextmanager
def progress(*, quiet: bool = False) -> "Iterator[Callable[[Progress], None] | None]":
    """Show a bar on standard error while a study is computed; nothing if that is no terminal."""
    import sys

    if quiet or not sys.stderr.isatty():
        yield None
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, TextColumn
    from rich.progress import Progress as Bar

    from arcless.cli.terminal.console import lasting

    columns = (BarColumn(), MofNCompleteColumn(), TextColumn("{task.description}"))
    with Bar(*columns, console=Console(file=lasting()), transient=True) as bar:
        task = bar.add_task("", total=None)

        def tell(now: "Progress") -> None:
            bar.update(task, completed=now.there, total=now.total, description=words(now))

        yield tell


def words(now: "Progress") -> str:
    """Say rate, time to the end, and failures."""
    bad = [
        f"{now.counts[name]} {name}" for name in ("failed", "invalid", "pruned") if now.counts[name]
    ]
    if now.rate is None or now.remaining_s is None:
        return ", ".join(bad)
    minutes, seconds = divmod(round(now.remaining_s), 60)
    hours, minutes = divmod(minutes, 60)
    left = f"{hours}:{minutes:02}:{seconds:02} left"
    return ", ".join([f"{now.rate:.3g}/s", left, *bad])
