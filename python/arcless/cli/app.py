"""The commands of `arcless`."""

from typing import Annotated

import typer

from arcless.cli.arguments.certainty import WithCertainty
from arcless.cli.commands import (
    compare,
    explain,
    export,
    replay,
    resume,
    run,
    runs,
    saved_results,
    studio,
    study,
    validate,
)
from arcless.cli.commands.loops import step_times
from arcless.cli.commands.measurements import measure
from arcless.cli.commands.models import fmu, model_files, own_models, receptance, table
from arcless.cli.completion import scripts
from arcless.cli.process.guard import GuardedGroup
from arcless.cli.terminal.console import data

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


# In the order of the work, as `--help` lists them: models, runs, results, evidence, help.
for _command in (
    model_files.library,
    own_models.show,
    own_models.new,
    table.table,
    model_files.check,
    model_files.schema,
    run.statics,
    run.run,
    resume.resume,
    step_times.step_times,
    runs.runs,
    saved_results.assess,
    saved_results.report,
    explain.explain,
    compare.compare,
    export.stress,
    export.export,
    measure.measure,
    studio.studio,
    validate.validate,
    replay.replay,
    scripts.completion,
):
    app.command(cls=WithCertainty if _command in (run.run, validate.validate) else None)(_command)

app.add_typer(study.app, name="study")
app.add_typer(receptance.app, name="pantograph")
app.add_typer(fmu.app, name="fmu")
