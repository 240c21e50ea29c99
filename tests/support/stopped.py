"""Command lines in forked processes that are stopped at a chosen file operation or moment.

A process of its own (`python -m tests.support.stopped`), because it forks: everything slow is
imported once, so that a drill costs little more than the work that it stops. Its own arguments are
a command line to import by; then it reads one JSON object per line (a `Job`) and answers with
another (its `End`).
"""

import errno
import io
import json
import os
import select
import signal
import sys
import tempfile
import traceback
from contextlib import redirect_stdout, suppress
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from tests.support.studies import rows_in

# What is told before it happens and changes files; `open` counts when it may write.
CHANGES = {
    "open", "os.mkdir", "os.rename", "os.remove", "os.rmdir", "os.truncate", "os.link",
    "sqlite3.connect",
}  # fmt: skip
TAKES_ROOM = {"open", "os.mkdir"}
WRITES = os.O_WRONLY | os.O_RDWR
LIMIT_S = 120.0
SIGNALS = {
    "kill": signal.SIGKILL,
    "interrupt": signal.SIGINT,
    "terminate": signal.SIGTERM,
    "hang up": signal.SIGHUP,
}


@dataclass(frozen=True)
class Job:
    """A command line, and how it is stopped."""

    words: list[str]
    folder: str  # where it runs, and whose files count
    how: str  # kill, interrupt, terminate, hang up, full (disk), never
    operation: int = 0  # number of the file operation before which it happens, from 1
    moment_s: float = 0.0  # or the time after the start
    reads: bool = False  # opening a file to read it is an operation too
    rows: int = 0  # or when the journal of a study, named next, has so many rows
    file: str = ""
    size: int = 0  # or when the files below the folder hold so many bytes


@dataclass(frozen=True)
class End:
    """End of a command: exit code and output."""

    code: int  # negative: the signal
    operations: int  # seen until it was stopped or done
    out: str
    err: str


class Watch:
    """Counts file operations below a folder, and stops the process at one of them."""

    def __init__(self, job: Job, told: int) -> None:
        self.job, self.told, self.seen = job, told, 0
        self.busy = False

    def __call__(self, event: str, arguments: tuple[Any, ...]) -> None:
        if self.busy or event not in CHANGES or not self.counts(event, arguments):
            return
        self.busy = True
        self.seen += 1
        os.pwrite(self.told, b"%6d" % self.seen, 0)
        self.busy = False
        if self.job.how == "full" and event in TAKES_ROOM and self.seen >= self.job.operation > 0:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(arguments[0]))
        if self.seen == self.job.operation and self.job.how != "full":
            os.kill(os.getpid(), SIGNALS[self.job.how])

    def counts(self, event: str, arguments: tuple[Any, ...]) -> bool:
        if event == "sqlite3.connect":
            return f"{self.job.folder}/" in str(arguments[0])
        if event == "open" and not (self.job.reads or self.may_write(arguments[2])):
            return False
        path = arguments[0]
        if not isinstance(path, str | bytes | os.PathLike):
            return False
        return os.path.abspath(os.fsdecode(path)).startswith(self.job.folder)  # noqa: PTH100

    @staticmethod
    def may_write(flags: object) -> bool:
        return isinstance(flags, int) and bool(flags & WRITES)


def carry_out(job: Job, folder: Path) -> End:
    """Fork, run, stop, and read what was said."""
    files = [folder / name for name in ("stdout", "stderr", "told")]
    for file in files:
        file.write_bytes(b"")
    child = os.fork()
    if child == 0:
        try:
            become(job, files)
        except SystemExit as left:
            code = left.code if isinstance(left.code, int) else 1
            if isinstance(left.code, str):
                print(left.code, file=sys.stderr)  # noqa: T201 - as Python does
        except BaseException:
            traceback.print_exc()
            code = 99
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code)
    code = wait(child, job)
    out, err, told = (file.read_text("utf-8") for file in files)
    return End(code, int(told or 0), out, err)


def become(job: Job, files: list[Path]) -> None:
    """Be the command `arcless`, in the child."""
    from arcless.cli import main

    signal.signal(signal.SIGINT, signal.default_int_handler)
    for number in (signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)
    for number, file in ((1, files[0]), (2, files[1])):
        os.dup2(os.open(file, os.O_WRONLY), number)
    told = os.open(files[2], os.O_WRONLY)
    os.chdir(job.folder)
    sys.argv = ["arcless", *job.words]
    if job.how != "never" or job.operation:
        sys.addaudithook(Watch(job, told))
    main()


def wait(child: int, job: Job) -> int:
    """Stop the child at its moment, if it has one; return its exit code."""
    ended = os.pidfd_open(child)
    try:
        if job.moment_s or job.rows or job.size:
            if job.rows:
                wait_for_rows(ended, Path(job.folder) / job.file, job.rows)
            elif job.size:
                wait_for_size(ended, Path(job.folder), job.size)
            else:
                select.select([ended], [], [], job.moment_s)
            os.kill(child, SIGNALS[job.how])
        if not select.select([ended], [], [], LIMIT_S)[0]:
            os.kill(child, signal.SIGKILL)
    finally:
        os.close(ended)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


def wait_for_rows(ended: int, journal: Path, count: int) -> None:
    """Wait until a journal has so many rows, or the process has ended."""
    while not select.select([ended], [], [], 0.002)[0]:
        if rows_in(journal) >= count:
            return


def wait_for_size(ended: int, folder: Path, size: int) -> None:
    """Wait until the files below a folder hold so many bytes, or the process has ended."""
    while not select.select([ended], [], [], 0.002)[0]:
        if sum(size_of(path) for path in folder.rglob("*")) >= size:
            return


def size_of(path: Path) -> int:
    """Return the bytes of a file, none where it has just been renamed or removed."""
    try:
        return path.stat().st_size if path.is_file() else 0
    except FileNotFoundError:
        return 0


def main() -> None:
    """Do the command line of this process once, then answer jobs until there are none."""
    from arcless.cli import main as arcless

    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        with redirect_stdout(io.StringIO()), suppress(SystemExit):
            arcless()  # imports whatever the work needs
        with suppress(ImportError):
            import optuna  # noqa: F401 - and a study that optimises
        for line in sys.stdin:
            end = carry_out(Job(**json.loads(line)), Path(folder))
            print(json.dumps(asdict(end)), flush=True)  # noqa: T201


if __name__ == "__main__":
    main()
