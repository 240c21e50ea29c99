"""The table of a study: a Parquet file with a row for each variant, whole or absent."""

from collections.abc import Mapping
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

from arcless.errors import StudyError
from arcless.results.files import write_bytes
from arcless.study.model import Study
from arcless.study.quantities import is_number, unit_of_key
from arcless.study.rows import Row
from arcless.study.variables import Axis

if TYPE_CHECKING:
    import pyarrow

NAME = "table.parquet"


def check_available() -> None:
    """Refuse a study, before any computing, where its table could not be written.

    Raises
    ------
    StudyError
        pyarrow is not installed.
    """
    needs("pyarrow", "the table of a study")


def needs(package: str, words: str) -> None:
    """Refuse what needs a package that is not installed."""
    from importlib.util import find_spec

    if find_spec(package) is None:
        raise StudyError(
            f"{words} needs the package {package}, which is not installed",
            hint="pip install 'arcless[study]'",
        )


def write(path: Path, study: Study, rows: Mapping[int, Row]) -> None:
    """Write the table, in the order of the variants.

    Parameters
    ----------
    path
        The file; one that exists is replaced in one stroke.
    study
        Whose columns it has.
    rows
        By variant.

    Raises
    ------
    OutputError
        The file cannot be written.
    """
    import pyarrow.parquet

    buffer = BytesIO()
    pyarrow.parquet.write_table(table(study, rows), buffer, compression="zstd")
    write_bytes(path, buffer.getbuffer())


def table(study: Study, rows: Mapping[int, Row]) -> "pyarrow.Table":
    """Return rows as an Arrow table; every column has its unit in its metadata."""
    import pyarrow

    ordered = [rows[number] for number in sorted(rows)]
    fields, columns = [], []

    def add(name: str, kind: Any, values: list[Any], unit: str, words: str) -> None:
        about = {"unit": unit, "description": words}
        fields.append(pyarrow.field(name, kind, metadata=about))
        columns.append(pyarrow.array(values, kind))

    add("variant", pyarrow.int64(), [row.variant for row in ordered], "", "Number, from 1.")
    for axis in study.axes:
        kind = _kind(axis)
        values = [_cell(row.values[axis.name], kind) for row in ordered]
        words = study.variables[axis.name].description or axis.field
        add(axis.name, getattr(pyarrow, kind)(), values, axis.unit, words)
    for name, output in study.outputs.items():
        is_key = study.expressions[name].names == {output.expression.strip()}
        unit = output.unit or (unit_of_key(output.expression.strip()) if is_key else "")
        words = output.description or output.expression
        add(name, pyarrow.float64(), [row.outputs.get(name) for row in ordered], unit, words)
    text = pyarrow.string()
    add("status", text, [row.status for row in ordered], "", "done, invalid or failed")
    add("error", text, [row.error for row in ordered], "", "Why there is no value.")
    times = [row.wall_time_s for row in ordered]
    add("wall_time_s", pyarrow.float64(), times, "s", "Wall time of the variant.")
    versions = [row.arcless_version for row in ordered]
    add("arcless_version", text, versions, "", "Version that computed it, digest of its files.")
    about = {"study": study.name, "description": study.description}
    return pyarrow.Table.from_arrays(columns, schema=pyarrow.schema(fields, metadata=about))


def _kind(axis: Axis) -> str:
    levels = axis.levels
    if levels is None:
        return "float64"
    if all(isinstance(value, bool) for value in levels):
        return "bool_"
    if all(isinstance(value, int) and not isinstance(value, bool) for value in levels):
        return "int64"
    return "float64" if all(is_number(value) for value in levels) else "string"


def _cell(value: Any, kind: str) -> Any:
    if kind != "string" or value is None or isinstance(value, str):
        return value
    import json

    return json.dumps(value, ensure_ascii=False)
