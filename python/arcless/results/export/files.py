"""Tables of a result → a file, its kind by the ending of its name."""

import re
from collections.abc import Callable, Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from arcless.errors import OutputError
from arcless.results.export import tables
from arcless.results.export.tables import Run
from arcless.storage.csv_files import Column, write_csv
from arcless.storage.endings import check_ending
from arcless.storage.excel_files import MOST_ROWS, write_excel
from arcless.storage.whole_files import check_writable, replacing

# Characters of a variable's name in MATLAB.
LONGEST_NAME = 63


def export(result: Run, path: str | Path) -> None:
    """Write a result for other programs; see `Result.export`."""
    target = Path(path)
    check_target(target)
    _WRITERS[target.suffix.lower()](result, target)


def check_target(path: Path) -> None:
    """Refuse, before anything is read, a file that could not be written.

    Raises
    ------
    OutputError
        Its ending is unknown, a package is missing, or the place is none.
    """
    ending = check_ending(path, _WRITERS, "unknown kind of file")
    package, extra = _NEEDS.get(ending, ("", ""))
    if package and find_spec(package) is None:
        raise OutputError(
            f"a {ending} file needs the package {package}, which is not installed",
            where=str(path),
            hint=f"pip install 'arcless[{extra}]'",
        )
    check_writable(path)


def _csv(result: Run, path: Path) -> None:
    write_csv(path, tables.contact_channels(result))


def _xlsx(result: Run, path: Path) -> None:
    channels = tables.contact_channels(result)
    rows = 1 + len(channels[0].values)
    if rows > MOST_ROWS:
        raise OutputError(
            "too many samples for a sheet",
            where=str(path),
            got=f"{rows} rows",
            expected=f"{MOST_ROWS} rows at most",
            hint="write .csv, .mat or .parquet, or record less often: output.contact_every",
        )
    sheets = {
        "assessment": tables.assessment(result),
        "criteria": tables.criteria(result),
        "contact channels": channels,
        "droppers": tables.places(result, "dropper"),
        "supports": tables.places(result, "support"),
        "support channels": tables.support_channels(result),
    }
    write_excel(path, sheets)


def _mat(result: Run, path: Path) -> None:
    from scipy.io import savemat

    content = {
        "scenario": result.metadata["scenario_name"],
        "arcless_version": result.metadata["arcless_version"],
        "contact_channels": _struct(tables.contact_channels(result)),
        "droppers": _struct(tables.places(result, "dropper")),
        "supports": _struct(tables.places(result, "support")),
        "support_channels": _struct(tables.support_channels(result)),
    }
    with replacing(path) as file:
        savemat(file, content, long_field_names=True, do_compression=True, oned_as="column")


def _struct(columns: Sequence[Column]) -> dict[str, Any]:
    """Return columns by names that MATLAB takes, and their headers in `headers`, in order."""
    made: dict[str, Any] = {}
    for column in columns:
        name = re.sub(r"\W", "_", column.name, flags=re.ASCII)
        name = name if name[:1].isalpha() else f"x{name}"
        name = _free(name[:LONGEST_NAME], made)
        is_text = len(column.values) > 0 and isinstance(column.values[0], str)
        made[name] = np.array(column.values, dtype=object if is_text else float)
    made["headers"] = np.array([column.header for column in columns], dtype=object)
    return made


def _free(name: str, taken: dict[str, Any]) -> str:
    """Return the name, with a number at its end where another column has it already."""
    found, count = name, 1
    while found in taken or found == "headers":
        count += 1
        found = f"{name[: LONGEST_NAME - 1 - len(str(count))]}_{count}"
    return found


def _parquet(result: Run, path: Path) -> None:
    import pyarrow
    import pyarrow.parquet

    columns = tables.contact_channels(result)
    fields = [
        pyarrow.field(column.header, pyarrow.float64(), metadata={"units": column.unit})
        for column in columns
    ]
    facts = {
        "scenario": result.metadata["scenario_name"],
        "arcless_version": result.metadata["arcless_version"],
    }
    arrays = [pyarrow.array(c.values, pyarrow.float64(), from_pandas=True) for c in columns]
    table = pyarrow.Table.from_arrays(arrays, schema=pyarrow.schema(fields, metadata=facts))
    with replacing(path) as file:
        pyarrow.parquet.write_table(table, file)


_WRITERS: dict[str, Callable[[Run, Path], None]] = {
    ".csv": _csv,
    ".xlsx": _xlsx,
    ".mat": _mat,
    ".parquet": _parquet,
}
# Ending → package that it needs, and the extra that has it.
_NEEDS = {".xlsx": ("openpyxl", "excel"), ".parquet": ("pyarrow", "study")}
