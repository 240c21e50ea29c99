"""The commands of `arcless`."""

from typing import Annotated

import typer

from arcless.cli import inspect, replay, results, resume, run, study, validate
from arcless.cli.certainty import WithCertainty
from arcless.cli.console import data
from arcless.cli.guard import GuardedGroup

app = typer.Typer(
    cls=GuardedGroup,
    add_completion=False,
    rich_markup_mode=None,
    invoke_without_command=True,
    epilog="Exit codes: 0 done; 1 the computation failed, nothing is written; 2 the input is "
    "wrong; 3 done and written, and a criterion is not met.",
)


def _print_version(wanted: bool) -> None:
    if wanted:
        from importlib.metadata import version

        data(f"arcless {version('arcless')}")
        raise typer.Exit


@app.callback()
def arcless(
    context: typer.Context,
    _version: Annotated[
        bool,
        typer.Option(
            "--version", is_eager=True, callback=_print_version, help="Print the version."
        ),
    ] = False,
) -> None:
    """Simulate pantographs and overhead contact lines moving together.

    To begin: arcless run en50318-ac-simple-320, then open the report that it names.

    SCENARIO is the name of a shipped scenario (`arcless library scenario` lists them) or a file.
    Numbers are SI; text may carry a unit: "300 km/h", "22 kN", "2 ms".
    """
    if context.invoked_subcommand is None:
        data(context.get_help())


for _command in (
    inspect.library,
    inspect.check,
    inspect.schema,
    run.statics,
    resume.resume,
    results.assess,
    results.report,
    replay.replay,
):
    app.command()(_command)

for _asked in (run.run, validate.validate):
    app.command(cls=WithCertainty)(_asked)

app.add_typer(study.app, name="study")
