"""The table of a study → a CSV file or an Excel workbook, by the ending of its name."""

from collections.abc import Iterable
from pathlib import Path

from arcless.errors import OutputError
from arcless.results.export.files import check_target
from arcless.results.kept_runs.places import TABLE
from arcless.storage.csv_files import write_csv
from arcless.storage.excel_files import MOST_ROWS, write_excel
from arcless.study.definition.study import Study
from arcless.study.folder.table import columns
from arcless.study.journal.row import Row
from arcless.units import show

ENDINGS = (".csv", ".xlsx")


def export(study: Study, rows: Iterable[Row], path: Path) -> None:
    """Write the table of a study; see `StudyFolder.export`."""
    if path.suffix.lower() not in ENDINGS:
        raise OutputError(
            "unknown kind of file for a study",
            where=str(path),
            got=show(path.suffix) if path.suffix else "a name without an ending",
            expected=f"a name that ends in {', '.join(ENDINGS)}",
            hint=f"{TABLE} in the folder of the study is the table as Parquet",
        )
    check_target(path)
    found = columns(study, rows)
    if path.suffix.lower() == ".csv":
        write_csv(path, found)
        return
    count = 1 + len(found[0].values)
    if count > MOST_ROWS:
        raise OutputError(
            "too many variants for a sheet",
            where=str(path),
            got=f"{count} rows",
            expected=f"{MOST_ROWS} rows at most",
            hint="write .csv",
        )
    write_excel(path, {"variants": found})
