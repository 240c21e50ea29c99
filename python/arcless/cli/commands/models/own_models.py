"""`arcless show` and `arcless new`: shipped models as text, and own models."""

from pathlib import Path
from typing import Annotated

import typer

from arcless.cli.completion import names
from arcless.cli.terminal import console


def show(
    model: Annotated[
        str,
        typer.Argument(
            metavar="MODEL",
            help="A shipped line, pantograph, scenario or study, a wire of the catalogue, or a "
            "file. Where kinds share a name it is the scenario; line/NAME and the like mean the "
            "others.",
            autocompletion=names.models,
            show_default=False,
        ),
    ],
) -> None:
    """Print a model file as it stands, comments and sources with it."""
    from arcless.model.own_copy import text_of

    console.data(text_of(model).removesuffix("\n"))


def new(
    name: Annotated[
        str,
        typer.Argument(metavar="NAME", help="The name of the new model.", show_default=False),
    ],
    *,
    source: Annotated[
        str,
        typer.Option(
            "--from",
            metavar="MODEL",
            help="A shipped scenario, line, pantograph or study; line/NAME and the like where "
            "kinds share a name.",
            autocompletion=names.shipped_models,
            show_default=False,
        ),
    ],
    to: Annotated[
        Path, typer.Option("--to", metavar="FOLDER", help="A folder that exists.")
    ] = Path(),
    with_pantographs: Annotated[
        bool, typer.Option("--with-pantographs", help="Copy the scenario's pantographs, too.")
    ] = False,
    two_pantographs: Annotated[
        str | None,
        typer.Option(
            "--two-pantographs",
            metavar="SPACING",
            help="Add a second pantograph like the scenario's one, so far behind it: a length such "
            "as '100 m', or tsi: that of the TSI for the speed (200 m from 250 km/h, 85 m above "
            "120, 15 m above 80, else 8 m), which follows the speed.",
            show_default=False,
        ),
    ] = None,
    scenario: Annotated[
        str | None,
        typer.Option(
            "--scenario",
            metavar="SCENARIO",
            help="The scenario that the copy of a study varies: a shipped name, or a file relative "
            "to the copy.",
            autocompletion=names.scenarios,
            show_default=False,
        ),
    ] = None,
    table: Annotated[
        Path | None,
        typer.Option(
            "--table",
            metavar="TABLES",
            help="Spans, supports and droppers of the line: a workbook (.xlsx), or a folder of CSV "
            "files, as `arcless table` writes them.",
            show_default=False,
        ),
    ] = None,
) -> None:
    """Create a model of your own from a shipped one.

    NAME.yaml is written with all comments and sources, of a scenario also its line,
    NAME-line.yaml, and arcless.schema.json, by which an editor knows fields and units. No file is
    replaced.
    """
    from arcless import study
    from arcless.model.own_copy import KINDS, copies, write_copies

    files = copies(name, source, with_pantographs=with_pantographs,
                   two_pantographs=two_pantographs, scenario=scenario)  # fmt: skip
    if table is not None:
        files |= _with_table(name, files, table)
    schema = console.json_text(study.json_schema()) + "\n"
    for path in write_copies(to, files, schema):
        console.data(f"wrote {path}")
    first = to / f"{name}.yaml"
    console.data(f"next: edit it, then arcless check {first}")
    kind = next(kind for kind in KINDS if f"format: arcless-{kind}/" in files[f"{name}.yaml"])
    then = {
        "scenario": f": arcless run {first}",
        "study": f": arcless study run {first}",
        "line": f" name it in a scenario: line: {name}.yaml",
        "pantograph": f" name it in a scenario: pantographs: [{{model: {name}.yaml}}]",
    }
    console.data(f"and{then[kind]}")


def _with_table(name: str, files: dict[str, str], table: Path) -> dict[str, str]:
    """Return the file of the line with tables laid over it."""
    from arcless.cli.commands.models.table import say_left_out
    from arcless.errors import ModelError
    from arcless.model.table_edit import edited_line

    file = next(own for own in (f"{name}-line.yaml", f"{name}.yaml") if own in files)
    if "format: arcless-line/" not in files[file]:
        raise ModelError("--table", got="a model without a line file of its own",
                         expected="a line, or a scenario that names one")  # fmt: skip
    found = edited_line(files[file], file, table)
    say_left_out(found)
    return {file: found.text}
