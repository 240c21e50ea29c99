"""Lines of a CSV file: those that hold no samples, and the one that has too few or many cells."""

import csv
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from arcless.errors import MeasurementError
from arcless.measurements.table.dialect import Dialect, is_content, line_too_long, lone_return

# Bytes that are looked at together: the memory that it takes is a few times this.
BLOCK_BYTES = 2**22
# Lines of a file, by which memory is bounded as well: eleven hours at 500 Hz.
MOST_LINES = 20_000_000
_NEWLINE, _RETURN, _HASH = b"\n"[0], b"\r"[0], b"#"[0]


@dataclass(frozen=True)
class Rows:
    """Lines of a file.

    Attributes
    ----------
    lines
        How many there are.
    skipped
        Numbers of those that are no samples, from 1: comments, empty ones, the header.
    """

    lines: int
    skipped: tuple[int, ...]

    @cached_property
    def numbers(self) -> NDArray[np.int64]:
        """Number of the line of each sample, from 1."""
        every = np.arange(1, self.lines + 1)
        return every[~np.isin(every, self.skipped)]


def scan(path: Path, dialect: Dialect) -> Rows:
    """Count the cells of every line.

    Raises
    ------
    MeasurementError
        A line has another number of cells than the header, another end, or binary data, or there
        are too many.
    """
    label, skipped = str(path), list(range(1, dialect.header_line + 1))
    wanted, done = len(dialect.header) - 1, 0
    delimiter = dialect.delimiter.encode()[0]
    for block in _blocks(path, label):
        if b"\0" in block:
            raise MeasurementError("not a text file", where=label, got="binary data")
        letters = np.frombuffer(block, np.uint8)
        ends = np.flatnonzero(letters == _NEWLINE)
        starts = np.concatenate([[0], ends[:-1] + 1])
        returns = np.flatnonzero(letters == _RETURN)
        if (alone := returns[letters[returns + 1] != _NEWLINE]).size:
            raise lone_return(f"{label}:{done + int(np.searchsorted(ends, alone[0])) + 1}")
        places = np.flatnonzero(letters == delimiter)
        cuts = np.searchsorted(places, ends)
        counts = np.diff(cuts, prepend=0)
        for line in np.flatnonzero((counts != wanted) | (letters[starts] == _HASH)):
            number = done + int(line) + 1
            if number > dialect.header_line:
                text = block[starts[line] : ends[line]].decode("utf-8", "replace")
                if not is_content(text):
                    skipped.append(number)
                else:
                    _check(text, dialect, f"{label}:{number}")
        done += len(ends)
        if done > MOST_LINES:
            raise MeasurementError(
                "too many rows", where=label, got=f"more than {MOST_LINES} lines",
                expected=f"at most {MOST_LINES}, for they are held in memory",
                hint="split the record by place",
            )  # fmt: skip
    return Rows(done, tuple(skipped))


def _blocks(path: Path, label: str) -> Iterator[bytes]:
    """Yield the file in parts of whole lines; the last one ends in a newline, too."""
    rest = b""
    with path.open("rb") as file:
        while portion := file.read(BLOCK_BYTES):
            whole, newline, rest_of = (rest + portion).rpartition(b"\n")
            rest = rest_of
            if newline:
                yield whole + newline
            elif len(rest) > BLOCK_BYTES:
                raise line_too_long(label)
    if rest:
        yield rest + b"\n"


def _check(text: str, dialect: Dialect, where: str) -> None:
    """Refuse a line with another number of cells; delimiters in quotes do not count."""
    cells = next(csv.reader([text], delimiter=dialect.delimiter, skipinitialspace=True))
    if len(cells) == len(dialect.header):
        return
    raise MeasurementError(
        "wrong number of cells",
        where=where,
        got=str(len(cells)),
        expected=f"{len(dialect.header)}, one for each column of the header",
        hint=_hint(text, len(cells), dialect),
    )


def _hint(text: str, cells: int, dialect: Dialect) -> str:
    """Return what is likely wrong with a line of another number of cells."""
    if cells == 1 and any(other in text for other in ",;\t"):
        return "separate the cells as those of the header"
    if cells < len(dialect.header):
        return "leave a cell empty where there is no value"
    if dialect.delimiter == ",":
        return "a decimal comma? Then separate the columns by semicolons"
    return "one delimiter between cells, the same as in the header"
