"""`arcless resume`: a run that stopped early is continued."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from arcless.cli.arguments.scenario import JsonOption, QuietOption
from arcless.cli.commands.saved_results import ResultArgument
from arcless.cli.output import outcome
from arcless.cli.output.outcome import NoReportOption, OverwriteOption, UntilOption
from arcless.cli.process.background import compute
from arcless.cli.terminal import console

if TYPE_CHECKING:
    from arcless.results import Result


def resume(
    result: ResultArgument,
    *,
    until: UntilOption = None,
    out: Annotated[
        Path | None,
        typer.Option(
            "--out",
            metavar="DIR",
            help="Folder for the results; the one of RUN if not named.",
            show_default=False,
        ),
    ] = None,
    overwrite: OverwriteOption = False,
    json: JsonOption = False,
    no_report: NoReportOption = False,
    quiet: QuietOption = False,
) -> None:
    """Continue a run that `arcless run --until` stopped.

    Writes and prints what `arcless run` would have done without stopping: the result is the same,
    bit for bit. Without --out, result.nc in the folder of RUN is replaced when all is done;
    another folder that holds a run is refused without --overwrite.

    Exit codes are those of `arcless run`; 2 when RUN holds no state to continue from, or one of
    another version or scenario.
    """
    from arcless.results import RESULT_NAME, result_file
    from arcless.results import open as open_result
    from arcless.results.run_folder.run_folder import for_run

    opened = open_result(result)
    own = result_file(result)
    with for_run(out or own.parent, overwrite=overwrite, own=own) as folder:
        whole = _go_on(opened, until, folder.file(RESULT_NAME), quiet=quiet)
        written = outcome.write(whole, folder, report=not no_report)
    outcome.tell(whole, written, json=json, quiet=quiet)


def _go_on(opened: "Result", until: str | None, file: Path, *, quiet: bool) -> "Result":
    from arcless import simulate

    to = file if simulate.is_long(opened.scenario) else None
    with console.progress(quiet=quiet) as progress:
        return compute(
            lambda cancel: simulate.resume(
                opened, until=until, to=to, progress=progress, cancel=cancel
            )
        )
