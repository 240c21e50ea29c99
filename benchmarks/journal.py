"""A row in the journal of a study beside one as a line of JSON: `python -m benchmarks.journal`.

Processor time, as a disk that is shared says little; the best of some rounds.
"""

import json
import time
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

from arcless.study.journal.journal import Journal, rows
from arcless.study.journal.row import Row, row_of
from arcless.study.journal.salvage import Damage

COUNT, ROUNDS = 10_000, 3
STUDY = "0123456789abcdef"


def row(number: int) -> Row:
    """Return a row with three variables and five outputs."""
    values = {"tension": 18e3 + number / 7, "force": 70.0 + number / 3, "speed": 80.123456789}
    names = ("sigma", "ratio", "loss", "uplift", "mean")
    outputs = {name: number / (7.0 + place) for place, name in enumerate(names)}
    return Row(number, STUDY, values, "done", outputs, "", 0.0123, "0.1.0+d6b91364c468")


def spent(work: Callable[[], object]) -> float:
    """Return the processor time of some work in s."""
    began = time.process_time()
    work()
    return time.process_time() - began


def lines(file: Path, made: list[Row]) -> tuple[float, float]:
    """Return the times of writing and of reading lines of JSON."""

    def write() -> None:
        with file.open("ab", buffering=0) as open_file:
            for one in made:
                open_file.write(json.dumps(one.to_dict(), allow_nan=False).encode() + b"\n")

    def read() -> None:
        with file.open("rb") as open_file:
            assert all(row_of(json.loads(line)) is not None for line in open_file)

    return spent(write), spent(read)


def journal(file: Path, made: list[Row]) -> tuple[float, float]:
    """Return the times of writing and of reading the journal."""

    def write() -> None:
        with Journal(file, STUDY) as kept:
            for one in made:
                kept.append(one)

    def read() -> None:
        damage = Damage()
        assert sum(1 for _ in rows(file, STUDY, damage)) == COUNT
        assert not damage.found

    return spent(write), spent(read)


def main() -> None:
    """Measure both, and print them."""
    made = [row(number) for number in range(1, COUNT + 1)]
    for name, measure in (("lines of JSON", lines), ("journal", journal)):
        taken = []
        for _ in range(ROUNDS):
            with TemporaryDirectory() as folder:
                taken.append(measure(Path(folder) / "journal.db", made))
        write, read = (min(times) / COUNT * 1e6 for times in zip(*taken, strict=True))
        print(f"{name}: {write:.0f} µs a row written, {read:.0f} µs read")


if __name__ == "__main__":
    main()
