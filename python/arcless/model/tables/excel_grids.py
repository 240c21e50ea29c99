"""Sheets of an Excel workbook → cells. Of a formula, the value that was stored with it counts."""

import datetime
import warnings
import zipfile
import zlib
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from arcless.errors import ModelError
from arcless.model.tables.grids import Cell, Grid, Odd, letters

# Larger workbooks are refused: 5000 spans with 12 droppers each take 2 MB, unpacked 20 MB.
MOST_BYTES = 20_000_000
MOST_UNPACKED = 300_000_000
# Cells of a sheet, empty ones among them: what reaches further is a stray format.
MOST_CELLS = 3_000_000
Chooser = Callable[[Sequence[str]], tuple[dict[str, str], list[str]]]
_EXPECTED = "an Excel workbook (.xlsx)"
_AS_DATE = (
    "the spreadsheet program took the number for a date: give the column the format of a number,"
    " and write it again"
)
_FORMULA = "a formula without a stored value"


def read_workbook(path: Path, where: str, choose: Chooser) -> tuple[dict[str, Grid], list[str]]:
    """Return the cells of some sheets of a workbook by name, and the titles of the others.

    Parameters
    ----------
    path, where
        The file, and its name in messages.
    choose
        Takes the titles of the sheets; returns names by title of those that are wanted, and the
        other titles.

    Raises
    ------
    ModelError
        No workbook, too large, or damaged; a sheet that is wanted is hidden, or reaches too far.
    """
    _check(path, where)
    book = _load(path, where, values=True)
    formulas = _load(path, where, values=False) if _has_formulas(path) else None
    wanted, others = choose([sheet.title for sheet in book.worksheets])
    grids = {
        name: _grid(
            book[title], None if formulas is None else formulas[title], f"{where}, sheet {title}"
        )
        for title, name in wanted.items()
    }
    return grids, others


def _check(path: Path, where: str) -> None:
    """Refuse a file that is no workbook, or too large a one, before it is unpacked."""
    if not path.is_file():
        raise ModelError("no such file", where=where, expected=_EXPECTED)
    size = path.stat().st_size
    if size > MOST_BYTES:
        raise ModelError("file too large", where=where, got=f"{size / 1e6:.1f} MB",
                         expected=f"at most {MOST_BYTES / 1e6:g} MB")  # fmt: skip
    try:
        with zipfile.ZipFile(path) as packed:
            unpacked = sum(entry.file_size for entry in packed.infolist())
    except (zipfile.BadZipFile, OSError, ValueError) as error:
        raise ModelError(
            "not a workbook", where=where, got="a file of another kind", expected=_EXPECTED,
            hint="save it as .xlsx, without a password",
        ) from error  # fmt: skip
    if unpacked > MOST_UNPACKED:
        raise ModelError("file too large", where=where, got=f"{unpacked / 1e6:.0f} MB unpacked",
                         expected=f"at most {MOST_UNPACKED / 1e6:g} MB")  # fmt: skip


def _load(path: Path, where: str, *, values: bool) -> Any:
    from openpyxl import load_workbook

    try:
        with warnings.catch_warnings():  # of drop-down lists and pictures, which are not looked at
            warnings.simplefilter("ignore")
            return load_workbook(path, data_only=values, keep_links=False)
    except Exception as error:  # of many kinds: whatever a damaged file makes the package raise
        raise ModelError(
            "workbook cannot be read", where=where, got=str(error) or type(error).__name__,
            expected=_EXPECTED, hint="open it in the spreadsheet program and save it again",
        ) from error  # fmt: skip


def _has_formulas(path: Path) -> bool:
    """Return whether some sheet has a formula: then their places are looked up, which takes long.

    A sheet that cannot be unpacked is taken for one that has.
    """
    try:
        with zipfile.ZipFile(path) as packed:
            sheets = [name for name in packed.namelist() if name.startswith("xl/worksheets/")]
            return any(b"<f>" in data or b"<f " in data for data in map(packed.read, sheets))
    except (zipfile.BadZipFile, zlib.error, RuntimeError, OSError):
        return True


def _grid(sheet: Any, formulas: Any, where: str) -> Grid:
    if sheet.sheet_state != "visible":
        raise ModelError("hidden sheet", where=where, got="a hidden sheet",
                         expected="a sheet that is shown",
                         hint="show it, or give it a name that begins with #")  # fmt: skip
    if sheet.max_row * sheet.max_column > MOST_CELLS:
        raise ModelError(
            "too many cells", where=where,
            got=f"a sheet to row {sheet.max_row}, column {letters(sheet.max_column - 1)}",
            expected=f"at most {MOST_CELLS} cells",
            hint="delete the empty rows and columns behind the table: they contain formats",
        )  # fmt: skip
    merged = _merged(sheet)
    rows: list[tuple[int, list[Cell]]] = []
    for number, row in enumerate(sheet.iter_rows(), start=1):
        cells = [merged.get((number, cell.column)) or _cell(cell, formulas) for cell in row]
        is_remark = bool(rows) and isinstance(cells[0], str) and cells[0].startswith("#")
        if any(cell is not None for cell in cells) and not is_remark:
            while cells[-1] is None:
                cells.pop()
            rows.append((number, cells))
    return Grid(where, rows, has_letters=True)


def _merged(sheet: Any) -> dict[tuple[int, int], Odd]:
    """Return the cells that merging has emptied: all but the first of each range."""
    found: dict[tuple[int, int], Odd] = {}
    for area in sheet.merged_cells.ranges:
        odd = Odd(f"a part of the merged cells {area.coord}", "unmerge them, and fill each cell")
        found |= {place: odd for place in area.cells if place != (area.min_row, area.min_col)}
    return found


def _cell(cell: Any, formulas: Any) -> Cell:
    value = cell.value
    if value is None and formulas is not None:
        if formulas.cell(cell.row, cell.column).data_type == "f":
            return Odd(_FORMULA, "open the workbook in the spreadsheet program and save it")
    elif cell.data_type == "e":
        return Odd(f"the error {value}", "mend the formula")
    elif isinstance(value, bool):
        return Odd(str(value).upper(), "write a number or a text")
    elif isinstance(value, datetime.date | datetime.time | datetime.timedelta):
        kind = "date" if isinstance(value, datetime.date) else "time"
        return Odd(f"the {kind} {value}", _AS_DATE)
    elif isinstance(value, str):
        return value.strip() or None
    return value if value is None or isinstance(value, int | float) else str(value)
