"""Tables of a line in files: one Excel workbook, or a folder of CSV files."""

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from difflib import get_close_matches
from importlib.util import find_spec
from pathlib import Path

from arcless.errors import ModelError, OutputError
from arcless.model.tables.csv_grids import read_csv
from arcless.model.tables.grids import Table, typed
from arcless.model.tables.sheets import SHEETS
from arcless.storage.csv_files import Column, write_csv_files
from arcless.storage.excel_files import write_excel
from arcless.storage.whole_files import check_writable
from arcless.units import show

EXCEL = ".xlsx"
CSV = ".csv"
_PLACES = "a workbook that ends in .xlsx, or a folder for CSV files"
# A title as near to the name of a sheet as this is taken for a slip (`difflib`, from 0 to 1): of
# more, slips are passed over as notes of the office; of less, notes are refused.
SLIP = 0.75


def write_tables(path: str | Path, tables: Mapping[str, Sequence[Column]]) -> list[Path]:
    """Write tables by name of sheet, and return the files; those that exist are replaced.

    Parameters
    ----------
    path
        A workbook that ends in .xlsx, or a folder, which is made if it does not exist.

    Raises
    ------
    OutputError
        Another ending, a missing package, or the place cannot be written; files that are there
        stay.
    """
    target = Path(path)
    if is_excel(target):
        check_excel(target)
        check_writable(target)
        write_excel(target, tables)
        return [target]
    if target.suffix[1:2].isalpha() and not target.is_dir():  # `line-7.5` is a folder
        hint = "a line takes several CSV files" if target.suffix.lower() == CSV else None
        raise OutputError("unknown kind of file", where=str(target), got=show(target.suffix),
                          expected=_PLACES, hint=hint)  # fmt: skip
    files = {target / f"{name}{CSV}": columns for name, columns in tables.items()}
    try:
        target.mkdir(exist_ok=True)
    except OSError as error:
        raise OutputError.of(error, "the folder cannot be made", target) from error
    for file in files:
        check_writable(file)
    write_csv_files(files)
    return list(files)


def read_tables(path: str | Path) -> tuple[dict[str, Table], list[str]]:
    """Return the tables in a workbook or folder by name of sheet, and what else is in it.

    Raises
    ------
    ModelError
        There is none, or a sheet is wrong; the message names sheet or file, row and column.
    """
    source = Path(path)
    if not is_excel(source):
        return _read_folder(source)
    try:
        check_excel(source)
    except OutputError as error:
        raise ModelError(error.what, where=error.where, hint=error.hint) from None
    from arcless.model.tables.excel_grids import read_workbook

    where = str(source)
    grids, others = read_workbook(
        source, where, lambda titles: _sorted(titles, str, f"{where}, sheet {{}}")
    )
    return {name: typed(grid, SHEETS[name]) for name, grid in grids.items()}, others


def is_excel(path: Path) -> bool:
    """Return whether a path names a workbook, not a folder."""
    return path.suffix.lower() == EXCEL and not path.is_dir()


def check_excel(path: Path) -> None:
    """Raise `OutputError` where the package for workbooks is missing."""
    if find_spec("openpyxl") is None:
        raise OutputError(
            "an .xlsx file needs the package openpyxl, which is not installed",
            where=str(path), hint="pip install 'arcless[excel]'",
        )  # fmt: skip


def _read_folder(folder: Path) -> tuple[dict[str, Table], list[str]]:
    if not folder.is_dir():
        is_there = os.path.lexists(folder)
        got = "a file of another kind" if is_there else "nothing of this name"
        hint = None
        if folder.suffix.lower() == CSV:
            hint = "name the folder that the CSV files are in"
        elif folder.suffix[1:2].isalpha():
            hint = "save it as .xlsx"
        raise ModelError("no tables", where=str(folder), got=got, expected=_PLACES, hint=hint)
    files = sorted(file.name for file in folder.iterdir() if file.suffix.lower() == CSV)
    wanted, others = _sorted(files, lambda file: Path(file).stem, str(folder / "{}"))
    tables = {}
    for file, name in wanted.items():
        tables[name] = typed(read_csv(folder / file, str(folder / file)), SHEETS[name])
    if not tables:
        raise ModelError("no tables", where=str(folder), got="none of the files of a line",
                         expected=", ".join(f"{name}{CSV}" for name in SHEETS))  # fmt: skip
    return tables, others


def _sorted(
    titles: Iterable[str], stem: Callable[[str], str], where: str
) -> tuple[dict[str, str], list[str]]:
    """Return name of sheet by title, and titles that are no sheets of a line.

    Raises
    ------
    ModelError
        Two titles are one sheet, or a title is nearly that of a sheet that is not there.
    """
    named = {title: stem(title).strip().lower().replace(" ", "_") for title in titles}
    wanted: dict[str, str] = {}
    for title, name in named.items():
        if name not in SHEETS:
            continue
        if name in wanted.values():
            raise ModelError("sheet given twice", where=where.format(title), got=show(title),
                             expected=f"one sheet {name}")  # fmt: skip
        wanted[title] = name
    others = [title for title in named if title not in wanted]
    free = [name for name in SHEETS if name not in wanted.values()]
    for title in others:
        close = get_close_matches(named[title], free, n=1, cutoff=SLIP)
        if close and not named[title].startswith("#"):
            raise ModelError(
                "unknown sheet", where=where.format(title), got=show(title),
                expected=", ".join(SHEETS),
                hint=f"did you mean {close[0]}? a name that begins with # is left out",
            )  # fmt: skip
    return wanted, others
