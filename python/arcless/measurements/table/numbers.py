"""Cells of a CSV file → numbers; an empty cell is no number (NaN)."""

import csv
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from arcless.errors import MeasurementError
from arcless.measurements.table.columns import Column
from arcless.measurements.table.dialect import Dialect
from arcless.measurements.table.rows import Rows
from arcless.units import show

# Numbers beyond are no measurement, in SI: with them sums of squares are beyond all numbers.
LARGEST = 1e12
# Texts that stand for a missing sample.
MISSING = ("", "NaN", "nan", "NAN", "NA", "N/A", "-")


def numbers(
    path: Path, dialect: Dialect, rows: Rows, columns: list[Column]
) -> dict[Column, NDArray[np.float64]]:
    """Return columns of a file in SI.

    Raises
    ------
    MeasurementError
        A cell holds text; the message names its line and column.
    """
    import pandas

    try:
        frame = pandas.read_csv(
            path,
            sep=dialect.delimiter,
            decimal=dialect.decimal,
            header=None,
            index_col=False,
            usecols=sorted(column.place for column in columns),
            skiprows=[number - 1 for number in rows.skipped],
            dtype=np.float64,
            na_values=list(MISSING),
            keep_default_na=False,
            skipinitialspace=True,
            engine="c",
        )
    except (ValueError, pandas.errors.ParserError) as error:
        _refuse_text(path, dialect, rows, columns)
        raise MeasurementError(f"not a CSV file: {error}", where=str(path)) from None
    if len(frame) != rows.numbers.size:
        raise _quote_left_open(path, rows)
    found = {}
    for column in columns:
        with np.errstate(over="ignore"):  # beyond all numbers is beyond the largest
            values = frame[column.place].to_numpy(np.float64, copy=True) * column.factor
        values[np.isinf(frame[column.place])] = np.nan
        if (beyond := np.flatnonzero(np.abs(values) > LARGEST)).size:
            raise MeasurementError(
                f"column {column.title}",
                where=f"{path}:{rows.numbers[beyond[0]]}",
                got=f"{frame[column.place].iloc[beyond[0]]:g}",
                expected="a number that can be measured",
            )
        found[column] = values
    return found


def _quote_left_open(path: Path, rows: Rows) -> MeasurementError:
    """Return the error of a quote that a line does not close, so that it swallows the next ones."""
    with path.open(encoding="utf-8-sig", errors="replace", newline="") as file:
        odd = (n for n, line in enumerate(file, 1) if n in rows.numbers and line.count('"') % 2)
        where = f"{path}:{next(odd, rows.lines)}"
    return MeasurementError("quote that is not closed", where=where)


def _refuse_text(path: Path, dialect: Dialect, rows: Rows, columns: list[Column]) -> None:
    """Look for the first cell that is no number."""
    skipped = frozenset(rows.skipped)
    with path.open(encoding="utf-8-sig", errors="replace", newline="") as file:
        for number, line in enumerate(file, 1):
            if number in skipped:
                continue
            cells = next(csv.reader([line], delimiter=dialect.delimiter, skipinitialspace=True))
            for column in columns:
                cell = cells[column.place].strip() if column.place < len(cells) else ""
                if cell not in MISSING and not _is_number(cell, dialect.decimal):
                    raise MeasurementError(
                        f"column {column.title}",
                        where=f"{path}:{number}",
                        got=show(cell),
                        expected=f"a number with a decimal {_sign(dialect.decimal)}, or nothing",
                    )


def _is_number(cell: str, decimal: str) -> bool:
    if "_" in cell or (decimal == "," and "." in cell):
        return False
    try:
        float(cell.replace(decimal, "."))
    except ValueError:
        return False
    return True


def _sign(decimal: str) -> str:
    return "comma, as in the first rows" if decimal == "," else "point"
