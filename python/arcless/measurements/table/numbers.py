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
    found = {}
    for column in columns:
        values = frame[column.place].to_numpy(np.float64, copy=True) * column.factor
        found[column] = np.where(np.isfinite(values), values, np.nan)
    return found


def _refuse_text(path: Path, dialect: Dialect, rows: Rows, columns: list[Column]) -> None:
    """Look for the first cell that is no number."""
    skipped = frozenset(rows.skipped)
    with path.open(encoding="utf-8-sig", errors="replace", newline="") as file:
        for number, line in enumerate(file, 1):
            if number in skipped:
                continue
            cells = next(csv.reader([line], delimiter=dialect.delimiter, skipinitialspace=True))
            for column in columns:
                cell = cells[column.place].strip()
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
