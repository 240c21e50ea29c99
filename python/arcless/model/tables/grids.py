"""Cells of a sheet as they were read → columns of numbers in SI, with the place of every cell."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from arcless.errors import ModelError
from arcless.model.fields.part import nearest
from arcless.model.tables.sheets import ColumnOf, Sheet
from arcless.units import (
    NUMBER_AND_UNIT,
    ONE_NUMBER,
    accepted,
    show,
    spell,
    to_si,
    written_in,
)

# So many mistakes of one sheet are told at once.
MOST_TOLD = 10
# Largest usual values of columns in m, least and most: by them the unit of numbers is guessed.
_USUAL = {
    "position": (0.5, 500.0), "length": (0.05, 500.0), "contact_wire_height": (3.0, 20.0),
    "stagger": (0.02, 1.0), "presag": (0.001, 0.5), "cant": (0.01, 0.3), "radius": (100.0, 1e5),
}  # fmt: skip
_OTHERS = (0.5, 1e5)
# Units of length that tables have, most usual first.
_LENGTHS = ("m", "mm", "cm")
# Columns that drawings have in mm where their numbers do not say it.
_FINE = ("stagger", "presag", "cant")
_UNIT = re.compile(r"(.*?)\s*(?:\[([^\[\]]*)\]|\(([^()]*)\))")
# Letters of a word by which a column is found.
_LEAST_WORD = 3
_WHOLE = re.compile(r"[1-9]\d{0,8}")
_SKIPPED = "#"
# The sign that typesetting and some spreadsheets have for a hyphen.
_MINUS = "\u2212"


@dataclass(frozen=True)
class Odd:
    """A cell that holds no value: what it holds in words, and what to do about it."""

    text: str
    hint: str


Cell = str | int | float | Odd | None


@dataclass(frozen=True)
class Grid:
    """Cells of a sheet.

    Attributes
    ----------
    where
        File, and sheet where it has several.
    rows
        Number of each row in its file, from 1, and its cells; empty rows are left out.
    has_letters
        Whether columns are called by letters, as in a workbook.
    has_decimal_comma
        Whether numbers are written with a comma.
    """

    where: str
    rows: Sequence[tuple[int, Sequence[Cell]]]
    has_letters: bool = False
    has_decimal_comma: bool = False

    def at(self, row: int, column: int | None = None, name: str = "") -> str:
        """Return the place of a cell or, without a column, of a row; columns count from 0."""
        place = f"{self.where}, row {row}"
        if column is None:
            return place
        letter = letters(column) if self.has_letters else ""
        called = f"{letter} ({name})" if letter and name else letter or name or str(column + 1)
        return f"{place}, column {called}"


@dataclass(frozen=True)
class Table:
    """Columns of a sheet.

    Attributes
    ----------
    columns
        Values of each column by name, in SI; None where a cell is empty. Without it, none was
        there.
    """

    sheet: Sheet
    grid: Grid
    columns: dict[str, list[Any]]
    _places: dict[str, int]

    def __len__(self) -> int:
        """Return the number of rows."""
        return len(self.grid.rows) - 1

    def column(self, name: str) -> list[Any]:
        """Return the values of a column; None for each row where there is no such column."""
        return self.columns.get(name) or [None] * len(self)

    def at(self, index: int, name: str) -> str:
        """Return where the value of a row stands, rows from 0; its row if it stands nowhere."""
        return self.grid.at(self.grid.rows[index + 1][0], self._places.get(name), name)

    def check_numbers(self, name: str, first: int = 1) -> None:
        """Raise `ModelError` unless a column of whole numbers counts from a first one."""
        seen: dict[int, int] = {}
        for index, number in enumerate(self.columns[name]):
            if number != first + index:
                row = seen.get(number)
                again = "" if row is None else f", which row {row} has already"
                raise ModelError(
                    f"{name}s out of order",
                    where=self.at(index, name),
                    got=f"{number}{again}",
                    expected=f"{first + index}: {name}s count from {first}, none left out",
                )
            seen[number] = self.grid.rows[index + 1][0]


def letters(column: int) -> str:
    """Return the letters of a column of a workbook, counted from 0."""
    text = ""
    column += 1
    while column:
        column, rest = divmod(column - 1, 26)
        text = chr(ord("A") + rest) + text
    return text


def typed(grid: Grid, sheet: Sheet) -> Table:
    """Return the columns of a sheet, checked cell by cell; bounds and rules are the model's.

    Raises
    ------
    ModelError
        The header is missing or has an unknown or missing column or unit; a cell is empty or no
        number. The message names sheet, row and column; up to ten of them are told at once.
    """
    if not grid.rows:
        raise ModelError("empty sheet", where=grid.where, got="no header", expected=sheet.expected)
    units, places = _header(grid, sheet)
    columns: dict[str, list[Any]] = {name: [] for name in places}
    told: list[ModelError] = []
    for row, cells in grid.rows[1:]:
        for name, place in places.items():
            cell = cells[place] if place < len(cells) else None
            try:
                columns[name].append(_value(cell, sheet.by_name[name], units[name], grid))
            except ModelError as error:
                error.where = grid.at(row, place, name)
                told.append(error)
        told += _beyond(grid, row, cells)
        if len(told) >= MOST_TOLD:
            break
    if told:
        told[0].also = tuple(told[1:MOST_TOLD])
        raise told[0]
    return Table(sheet, grid, columns, places)


def _header(grid: Grid, sheet: Sheet) -> tuple[dict[str, str], dict[str, int]]:
    """Return unit and place of each column."""
    row, cells = grid.rows[0]
    units: dict[str, str] = {}
    places: dict[str, int] = {}
    for place, cell in enumerate(cells):
        if cell is None or (isinstance(cell, str) and cell.startswith(_SKIPPED)):
            continue
        where = grid.at(row, place)
        name, unit = _named(cell, sheet, where)
        if name in units:
            got = f"{show(name)} again, as in column {places[name] + 1}"
            raise ModelError("column given twice", where=where, got=got, expected="it once")
        column = sheet.by_name[name]
        units[name] = _checked_unit(column, unit, grid.at(row, place, name), grid, place)
        places[name] = place
    missing = [column.spelt for column in sheet.columns
               if column.is_needed and column.name not in units]  # fmt: skip
    if missing:
        got = f"no column {' and no column '.join(missing)}"
        raise ModelError("missing column", where=grid.at(row), got=got, expected=sheet.expected)
    return units, places


def _named(cell: Cell, sheet: Sheet, where: str) -> tuple[str, str]:
    """Return name and unit in a cell of the header: `length [m]`, `Length (m)`, `length m`."""
    if isinstance(cell, Odd):
        hint = "write the name into this cell as a text"
        raise ModelError("header without a name", where=where, got=cell.text,
                         expected=sheet.expected, hint=hint)  # fmt: skip
    text = str(cell)
    match = _UNIT.fullmatch(text)
    name, unit = (match[1], match[2] or match[3] or "") if match else (text, "")
    front, _, last = text.rpartition(" ")
    known = {_key(column): column for column in sheet.by_name}
    if match is None and _key(text) not in known and _key(front) in known:
        name, unit = front, last
    if _key(name) not in known:
        hint = _meant(name.strip(), sheet)
        raise ModelError(
            "unknown column", where=where, got=show(text), expected=sheet.expected,
            hint=f"{hint}; a column whose header begins with {_SKIPPED} is left out",
        )  # fmt: skip
    return known[_key(name)], unit.strip()


def _meant(name: str, sheet: Sheet) -> str:
    """Return the hint for an unknown column: those with its last words, or the nearest one."""
    for word in reversed(re.findall(r"\w+", name.replace("_", " ").lower())):
        found = [own for own in sheet.by_name if word in own]
        if len(word) >= _LEAST_WORD and found:
            listed = " or ".join([", ".join(found[:-1]), found[-1]] if found[1:] else found)
            return f"did you mean {listed}?"
    return nearest(name, list(sheet.by_name))


def _key(name: str) -> str:
    """Return a name without what is written in several ways: `Pre-sag` is `presag`."""
    return re.sub(r"[\s_-]+", "", name.lower())


def _checked_unit(column: ColumnOf, unit: str, where: str, grid: Grid, place: int) -> str:
    if not column.unit:
        if unit:
            expected = f"{column.name} without a unit"
            raise ModelError("unit", where=where, got=show(unit), expected=expected)
        return ""
    if not unit:
        usual = _guessed_unit(column, grid, place)
        raise ModelError("unit missing", where=where, got=show(column.name),
                         expected=f"{column.name} with its unit: {accepted(column.unit)}",
                         hint=f"write {column.name} [{usual}]")  # fmt: skip
    try:
        to_si(f"1 {unit}", column.unit)
    except ModelError as error:
        error.what, error.where, error.got = "unit", where, show(unit)
        raise
    return unit


def _guessed_unit(column: ColumnOf, grid: Grid, place: int) -> str:
    """Return the unit that the numbers of a column without one probably have."""
    if column.unit != "m":
        return spell(column.unit)
    kind = column.name.partition("_")[0] if column.name.startswith("stagger") else column.name
    least, most = _USUAL.get(kind, _OTHERS)
    numbers = [
        _plain_number(cells[place], grid) for _, cells in grid.rows[1:] if place < len(cells)
    ]
    largest = max((abs(number) for number in numbers if number is not None), default=0.0)
    fitting = (unit for unit in _LENGTHS if least <= to_si(f"{largest!r} {unit}", "m") <= most)
    return next(fitting, "mm" if kind in _FINE else "m")


def _plain_number(cell: Cell, grid: Grid) -> float | None:
    if isinstance(cell, Odd) or cell is None:
        return None
    text = _text(cell)
    try:
        return float(text.replace(",", ".") if grid.has_decimal_comma else text)
    except ValueError:
        return None


def _value(cell: Cell, column: ColumnOf, unit: str, grid: Grid) -> Any:
    """Return the value of a cell, in SI; the caller knows its place."""
    what = {"number": f"a number in {unit}", "whole": "a whole number from 1", "text": "a text"}
    expected = what[column.holds]
    if isinstance(cell, Odd):
        raise ModelError("no value", got=cell.text, expected=expected, hint=cell.hint)
    if cell is None:
        if column.is_needed:
            raise ModelError("empty cell", expected=expected)
        return None
    text = _text(cell)
    if column.holds == "text":
        return text
    if column.holds == "whole":
        if not _WHOLE.fullmatch(text):
            raise ModelError("no whole number", got=show(text), expected=expected)
        return int(text)
    if grid.has_decimal_comma and text.count(",") == 1 and "." not in text:
        text = text.replace(",", ".")
    try:
        return _number(text.replace(_MINUS, "-"), column.unit, unit, show(_text(cell)))
    except ModelError as error:
        if grid.has_decimal_comma:
            error.hint = _with_comma(error.hint, text)
        raise


def _with_comma(hint: str | None, text: str) -> str | None:
    """Return a hint about a number for a file whose numbers have a decimal comma."""
    if "," in text and "." in text:
        return "the numbers of this file have a decimal comma: write digits without separators"
    return None if hint is None else re.sub(r"(?<=\d)\.(?=\d)", ",", hint)


def _number(text: str, kind: str, unit: str, got: str) -> float:
    """Return a number in the unit of its column, in SI; one with a unit of its own is refused."""
    expected = f"a number in {unit}"
    try:
        value = to_si(text, kind)
        if written_in(text, kind) is None:
            return to_si(f"{text} {unit}", kind)
    except ModelError as error:
        is_finite = not (error.expected or "").endswith("finite")
        error.expected = expected if is_finite else f"{expected}, finite"
        error.what, error.got = "no number", got
        if error.hint in (NUMBER_AND_UNIT, ONE_NUMBER):  # hints for where units are written
            error.hint = "write a number such as 1.5; its unit is in the header"
        raise
    number = f"{value / to_si(f'1 {unit}', kind):.12g}"
    raise ModelError("a unit in a cell", got=got, expected=expected,
                     hint=f"the unit is in the header: write {number}")  # fmt: skip


def _text(cell: str | int | float) -> str:
    """Return a cell as text; a whole number of a workbook is one, whatever it is stored as."""
    if isinstance(cell, float) and cell.is_integer():
        return str(int(cell))
    return cell.strip() if isinstance(cell, str) else repr(cell)


def _beyond(grid: Grid, row: int, cells: Sequence[Cell]) -> list[ModelError]:
    """Return the mistake of a row with a cell under no header."""
    head = grid.rows[0][1]
    hint = None if grid.has_letters else "is a number written with a comma?"
    for place, cell in enumerate(cells):
        if cell is not None and (place >= len(head) or head[place] is None):
            got = cell.text if isinstance(cell, Odd) else show(cell)
            expected = "a name at the head of each column"
            where = grid.at(row, place)
            return [ModelError("a cell without a header", where=where, got=got,
                               expected=expected, hint=hint)]  # fmt: skip
    return []
