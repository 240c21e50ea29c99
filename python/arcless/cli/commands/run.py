"""`arcless run` and `arcless statics`."""

import shlex
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from arcless.cli.arguments.certainty import CertaintyOption, asked_for, check_whole
from arcless.cli.arguments.scenario import (
    AllowFmuOption,
    AtRestArgument,
    JsonOption,
    QuietOption,
    ScenarioArgument,
    SetOption,
    SpeedOption,
    line_of,
    load,
    load_at_rest,
)
from arcless.cli.arguments.schedules import (
    AllowanceOption,
    DroppersOption,
    Schedules,
    SupportsOption,
)
from arcless.cli.output import outcome
from arcless.cli.output.outcome import NoReportOption, OverwriteOption, UntilOption
from arcless.cli.output.places import check_place
from arcless.cli.process.background import compute
from arcless.cli.process.start import permanent_objects
from arcless.cli.terminal import console

if TYPE_CHECKING:
    from arcless.model import Line, Scenario
    from arcless.results import Result
    from arcless.simulate import StaticsResult

FolderOption = Annotated[
    Path | None,
    typer.Option(
        "--out",
        metavar="DIR",
        help="Folder for the results; as above if not named.",
        show_default=False,
    ),
]
PlotOption = Annotated[
    Path | None,
    typer.Option(
        "--plot",
        metavar="FILE.html",
        help="Write the line at rest as a page: views, elasticity, forces, dropper table.",
        show_default=False,
    ),
]


def run(
    scenario: ScenarioArgument,
    *,
    speed: SpeedOption = None,
    set_: SetOption = None,
    out: FolderOption = None,
    json: JsonOption = False,
    until: UntilOption = None,
    certainty: CertaintyOption = None,
    overwrite: OverwriteOption = False,
    no_report: NoReportOption = False,
    allow_fmu: AllowFmuOption = False,
    quiet: QuietOption = False,
) -> None:
    """Simulate a scenario: line at rest, run, assessment, report.

    Writes result.nc, assessment.json and report.html into a folder: runs/NAME or, where fields are
    set for the run, runs/NAME-speed=280_km-h and the like, unless --out names another. A folder
    that holds a run is refused before anything is computed, unless --overwrite is given.

    Prints the numbers with the criteria and, for a shipped reference case, the ranges published for
    it. With --until, only result.nc is written, from which `arcless resume` continues. With
    --certainty, every number comes with its spread over starts and its error of discretisation.

    Exit code 1: the computation failed, and nothing is written. Exit code 2: the input is wrong,
    also where the line cannot hang as the file says. Exit code 3: everything is written,
    and a criterion is not met. Limits that were not read in a source (marks C, C* and assumed) are
    shown and set no exit code, nor do criteria too close to tell. Ranges of reference cases decide
    nothing here; `arcless validate` is for them.
    """
    check_whole(certainty, until)
    chosen = asked_for(load(scenario, speed=speed, changes=set_, quiet=quiet), certainty)
    with permanent_objects():
        from arcless.results import RESULT_NAME
        from arcless.results.run_folder.run_folder import folder_of, for_run
        from arcless.simulate.checks import faults_of

    with for_run(out or folder_of(chosen), overwrite=overwrite) as folder:
        _tell_size(chosen, quiet=quiet)
        command = _command(scenario, speed, set_, certainty, allow_fmu=allow_fmu)
        with faults_of(scenario):
            result = _simulate(
                chosen, until, folder.file(RESULT_NAME), command, quiet=quiet, allow_fmu=allow_fmu,
                meanwhile=lambda: outcome.import_ahead(report=not no_report and until is None),
            )  # fmt: skip
        written = outcome.write(result, folder, report=not no_report)
    outcome.tell(result, written, json=json, quiet=quiet)


def statics(
    scenario: AtRestArgument,
    *,
    set_: SetOption = None,
    out: FolderOption = None,
    plot: PlotOption = None,
    droppers: DroppersOption = None,
    allowance: AllowanceOption = None,
    supports: SupportsOption = None,
    json: JsonOption = False,
    quiet: QuietOption = False,
) -> None:
    """Find the line at rest, without a run.

    Prints dropper lengths and forces of one span, sag, elasticity, wave speed and natural
    frequencies; --json has all spans. With --out, statics.json is written into that folder; with
    --plot, a page with views, elasticity, forces and tables of all spans; with --droppers and
    --supports, schedules for workshop and site. The speed is ignored; pantographs only mark
    resonance speeds, which a line alone has not: it is found as designed, on fine cubic elements.
    """
    from arcless.cli.terminal import statics_tables
    from arcless.storage.output_folder import OutputFolder
    from arcless.storage.whole_files import write_bytes

    chosen = load_at_rest(scenario, changes=set_, quiet=quiet)
    written: list[Path] = []
    if plot is not None:
        check_place(plot, ".html", "--plot")
    wanted = Schedules.of(droppers, supports, allowance, line_of(chosen))
    if out is None:
        result = _find_statics(scenario, chosen, quiet=quiet)
    else:
        with OutputFolder(out, "statics.json") as folder:
            result = _find_statics(scenario, chosen, quiet=quiet)
            text = console.json_text(result.to_dict())
            write_bytes(folder.file("statics.json"), text.encode())
            written = folder.publish()
    found = result.to_dict()
    if plot is not None:
        from arcless.report import statics_page

        statics_page.write(result, plot, resonance=found["resonance_speeds"])
        written.append(plot)
    written += wanted.write(result)
    if json:
        console.data(console.json_text(found))
    else:
        console.show(*statics_tables.blocks(chosen.name, found))
        outcome.say_written(written)


def _tell_size(scenario: "Scenario", *, quiet: bool) -> None:
    """Tell how much the motion of the wires takes, where it is recorded."""
    if scenario.output.motion is None or quiet:
        return
    from arcless.simulate.checks import faults_of
    from arcless.simulate.recording.motion import interval_s, motion_bytes

    with faults_of(scenario.name):
        size, every = motion_bytes(scenario), 1e3 * interval_s(scenario, scenario.output.motion)
    console.note(f"the motion of the wires is recorded every {every:.3g} ms: {size / 1e6:.3g} MB")


def _simulate(
    scenario: "Scenario",
    until: str | None,
    file: Path,
    command: str,
    *,
    quiet: bool,
    allow_fmu: bool,
    meanwhile: Callable[[], None],
) -> "Result":
    with permanent_objects():
        from arcless import simulate

    to = file if simulate.is_long(scenario) else None
    with console.progress(quiet=quiet) as progress:
        return compute(
            lambda cancel: simulate.run(
                scenario,
                until=until,
                to=to,
                command=command,
                progress=progress,
                cancel=cancel,
                allow_fmu=allow_fmu,
            ),
            meanwhile,
        )


def _find_statics(name: str, source: "Scenario | Line", *, quiet: bool) -> "StaticsResult":
    with permanent_objects():
        from arcless import simulate
        from arcless.simulate.checks import faults_of

    with faults_of(name), console.progress(quiet=quiet) as progress:
        return compute(lambda _cancel: simulate.statics(source, progress=progress))


def _command(
    scenario: str,
    speed: str | None,
    changes: list[str] | None,
    certainty: str | None = None,
    *,
    allow_fmu: bool = False,
) -> str:
    words = ["arcless", "run", scenario]
    words += [] if speed is None else ["--speed", speed]
    for change in changes or []:
        words += ["--set", change]
    words += [] if certainty is None else ["--certainty", certainty]
    words += ["--allow-fmu"] if allow_fmu else []
    return shlex.join(words)
