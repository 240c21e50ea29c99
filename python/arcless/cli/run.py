"""`arcless run` and `arcless statics`."""

import shlex
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from arcless.cli import console
from arcless.cli.background import compute
from arcless.cli.guard import FAILED
from arcless.cli.output import OutputFolder, check_place
from arcless.cli.scenario import (
    JsonOption,
    QuietOption,
    ScenarioArgument,
    SetOption,
    SpeedOption,
    folder_of,
    load,
)

if TYPE_CHECKING:
    from arcless.model import Scenario
    from arcless.results import Result
    from arcless.simulate import StaticsResult

FolderOption = Annotated[
    Path | None,
    typer.Option("--out", metavar="DIR", help="Folder for the results.", show_default=False),
]
PlotOption = Annotated[
    Path | None,
    typer.Option(
        "--plot",
        metavar="FILE.html",
        help="Draw the line at rest from the side and from above, with its elasticity.",
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
    no_report: Annotated[
        bool, typer.Option("--no-report", help="Do not write report.html.")
    ] = False,
    quiet: QuietOption = False,
) -> None:
    """Simulate a scenario: line at rest, run, assessment, report.

    Writes result.nc, assessment.json and report.html into a folder, runs/NAME unless --out names
    another, and prints the numbers with the criteria and, for a shipped reference case, the
    ranges published for it.

    Exit code 1 means that the computation failed, and then nothing is written, or that a
    criterion is not met, and then everything is. Ranges of reference cases decide nothing here;
    `arcless validate` is for them.
    """
    chosen = load(scenario, speed=speed, changes=set_, quiet=quiet)
    with OutputFolder(out or folder_of(chosen)) as folder:
        result = _simulate(chosen, quiet=quiet)
        result.dataset.attrs["command"] = _command(scenario, speed, set_)
        result.save(folder.file("result.nc"))
        folder.file("assessment.json").write_text(result.assessment.to_json(), "utf-8")
        if not no_report:
            rows = _reference_rows(chosen, result.assessment.to_dict())
            result.write_report(folder.file("report.html"), reference_rows=rows)
        written = folder.publish()
    assessment = result.assessment.to_dict()
    if json:
        console.data(console.json_text(assessment))
    else:
        _show(chosen, assessment)
        _say_written(written)
    finish(assessment, quiet=quiet)


def statics(
    scenario: ScenarioArgument,
    *,
    set_: SetOption = None,
    out: FolderOption = None,
    plot: PlotOption = None,
    json: JsonOption = False,
    quiet: QuietOption = False,
) -> None:
    """Find the line at rest, without a run.

    Prints dropper lengths and forces of one span, sag, elasticity, wave speed and natural
    frequencies; --json has all spans. With --out, statics.json is written into that folder; with
    --plot, side view, plan view and elasticity are drawn. Speed and pantographs have no part here.
    """
    from arcless.cli import statics_tables

    chosen = load(scenario, changes=set_, quiet=quiet)
    written: list[Path] = []
    if plot is not None:
        check_place(plot, ".html", "--plot")
    if out is None:
        result = _find_statics(chosen, quiet=quiet)
    else:
        with OutputFolder(out) as folder:
            result = _find_statics(chosen, quiet=quiet)
            text = console.json_text(result.to_dict())
            folder.file("statics.json").write_text(text, "utf-8")
            written = folder.publish()
    found = result.to_dict()
    if plot is not None:
        from arcless.report import rest

        rest.write(result, plot)
        written.append(plot)
    if json:
        console.data(console.json_text(found))
    else:
        console.show(*statics_tables.blocks(chosen.name, found))
        _say_written(written)


def finish(assessment: dict[str, Any], *, quiet: bool) -> None:
    """Leave with exit code 1 if a criterion is not met."""
    missed = [item["title"] for item in assessment["criteria"] if item["passed"] is False]
    if not missed:
        return
    if not quiet:
        console.note(f"exit code 1, not met: {'; '.join(dict.fromkeys(missed))}")
    raise typer.Exit(FAILED)


def _simulate(scenario: "Scenario", *, quiet: bool) -> "Result":
    from arcless import simulate

    with console.progress(quiet=quiet) as progress:
        return compute(lambda: simulate.run(scenario, progress=progress))


def _find_statics(scenario: "Scenario", *, quiet: bool) -> "StaticsResult":
    from arcless import simulate

    with console.progress(quiet=quiet) as progress:
        return compute(lambda: simulate.statics(scenario, progress=progress))


def _reference_rows(scenario: "Scenario", assessment: dict[str, Any]) -> list[dict[str, Any]]:
    """Return published ranges for the report: of a reference case as shipped, else none."""
    from arcless.validate import case_of, compare

    case = case_of(scenario)
    if case is None:
        return []
    return [
        {
            "quantity": f"{row.quantity}, {row.unit}",
            "value": row.value,
            "low": row.low,
            "high": row.high,
            "verdict": row.verdict,
            "mark": row.mark,
            "source": case.source,
        }
        for row in compare(case, assessment)
    ]


def _say_written(files: list[Path]) -> None:
    for file in files:
        console.data(f"wrote {file}")


def _command(scenario: str, speed: str | None, changes: list[str] | None) -> str:
    words = ["arcless", "run", scenario]
    words += [] if speed is None else ["--speed", speed]
    for change in changes or []:
        words += ["--set", change]
    return shlex.join(words)


def _show(scenario: "Scenario", assessment: dict[str, Any]) -> None:
    from arcless.cli import tables
    from arcless.validate import case_of, compare

    case = case_of(scenario)
    rows = compare(case, assessment) if case else []
    console.show(tables.statistics(assessment, rows), tables.criteria(assessment))
    if case:
        console.show(f"Published ranges: {case.source}.\n")
