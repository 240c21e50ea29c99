"""Tables as CSV files: comma, decimal point, UTF-8, units in the header, whole or absent."""

import csv
import io
import math
from collections.abc import Iterable, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO, TypeAlias

from arcless.storage.whole_files import replacing

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Values: TypeAlias = Sequence[Any] | NDArray[Any]

# Rows are written in portions: a table is never as text in memory.
ROWS_AT_ONCE = 4096


@dataclass(frozen=True)
class Column:
    """One column of a table.

    Attributes
    ----------
    name
        What it holds.
    unit
        As printed; empty for texts and numbers without one.
    values
        One for each row; None and NaN are empty cells.
    decimals
        Digits after the point in a CSV file; None keeps every bit.
    """

    name: str
    unit: str
    values: "Values"
    decimals: int | None = None

    @property
    def header(self) -> str:
        """Name, and the unit in brackets where there is one."""
        return f"{self.name} [{self.unit}]" if self.unit else self.name


def write_csv(path: str | Path, columns: Sequence[Column]) -> None:
    """Write columns of one length as a CSV file; one that exists is replaced.

    Numbers of a column without `decimals` are written so that reading gives the same bits again.

    Raises
    ------
    OutputError
        The file cannot be written.
    """
    write_csv_files({Path(path): columns})


def write_csv_files(tables: Mapping[Path, Sequence[Column]]) -> None:
    """Write several tables, by file: none takes its place before all are written; see `write_csv`.

    Raises
    ------
    OutputError
        One of the files cannot be written.
    """
    with ExitStack() as stack:
        for path, columns in tables.items():
            _write(stack.enter_context(replacing(path)), columns)


def csv_text(columns: Sequence[Column]) -> str:
    """Return columns of one length as the text of a CSV file; see `write_csv`."""
    file = io.BytesIO()
    _write(file, columns)
    return file.getvalue().decode()


def _write(file: BinaryIO, columns: Sequence[Column]) -> None:
    text = io.TextIOWrapper(file, encoding="utf-8", newline="", write_through=True)
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([column.header for column in columns])
    for start in range(0, len(columns[0].values), ROWS_AT_ONCE):
        portion = [_written(column, start) for column in columns]
        writer.writerows(zip(*portion, strict=True))
    text.detach()


def _written(column: Column, start: int) -> list[Any]:
    values = cells(column.values[start : start + ROWS_AT_ONCE])
    if column.decimals is None:
        return values
    return [None if value is None else f"{value:.{column.decimals}f}" for value in values]


def cells(values: Iterable[Any]) -> list[Any]:
    """Return plain Python values; what is no number (NaN) is None, an empty cell."""
    plain = values.tolist() if hasattr(values, "tolist") else list(values)
    return [None if isinstance(v, float) and math.isnan(v) else v for v in plain]
