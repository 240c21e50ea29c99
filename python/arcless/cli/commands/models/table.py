"""`arcless table`: spans, supports and droppers of a line as tables, out and in."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from arcless.cli.completion import names
from arcless.cli.terminal import console

if TYPE_CHECKING:
    from arcless.model import Line
    from arcless.model.table_edit import Edited


def table(
    line: Annotated[
        str,
        typer.Argument(
            metavar="LINE",
            help="A line: a shipped name or a file; for --to also a scenario, whose line is "
            "written. --from changes a line file of your own.",
            autocompletion=names.lines,
            show_default=False,
        ),
    ],
    *,
    to: Annotated[
        Path | None,
        typer.Option(
            "--to",
            metavar="TABLES",
            help="Write the tables: a workbook (.xlsx), or a folder for CSV files.",
            show_default=False,
        ),
    ] = None,
    source: Annotated[
        Path | None,
        typer.Option(
            "--from",
            metavar="TABLES",
            help="Change the line file to what the tables say: a workbook (.xlsx), or a folder of "
            "CSV files.",
            show_default=False,
        ),
    ] = None,
    overwrite: Annotated[
        bool,
        typer.Option(
            "--overwrite",
            help="With --to, replace tables that are there: a workbook with all its sheets; of a "
            "folder the CSV files of these names, those that the line has no use for removed.",
        ),
    ] = False,
) -> None:
    """Write a line as tables, or read tables into its file.

    There is a row for each span, support and dropper, and a unit in the header of each column.
    With --from, the file LINE is changed only where the tables say something else; its comments,
    wires and tensions stay. With --to, tables that exist are replaced only if --overwrite is
    given. An error in a table is reported by sheet, row and column, and the file is unchanged.
    """
    from arcless.errors import ModelError

    if (to is None) == (source is None):
        raise ModelError(
            "arcless table", got="--to and --from" if to is not None else "neither --to nor --from",
            expected="--to TABLES to write tables, or --from TABLES to read them",
        )  # fmt: skip
    if overwrite and to is None:
        raise ModelError("arcless table", got="--overwrite with --from",
                         expected="--overwrite with --to: --from replaces no tables")  # fmt: skip
    if to is not None:
        _write(line, to, overwrite=overwrite)
    elif source is not None:
        _read(line, source)


def say_left_out(found: "Edited") -> None:
    """Name sheets or files that are no tables of a line."""
    if found.left_out:
        console.warn(f"left out, as no tables of a line: {', '.join(found.left_out)}")


def _write(name: str, to: Path, *, overwrite: bool) -> None:
    from arcless.model.tables.files import write_tables
    from arcless.model.tables.of_line import tables_of

    written, removed = write_tables(to, tables_of(_line(name)), overwrite=overwrite)
    for file in written:
        console.data(f"wrote {file}")
    for file in removed:
        console.data(f"removed {file}, of which the line has nothing")


def _read(name: str, source: Path) -> None:
    from arcless.model.table_edit import edit_line

    _check_file(name)
    found = edit_line(name, source)
    say_left_out(found)
    if not found.changed:
        same = f"{source} says the same"
        if found.left_out:
            same = f"what was read of {source} says the same: {', '.join(found.read)}"
        console.data(f"{name}: nothing to change, {same}")
        return
    console.data(f"changed {name}: {', '.join(found.changed)}")
    console.data(f"next: arcless check {name}")


def _line(name: str) -> "Line":
    """Return a line by its shipped name or file; of a scenario, its line."""
    from arcless import model
    from arcless.errors import ModelError
    from arcless.model.shipped.library import find

    own = name.removeprefix("line/")
    if find("line", own):
        return model.load_line(own)
    found = model.load_any(name)
    if isinstance(found, model.Line):
        return found
    if isinstance(found, model.Scenario):
        return found.line
    raise ModelError("no line", got=f"the pantograph {name}", expected="a line, or a scenario",
                     hint="arcless library line lists the shipped ones")  # fmt: skip


def _check_file(name: str) -> None:
    """Refuse to change what is shipped, and a scenario, whose line is in another file."""
    from arcless.errors import ModelError
    from arcless.model.files.yaml_reader import is_file, parse, read_text
    from arcless.model.shipped.library import find

    own = name.removeprefix("line/")
    if not is_file(Path(name)) and any(find(kind, own) for kind in ("line", "scenario")):
        raise ModelError("no file of your own", got=f"the shipped {name}",
                         expected="a line file, which is changed",
                         hint=f"arcless new my-{own} --from {name} makes one")  # fmt: skip
    data, _ = parse(read_text(Path(name), name), name)
    if str(data.get("format")).startswith("arcless-scenario"):
        line = data.get("line")
        hint = f"its line is {line}" if isinstance(line, str) else "write its line into a file"
        raise ModelError("no line file", where=name, got="a scenario", expected="a line file",
                         hint=hint)  # fmt: skip
