"""Blocks of seeds: each is searched once, by one of the processes at work, whatever ends them.

What a block has found is a file; what is searched has a lock that ends with its process. Cases are
tried in a fork, so that one that hangs or takes its process down is told, and the next one tried.
"""

import fcntl
import json
import os
import select
import signal
import time
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

# Far more than any case takes, on a machine with other work.
LONGEST_S = 300.0
FOUND = "found"


class FoundError(Exception):
    """A forbidden outcome."""


@dataclass(frozen=True)
class Kind:
    """A kind of cases; `case` tries one seed and says in a word what became of it."""

    name: str
    case: Callable[[int], str]
    block: int

    def blocks(self, seeds: range) -> Iterator[range]:
        """Go through the blocks that hold the seeds."""
        for first in range(seeds.start - seeds.start % self.block, seeds.stop, self.block):
            yield range(max(first, seeds.start), min(first + self.block, seeds.stop))


@dataclass(frozen=True)
class Place:
    """The folder of a campaign."""

    folder: Path

    def search(self, kind: Kind, seeds: range) -> None:
        """Try the cases of a block that nobody has tried, or is at work on."""
        file = self._file(kind, seeds)
        file.parent.mkdir(parents=True, exist_ok=True)
        with file.with_suffix(".lock").open("w") as lock, suppress(BlockingIOError):
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            if file.exists():
                return
            counts, findings = tried(kind, seeds)
            part = file.with_suffix(".part")
            part.write_text(json.dumps({"counts": counts, "findings": findings}))
            part.replace(file)

    def told(self, kind: Kind, seeds: range) -> tuple[Counter[str], list[str]]:
        """Return what became of the cases of all blocks that are done, and what was found."""
        counts: Counter[str] = Counter()
        findings: list[str] = []
        for block in kind.blocks(seeds):
            with suppress(FileNotFoundError):
                told = json.loads(self._file(kind, block).read_text())
                counts.update(told["counts"])
                findings += told["findings"]
        return counts, findings

    def _file(self, kind: Kind, seeds: range) -> Path:
        return self.folder / f"{kind.name}-{seeds.start}-{seeds.stop}.json"


def tried(kind: Kind, seeds: range) -> tuple[Counter[str], list[str]]:
    """Try cases in forks, one after the other in the same as long as it lives."""
    counts: Counter[str] = Counter()
    findings: list[str] = []
    following = seeds.start
    while following < seeds.stop:
        for outcome, what in in_a_fork(kind, range(following, seeds.stop)):
            counts[outcome] += 1
            if outcome == FOUND:
                findings.append(f"{following}: {what}")
            following += 1
    return counts, findings


def in_a_fork(kind: Kind, seeds: range) -> Iterator[tuple[str, str]]:
    """Try cases until one ends or outlasts the fork; tell of each."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(reading)
        work(kind, seeds, writing)
    os.close(writing)
    told, rest = 0, b""
    try:
        while told < len(seeds):
            ready = select.select([reading], [], [], LONGEST_S)[0]
            part = os.read(reading, 65536) if ready else b""
            *lines, rest = (rest + part).split(b"\n")
            for line in lines:
                outcome, what = json.loads(line)
                told += 1
                yield outcome, what
            if not part:
                how = "took its process down" if ready else f"not done within {LONGEST_S:g} s"
                yield FOUND, how
                return
    finally:
        os.close(reading)
        with suppress(ProcessLookupError):
            os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)


def work(kind: Kind, seeds: range, writing: int) -> None:
    """Try cases, and write a line of each, in the fork."""
    for number in (signal.SIGTERM, signal.SIGINT):
        signal.signal(number, signal.SIG_DFL)
    parent = os.getppid()
    with os.fdopen(writing, "w") as told:
        for seed in seeds:
            if os.getppid() != parent:  # it was killed: nobody listens
                break
            print(json.dumps(judged(kind, seed)), file=told, flush=True)
        time.sleep(0)
    os._exit(0)


def judged(kind: Kind, seed: int) -> tuple[str, str]:
    """Try one case; whatever it raises that its kind does not know is a finding."""
    try:
        return kind.case(seed), ""
    except BaseException as error:
        return FOUND, f"{type(error).__name__}: {error}"[:500]
