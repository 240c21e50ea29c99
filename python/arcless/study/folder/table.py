"""The table of a study: a Parquet file with a row for each variant, whole or absent."""

import json
from collections.abc import Callable, Iterable
from io import BytesIO
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from arcless.errors import StudyError
from arcless.storage.csv_files import Column
from arcless.storage.whole_files import write_bytes
from arcless.study.definition.quantities import is_number, unit_of_key
from arcless.study.definition.study import Study
from arcless.study.journal.row import Row
from arcless.study.variables.variables import Axis

if TYPE_CHECKING:
    import pandas
    import pyarrow

# Rows that are in memory at once; a group of rows of the file. Some tens of MB.
PART = 20_000
# Units of numbers without a unit.
_PLAIN = ("", "1")


def check_available() -> None:
    """Refuse a study, before any computing, where its table could not be written.

    Raises
    ------
    StudyError
        pyarrow is not installed.
    """
    needs("pyarrow", "the table of a study")


def import_ahead() -> None:
    """Import the libraries that a table needs, so that stopping a study does not wait for them."""
    import pyarrow.parquet

    pyarrow.array([0.0])  # the first array imports pandas, where it is installed


def needs(package: str, words: str) -> None:
    """Refuse what needs a package that is not installed."""
    from importlib.util import find_spec

    if find_spec(package) is None:
        raise StudyError(
            f"{words} needs the package {package}, which is not installed",
            hint="pip install 'arcless[study]'",
        )


def write(path: Path, study: Study, rows: Iterable[Row]) -> None:
    """Write the table.

    Parameters
    ----------
    path
        The file; one that exists is replaced in one stroke.
    study
        Whose columns it has.
    rows
        In the order of the variants; some thousands at a time are in memory.

    Raises
    ------
    OutputError
        The file cannot be written.
    """
    import pyarrow.parquet

    left, buffer = iter(rows), BytesIO()
    part = table(study, islice(left, PART))
    with pyarrow.parquet.ParquetWriter(buffer, part.schema, compression="zstd") as writer:
        writer.write_table(part)
        while part.num_rows == PART:
            part = table(study, islice(left, PART))
            writer.write_table(part)
    write_bytes(path, buffer.getbuffer())


def table(study: Study, rows: Iterable[Row]) -> "pyarrow.Table":
    """Return rows as an Arrow table; every column has its unit and a description with it."""
    import pyarrow

    found = list(rows)
    columns = _columns(study)
    arrays = [pyarrow.array([column.of(row) for row in found], column.kind) for column in columns]
    fields = [
        pyarrow.field(c.name, c.kind, metadata={"unit": c.unit, "description": c.words})
        for c in columns
    ]
    about = {"study": study.name, "description": study.description}
    return pyarrow.Table.from_arrays(arrays, schema=pyarrow.schema(fields, metadata=about))


def data_frame(study: Study, rows: Iterable[Row]) -> "pandas.DataFrame":
    """Return rows as a data frame; columns are named with their units."""
    check_available()
    made = table(study, rows).to_pandas()
    units = {column.name: column.unit for column in _columns(study)}
    headers = {n: n if unit in _PLAIN else f"{n} [{unit}]" for n, unit in units.items()}
    made = made.rename(columns=headers).set_index("variant")
    made.attrs["units"] = {headers[name]: unit for name, unit in units.items()}
    return made


def columns(study: Study, rows: Iterable[Row]) -> list[Column]:
    """Return rows as columns of texts and numbers; what is neither is a text in JSON."""
    check_available()
    values = table(study, rows).to_pydict()
    return [
        Column(c.name, "" if c.unit in _PLAIN else c.unit, [_plain(one) for one in values[c.name]])
        for c in _columns(study)
    ]


def _plain(value: Any) -> Any:
    return value if value is None or isinstance(value, str | int | float) else json.dumps(value)


class _Column(NamedTuple):
    name: str
    kind: Any
    unit: str
    words: str
    of: Callable[[Row], Any]


def _columns(study: Study) -> list[_Column]:
    from pyarrow import float64, int64, string

    number = _Column("variant", int64(), "", "Number, from 1.", lambda row: row.variant)
    text = string()
    status, error, time, version = (
        _Column("status", text, "", "done, pruned, invalid or failed", lambda row: row.status),
        _Column("error", text, "", "Why there is no value.", lambda row: row.error),
        _Column("wall_time_s", float64(), "s", "Wall time.", lambda row: row.wall_time_s),
        _Column(
            "arcless_version", text, "", "Version that computed it, with a digest of its files.",
            lambda row: row.arcless_version,
        ),
    )  # fmt: skip
    varied = [_variable(study, axis) for axis in study.axes]
    outputs = [_output(study, name) for name in study.outputs]
    watched = _watched() if "so_far" in study.columns else []
    return [number, *varied, *outputs, status, error, *watched, time, version]


def _watched() -> list[_Column]:
    """Return the columns of a study whose runs are watched while they step."""
    from pyarrow import field, float64, int64, list_, map_, string

    so_far = map_(string(), field("values", list_(float64())))
    return [
        _Column("pruned_at_m", float64(), "m", "Where the run was stopped.",
                lambda row: row.stopped_at_m),
        _Column("pruned_after_s", float64(), "s", "Time in the run when it was stopped.",
                lambda row: row.stopped_after_s),
        _Column("steps_taken", int64(), "", "Steps of all its runs.", lambda row: row.steps),
        _Column("so_far", so_far, "", "Values over the part travelled, by output.",
                lambda row: list(row.so_far.items())),
    ]  # fmt: skip


def _variable(study: Study, axis: Axis) -> _Column:
    import pyarrow

    kind = _kind(axis)
    words = study.variables[axis.name].description or axis.field
    made = getattr(pyarrow, kind)()
    return _Column(
        axis.name, made, axis.unit, words, lambda row: _cell(row.values[axis.name], kind)
    )


def _output(study: Study, name: str) -> _Column:
    import pyarrow

    output = study.outputs[name]
    words = output.description or output.expression.strip()
    unit = unit_of_output(study, name)
    return _Column(name, pyarrow.float64(), unit, words, lambda row: row.outputs.get(name))


def unit_of_output(study: Study, name: str) -> str:
    """Return the unit of an output: as the study file says, else that of its key."""
    output = study.outputs[name]
    text = output.expression.strip()
    is_key = study.expressions[name].names == {text}
    return output.unit or (unit_of_key(text) if is_key else "")


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
