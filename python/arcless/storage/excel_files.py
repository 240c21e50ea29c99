"""Tables as the sheets of one Excel workbook: header in bold, numbers with every digit."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from arcless.storage.csv_files import Column, cells
from arcless.storage.whole_files import replacing

# Rows of a sheet, its header among them (ECMA-376, as Excel has it).
MOST_ROWS = 1_048_576
# Width of the narrowest column, in characters.
NARROWEST = 12


def write_excel(path: str | Path, sheets: Mapping[str, Sequence[Column]]) -> None:
    """Write tables as sheets of a workbook; a file that exists is replaced.

    Parameters
    ----------
    path
        The file.
    sheets
        Columns of one length by title of the sheet; at most `MOST_ROWS` rows with the header.

    Raises
    ------
    OutputError
        The file cannot be written.
    """
    from openpyxl import Workbook

    with replacing(path) as file:  # which tells of a full disk, too: rows go to a file at once
        book = Workbook(write_only=True)
        for title, columns in sheets.items():
            _fill(book.create_sheet(title), columns)
        book.save(file)


def _fill(sheet: Any, columns: Sequence[Column]) -> None:
    """Write a table with its header in bold, which stays when one scrolls."""
    from openpyxl.cell import WriteOnlyCell
    from openpyxl.cell.cell import ILLEGAL_CHARACTERS_RE
    from openpyxl.styles import Font
    from openpyxl.utils import get_column_letter

    def cell(value: Any, *, bold: bool = False) -> Any:
        if isinstance(value, float) and float(f"{value:.16g}") != value:
            made = WriteOnlyCell(sheet, repr(value))
            made.data_type = "n"  # the package writes 16 digits: this number has 17
            return made
        if not isinstance(value, str):
            return value
        made = WriteOnlyCell(sheet, ILLEGAL_CHARACTERS_RE.sub("?", value))
        made.data_type = "s"  # a name that begins with `=` is no formula
        if bold:
            made.font = Font(bold=True)
        return made

    sheet.freeze_panes = "A2"
    for place, column in enumerate(columns, 1):
        width = max(NARROWEST, len(column.header) + 2)
        sheet.column_dimensions[get_column_letter(place)].width = width
    sheet.append([cell(column.header, bold=True) for column in columns])
    for row in zip(*(cells(column.values) for column in columns), strict=True):
        sheet.append([cell(value) for value in row])
