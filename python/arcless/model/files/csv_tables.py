"""CSV files with a header that names columns and units: ``time [s], displacement [mm]``.

The unit of a column stands behind its name, in brackets or without: ``length_error mm``.
"""

import csv
import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path as FilePath
from typing import Any

from arcless.errors import ModelError
from arcless.model.fields.part import nearest
from arcless.model.files.yaml_reader import Origin, read_text
from arcless.units import accepted, show, spell, to_si

_HEAD = re.compile(
    r"([A-Za-z_]\w*)\s*(?:\[\s*([^\[\]]*?)\s*\]|\(\s*([^()]*?)\s*\)|(?<=\s)([^\s\[(].*))?"
)
_WHOLE = re.compile(r"[1-9]\d{0,8}")
POINT = "write the decimal point as a point, and one comma between values"
EXPECTED = "a table as CSV text"
GAP = "fill every cell, or leave the row out"
# Units that examples in messages are written in.
_USUAL = {"m": "mm", "1": "%"}


@dataclass(frozen=True)
class Table:
    """Columns that a CSV file must or may have.

    Attributes
    ----------
    columns : name and SI unit of each column; None: whole numbers from 1
    either : of these columns there is exactly one
    optional : columns that may be missing
    """

    columns: Mapping[str, str | None]
    either: tuple[str, ...] = ()
    optional: tuple[str, ...] = ()

    @property
    def expected(self) -> str:
        """The columns in words."""
        plain = [self._spelt(name) for name in self.columns if name not in self.either]
        either = " or ".join(self._spelt(name) for name in self.either)
        return f'the columns "{", ".join(filter(None, [either, *plain]))}"'

    def _spelt(self, name: str) -> str:
        unit = self.columns[name]
        text = name if unit is None else f"{name} {spell(_USUAL.get(unit, unit))}"
        return f"({text})" if name in self.optional else text

    def missing(self, names: Mapping[str, Any]) -> list[str]:
        """Return the columns that must be there and are not."""
        free = {*self.either, *self.optional}
        missing = [name for name in self.columns if name not in names and name not in free]
        if self.either and not any(name in names for name in self.either):
            missing.insert(0, " or ".join(self.either))
        return missing


DROPPER_ERRORS = Table(
    {"tension_length": None, "span": None, "dropper": None, "wire": None, "length_error": "m"},
    optional=("tension_length", "wire"),
)
SUPPORT_ERRORS = Table(
    {"tension_length": None, "support": None, "height_error": "m"}, optional=("tension_length",)
)
GUSTS = Table(
    {"time": "s", "position": "m", "speed": "m/s", "vertical": "m/s"},
    optional=("position", "vertical"),
)
# Fields of the section as_built that may name a file: each row is an entry, or each column a list.
LISTS = {
    "dropper_length_errors": DROPPER_ERRORS,
    "support_height_errors": SUPPORT_ERRORS,
    "measured_heights": Table({"position": "m", "height": "m"}),
}
COLUMNS = {"gusts": GUSTS}


def with_tables(data: object, origin: Origin) -> object:
    """Return the plain data of the section `as_built` with its CSV files read.

    Parameters
    ----------
    data
        What stands under `as_built`.
    origin
        The file it stands in; names of CSV files are relative to it.
    """
    if not isinstance(data, Mapping):
        return data
    found = dict(data)
    for field in (*LISTS, *COLUMNS):
        given = data.get(field)
        if isinstance(given, Mapping) and isinstance(given.get("value"), str):
            found[field] = {**given, "value": _referred(given["value"], field, origin)}
        elif isinstance(given, str):
            found[field] = _referred(given, field, origin)
    return found


def _referred(name: str, field: str, origin: Origin) -> object:
    with origin.referring(("as_built", field)):
        if field in COLUMNS:
            return read_table(origin.file(name), COLUMNS[field])
        columns = read_table(origin.file(name), LISTS[field])
    rows = zip(*columns.values(), strict=True)
    return [dict(zip(columns, values, strict=True)) for values in rows]


def read_table(path: FilePath, table: Table) -> dict[str, list[int | float]]:
    """Return the columns of a CSV file: SI numbers, and whole numbers where there is no unit.

    Parameters
    ----------
    path
        The file. Lines that begin with # and empty lines are skipped.
    table
        Its columns.

    Raises
    ------
    ModelError
        A column or its unit is missing or unknown, a cell is empty or no number, or a row is too
        short or too long. The message names the line.
    """
    return parse_table(read_text(path, str(path), EXPECTED), str(path), table)


def parse_table(text: str, label: str, table: Table) -> dict[str, list[int | float]]:
    """Return the columns of a CSV text; `label` is the file that messages name."""
    rows = csv.reader(text.splitlines(), skipinitialspace=True)
    units: dict[str, str] | None = None
    found: dict[str, list[int | float]] = {}
    try:
        for cells in rows:
            if not any(cell.strip() for cell in cells) or cells[0].lstrip().startswith("#"):
                continue
            where = f"{label}:{rows.line_num}"
            if units is None:
                units = _header(cells, table, where)
                found = {name: [] for name in units}
            else:
                _add_row(cells, units, table, where, found)
    except csv.Error as error:
        raise ModelError(f"not a CSV file: {error}", where=f"{label}:{rows.line_num}") from None
    if not any(found.values()):
        got = "no header" if units is None else "a header without rows"
        raise ModelError("empty table", where=label, got=got, expected=table.expected)
    return found


def _header(cells: list[str], table: Table, where: str) -> dict[str, str]:
    """Return the unit written for each column, in the order of the file."""
    if len(cells) == 1 and re.search(r"[;\t]", cells[0]):
        hint = "separate the columns by commas"
        raise ModelError("header", where=where, got=show(cells[0]), expected="commas", hint=hint)
    units: dict[str, str] = {}
    for cell in cells:
        match = _HEAD.fullmatch(cell.strip())
        name = match[1] if match else cell.strip()
        if name not in table.columns:
            raise ModelError(
                "unknown column",
                where=where,
                got=show(cell.strip()),
                expected=table.expected,
                hint=nearest(name, list(table.columns)),
            )
        if name in units:
            raise ModelError("column given twice", where=where, got=show(name))
        unit = (match[2] or match[3] or match[4] or "") if match else ""
        _check_unit(name, unit, table.columns[name], where)
        units[name] = unit
    missing = table.missing(units)
    if missing:
        got = f"no {' and no '.join(missing)}"
        raise ModelError("missing column", where=where, got=got, expected=table.expected)
    if len(both := [name for name in table.either if name in units]) > 1:
        got, expected = " and ".join(both), " or ".join(table.either)
        raise ModelError("one column too many", where=where, got=got, expected=expected)
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
            hint=f"write it behind the name, such as {name} {spell(_USUAL.get(kind, kind))}",
        )
    try:
        to_si(f"1 {unit}", kind)
    except ModelError as error:
        error.what, error.where, error.got = f"column {name}", where, show(unit)
        raise


def _add_row(
    cells: list[str],
    units: dict[str, str],
    table: Table,
    where: str,
    found: dict[str, list[int | float]],
) -> None:
    if len(cells) != len(units):
        raise ModelError(
            "wrong number of cells",
            where=where,
            got=str(len(cells)),
            expected=f"{len(units)}, one for each column",
            hint=POINT if len(cells) > len(units) else GAP,
        )
    for (name, unit), cell in zip(units.items(), cells, strict=True):
        found[name].append(_cell(name, cell.strip(), unit, table.columns[name], where))


def _cell(name: str, cell: str, unit: str, kind: str | None, where: str) -> int | float:
    if not cell:
        raise ModelError(f"{name}: empty cell", where=where, expected="a number", hint=GAP)
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
