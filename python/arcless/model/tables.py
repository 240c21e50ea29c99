"""CSV files with a header that names columns and units: ``span,dropper,length_error mm``."""

import csv
import re
from collections.abc import Mapping
from pathlib import Path as FilePath
from typing import Any

from arcless.errors import ModelError
from arcless.model.fields import nearest
from arcless.model.reader import Origin, read_text
from arcless.units import accepted, show, to_si

# Unit of each column: an SI unit, or None for whole numbers from 1.
DROPPER_ERRORS = {"span": None, "dropper": None, "length_error": "m"}
_HEAD = re.compile(r"\s*([A-Za-z_]\w*)\s*[\[(]?\s*([^\])]*?)\s*[\])]?\s*")
_WHOLE = re.compile(r"[1-9]\d{0,8}")
POINT = "write the decimal point as a point, and one comma between values"

Columns = Mapping[str, str | None]


def with_tables(data: object, origin: Origin) -> object:
    """Return the plain data of the section `as_built` with its CSV file read.

    Parameters
    ----------
    data
        What stands under `as_built`.
    origin
        The file it stands in; the CSV file's name is relative to it.
    """
    field = "dropper_length_errors"
    if not isinstance(data, Mapping) or field not in data:
        return data
    given = data[field]
    if isinstance(given, Mapping) and isinstance(given.get("value"), str):
        return {**data, field: {**given, "value": _referred(given["value"], field, origin)}}
    if isinstance(given, str):
        return {**data, field: _referred(given, field, origin)}
    return data


def _referred(name: str, field: str, origin: Origin) -> list[dict[str, Any]]:
    with origin.referring(("as_built", field)):
        return read_table(origin.folder / name, DROPPER_ERRORS)


def read_table(path: FilePath, columns: Columns) -> list[dict[str, Any]]:
    """Return the rows of a CSV file: SI numbers, and whole numbers where there is no unit.

    Parameters
    ----------
    path
        The file. Lines that begin with # and empty lines are skipped.
    columns
        Name and SI unit of every column; None: whole numbers from 1.

    Raises
    ------
    ModelError
        A column or its unit is missing or unknown, a cell is empty or no number, or a row is too
        short or too long. The message names the line.
    """
    label = str(path)
    rows = csv.reader(read_text(path, label).splitlines(), skipinitialspace=True)
    units: dict[str, str] | None = None
    found = []
    try:
        for cells in rows:
            if not any(cell.strip() for cell in cells) or cells[0].lstrip().startswith("#"):
                continue
            where = f"{label}:{rows.line_num}"
            if units is None:
                units = _header(cells, columns, where)
            else:
                found.append(_row(cells, units, columns, where))
    except csv.Error as error:
        raise ModelError(f"not a CSV file: {error}", where=f"{label}:{rows.line_num}") from None
    if not found:
        got = "no header" if units is None else "a header without rows"
        raise ModelError("empty table", where=label, got=got, expected=_described(columns))
    return found


def _described(columns: Columns) -> str:
    units = {"m": "mm"}
    names = [f"{name} {units.get(unit, unit)}" if unit else name for name, unit in columns.items()]
    return f'the columns "{",".join(names)}"'


def _header(cells: list[str], columns: Columns, where: str) -> dict[str, str]:
    """Return the unit written for each column, in the order of the file."""
    if len(cells) == 1 and re.search(r"[;\t]", cells[0]):
        hint = "separate the columns by commas"
        raise ModelError("header", where=where, got=show(cells[0]), expected="commas", hint=hint)
    units: dict[str, str] = {}
    for cell in cells:
        match = _HEAD.fullmatch(cell)
        name, unit = (match[1], match[2]) if match else (cell.strip(), "")
        if name not in columns:
            raise ModelError(
                "unknown column",
                where=where,
                got=show(cell),
                expected=_described(columns),
                hint=nearest(name, list(columns)),
            )
        if name in units:
            raise ModelError("column given twice", where=where, got=show(cell))
        _check_unit(name, unit, columns[name], where)
        units[name] = unit
    missing = [name for name in columns if name not in units]
    if missing:
        got = f"no {' and no '.join(missing)}"
        raise ModelError("missing column", where=where, got=got, expected=_described(columns))
    return units


def _check_unit(name: str, unit: str, kind: str | None, where: str) -> None:
    if kind is None:
        if unit:
            expected = "a whole number without unit"
            raise ModelError(f"column {name}", where=where, got=show(unit), expected=expected)
        return
    if not unit:
        raise ModelError(
            f"column {name}: unit missing",
            where=where,
            expected=accepted(kind),
            hint=f"write it behind the name, such as {name} mm",
        )
    try:
        to_si(f"1 {unit}", kind)
    except ModelError as error:
        error.what, error.where, error.got = f"column {name}", where, show(unit)
        raise


def _row(cells: list[str], units: dict[str, str], columns: Columns, where: str) -> dict[str, Any]:
    if len(cells) != len(units):
        raise ModelError(
            "wrong number of cells",
            where=where,
            got=str(len(cells)),
            expected=f"{len(units)}, one for each column",
            hint=POINT if len(cells) > len(units) else "fill every cell, or leave the row out",
        )
    return {
        name: _cell(name, cell.strip(), unit, columns[name], where)
        for (name, unit), cell in zip(units.items(), cells, strict=True)
    }


def _cell(name: str, cell: str, unit: str, kind: str | None, where: str) -> int | float:
    if not cell:
        hint = "fill every cell, or leave the row out"
        raise ModelError(f"{name}: empty cell", where=where, expected="a number", hint=hint)
    if kind is None:
        if not _WHOLE.fullmatch(cell):
            raise ModelError(name, where=where, got=show(cell), expected="a whole number from 1")
        return int(cell)
    try:
        to_si(cell, "1")  # the unit stands in the header: a cell with its own is refused
        return to_si(f"{cell} {unit}", kind)
    except ModelError as error:
        error.what, error.where, error.expected = name, where, f"a number in {unit}"
        raise
