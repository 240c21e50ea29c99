"""`arcless library`, `arcless check` and `arcless schema`: model files without computing."""

from typing import TYPE_CHECKING, Annotated, Literal

import typer

from arcless.cli.arguments.scenario import JsonOption
from arcless.cli.completion import names
from arcless.cli.terminal import console

if TYPE_CHECKING:
    from arcless.model import Line, Pantograph, Scenario


def library(
    kind: Annotated[
        Literal["line", "pantograph", "scenario", "study", "wire", "all"],
        typer.Argument(help="What to list."),
    ] = "all",
    *,
    sources: Annotated[
        bool, typer.Option("--sources", "-v", help="List the sources of each model, too.")
    ] = False,
    json: JsonOption = False,
) -> None:
    """List the shipped models.

    A scenario can be run by its name, and so can a study (`arcless study run NAME`). A scenario
    file may name a line and pantographs, and a line file may name wires of the catalogue. With
    --sources, where the numbers of each are from.
    """
    from arcless import model

    entries = [entry for entry in model.library() if kind in (entry.kind, "all")]
    if json:
        console.data(console.json_text([entry._asdict() for entry in entries]))
        return
    from rich.text import Text

    from arcless.cli.terminal.tables import table

    for shown in dict.fromkeys(entry.kind for entry in entries):
        plural = "studies" if shown == "study" else f"{shown}s"
        columns = ("name", "description and sources" if sources else "description")
        made = table(f"Shipped {plural}", *columns, lines=sources)
        for entry in entries:
            if entry.kind == shown:
                cited = Text(f"\n{entry.source}" if sources else "", style="dim")
                made.add_row(entry.name, Text(entry.title) + cited)
        console.show(made)


def check(
    file: Annotated[
        str,
        typer.Argument(
            metavar="FILE",
            help="A line, pantograph, scenario or study: a file or a shipped name.",
            autocompletion=names.models,
            show_default=False,
        ),
    ],
) -> None:
    """Check a model file, and the line at rest that it describes. Nothing is run.

    Says what is wrong, in which line and field, what was given and what is expected. Exit code 2
    means that something is wrong. Warnings, such as a speed above the wave speed or a tension that
    looks like another unit, are no errors.
    """
    from arcless import model, study

    if study.is_study(file):
        loaded = study.load(file)
        console.data(f"{file}: valid study `{loaded.name}`, {loaded.plan.count} variants")
        return
    checked = model.load_any(file)
    from arcless.simulate import checks

    for warning in checks.advice(checked, file):
        console.warn(warning)
    checks.check_rest(checked, file)
    console.data(f"{file}: valid {_description(checked)}")
    if isinstance(checked, model.Scenario):
        console.data(f"a run takes {checked.choice.sentence}")


def schema() -> None:
    """Print the JSON Schema of model and study files, for editors."""
    from arcless import study

    console.data(console.json_text(study.json_schema()))


def _description(checked: "Scenario | Line | Pantograph") -> str:
    """Say in a few words what a model holds, so that a wrong file is noticed."""
    from arcless.model import Line, Pantograph

    if isinstance(checked, Line):
        spans = len(checked.span_list())
        return f"line `{checked.name}`, {spans} spans, {checked.total_length:.0f} m"
    if isinstance(checked, Pantograph):
        if checked.fmu is not None:
            return f"pantograph `{checked.name}`, {checked.in_words()[0]}"
        noun = "masses" if checked.matrices is None else "coordinates, given by matrices"
        return f"pantograph `{checked.name}`, {checked.size} {noun}"
    count = len(checked.pantographs)
    noun = "pantograph" if count == 1 else "pantographs"
    return f"scenario `{checked.name}`, line `{checked.line.name}`, {count} {noun}"
