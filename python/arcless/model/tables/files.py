"""Tables of a line in files: one Excel workbook, or a folder of CSV files."""

import os
from collections.abc import Iterable, Mapping, Sequence
from importlib.util import find_spec
from pathlib import Path

from arcless.errors import ModelError, OutputError
from arcless.model.tables.csv_grids import read_csv
from arcless.model.tables.grids import Table, typed
from arcless.model.tables.sheets import SHEETS
from arcless.model.tables.titles import sheet_of, sorted_out
from arcless.storage.csv_files import Column, write_csv_files
from arcless.storage.excel_files import write_excel
from arcless.storage.whole_files import check_writable
from arcless.units import show

EXCEL = ".xlsx"
CSV = ".csv"
_PLACES = "a workbook that ends in .xlsx, or a folder for CSV files"


def write_tables(
    path: str | Path, tables: Mapping[str, Sequence[Column]], *, overwrite: bool = False
) -> tuple[list[Path], list[Path]]:
    """Write tables by name of sheet; return the files, and those that were removed.

    Parameters
    ----------
    path
        A workbook that ends in .xlsx, or a folder, which is made if it does not exist.
    tables
        Columns by name of sheet.
    overwrite
        Whether tables that are there are replaced: a workbook with all its sheets; of a folder the
        files that are read as tables of a line, those that the line does not have among them,
        which are removed.

    Raises
    ------
    OutputError
        Tables are there already, another ending, a missing package, or the place cannot be
        written; files that are there stay.
    """
    target = Path(path)
    if is_excel(target):
        check_excel(target)
        if not overwrite and os.path.lexists(target):
            raise OutputError(
                "the workbook exists", where=str(target), expected="a new name",
                hint="`--overwrite` replaces it, with all its sheets",
            )  # fmt: skip
        check_writable(target)
        write_excel(target, tables)
        return [target], []
    if target.suffix[1:2].isalpha() and not target.is_dir():  # `line-7.5` is a folder
        hint = "a line takes several CSV files" if target.suffix.lower() == CSV else None
        raise OutputError("unknown kind of file", where=str(target), got=show(target.suffix),
                          expected=_PLACES, hint=hint)  # fmt: skip
    return _write_folder(target, tables, overwrite=overwrite)


def _write_folder(
    folder: Path, tables: Mapping[str, Sequence[Column]], *, overwrite: bool
) -> tuple[list[Path], list[Path]]:
    files = {folder / f"{name}{CSV}": columns for name, columns in tables.items()}
    try:
        folder.mkdir(exist_ok=True)
        there = sorted(file for file in folder.iterdir() if _is_table(file))
    except OSError as error:
        raise OutputError.of(error, "the folder cannot be made", folder) from error
    if there and not overwrite:
        raise OutputError(
            "tables of a line are in this folder", where=str(folder),
            got=", ".join(file.name for file in there), expected="a folder without them",
            hint="`--overwrite` replaces them",
        )  # fmt: skip
    for file in files:
        check_writable(file)
    write_csv_files(files)
    return list(files), _removed(there, files)


def _is_table(file: Path) -> bool:
    """Return whether a file is one that `read_tables` takes for a table of a line."""
    return file.suffix.lower() == CSV and sheet_of(file.stem) is not None


def _removed(there: Iterable[Path], written: Iterable[Path]) -> list[Path]:
    """Remove the files that are none of those written, by whatever name, and return them."""
    removed = []
    try:
        # Some file systems have one file for `Spans.csv` and `spans.csv`.
        for file in there:
            if not any(own.samefile(file) for own in written):
                file.unlink()
                removed.append(file)
    except OSError as error:
        raise OutputError.of(error, "a table of another line cannot be removed", file) from error
    return removed


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
        source, where, lambda titles: sorted_out(titles, str, f"{where}, sheet {{}}")
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
    wanted, others = sorted_out(files, lambda file: Path(file).stem, str(folder / "{}"))
    tables = {}
    for file, name in wanted.items():
        tables[name] = typed(read_csv(folder / file, str(folder / file)), SHEETS[name])
    if not tables:
        raise ModelError("no tables", where=str(folder), got="none of the files of a line",
                         expected=", ".join(f"{name}{CSV}" for name in SHEETS))  # fmt: skip
    return tables, others
