"""CSV files of a folder → cells: with commas, semicolons or tabs, decimal points or commas."""

import csv
import re
from collections.abc import Iterable
from pathlib import Path

from arcless.errors import ModelError
from arcless.model.files.yaml_reader import read_text
from arcless.model.tables.grids import Cell, Grid

_SEPARATOR = re.compile(r"sep=(.)", re.IGNORECASE)
_COMMA = re.compile(r"[+\-\u2212]?\d+,\d+(?:\s*[A-Za-zµ]+)?")  # also before a unit, to say so
_POINT = re.compile(r"[+\-\u2212]?\d*\.\d+")


def read_csv(path: Path, where: str) -> Grid:
    """Return the cells of a CSV file, as texts; lines that begin with # are left out.

    Columns are parted by what the header has, of semicolon, tab and comma; a first line ``sep=;``,
    as spreadsheet programs write it, says so too. With semicolons or tabs, numbers may have a
    decimal comma.

    Raises
    ------
    ModelError
        No text in UTF-8, too large, no CSV, or numbers with decimal commas and with points.
    """
    return parse_csv(read_text(path, where, "a table as CSV text"), where)


def parse_csv(text: str, where: str) -> Grid:
    """Return the cells of a CSV text; see `read_csv`."""
    lines = text.splitlines()
    skipped = 0
    while skipped < len(lines) and _is_empty(lines[skipped]):
        skipped += 1
    named = _SEPARATOR.fullmatch(lines[skipped].strip()) if skipped < len(lines) else None
    skipped += named is not None
    header = lines[skipped] if skipped < len(lines) else ""
    separator = named[1] if named else next((one for one in ";\t" if one in header), ",")
    rows: list[tuple[int, list[Cell]]] = []
    reader = csv.reader(lines[skipped:], delimiter=separator, skipinitialspace=True, strict=True)
    try:
        for cells in reader:
            filled: list[Cell] = [cell.strip() or None for cell in cells]
            is_remark = bool(rows) and bool(cells) and cells[0].lstrip().startswith("#")
            if any(cell is not None for cell in filled) and not is_remark:
                rows.append((skipped + reader.line_num, filled))
    except csv.Error as error:
        place = f"{where}, row {skipped + reader.line_num}"
        raise ModelError(f"not a CSV file ({error})", where=place, expected="a table as CSV text",
                         hint="is a quotation mark open?") from None  # fmt: skip
    has_comma = separator != "," and _has_comma(rows, where)
    return Grid(where, rows, has_decimal_comma=has_comma)


def _is_empty(line: str) -> bool:
    return not line.strip() or line.lstrip().startswith("#")


def _has_comma(rows: Iterable[tuple[int, list[Cell]]], where: str) -> bool:
    """Return whether numbers have a decimal comma; a file with both kinds says nothing for sure."""
    first: dict[str, tuple[int, str]] = {}
    for row, cells in rows:
        for cell in cells:
            for sign, form in ((",", _COMMA), (".", _POINT)):
                if isinstance(cell, str) and sign not in first and form.fullmatch(cell):
                    first[sign] = (row, cell)
    if len(first) > 1:
        (row, cell), (other_row, other) = first[","], first["."]
        raise ModelError(
            "decimal commas and decimal points", where=where,
            got=f"{cell} in row {row} and {other} in row {other_row}",
            expected="one of them in all of a file",
        )  # fmt: skip
    return "," in first
