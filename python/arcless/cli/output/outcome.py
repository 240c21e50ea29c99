"""Outcome of a run: files in its folder, numbers on the screen, the exit code."""

from collections.abc import Iterable
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from arcless.cli.process.guard import NOT_MET
from arcless.cli.terminal import console

if TYPE_CHECKING:
    from arcless.model import Scenario
    from arcless.results import Result
    from arcless.storage.output_folder import OutputFolder

UntilOption = Annotated[
    str | None,
    typer.Option(
        "--until",
        metavar="PLACE",
        help='Stop early, at a place such as "600 m" or a time such as "5 s".',
        show_default=False,
    ),
]
OverwriteOption = Annotated[
    bool, typer.Option("--overwrite", help="Replace a run that is in the folder already.")
]
NoReportOption = Annotated[bool, typer.Option("--no-report", help="Do not write report.html.")]


# Modules that writing and printing need.
_NEEDED = ("h5py", "rich.console", "rich.table", "arcless.cli.terminal.tables", "arcless.validate")


def import_ahead(*, report: bool) -> None:
    """Import the libraries for writing and printing while a run still computes."""
    for name in _NEEDED:
        import_module(name)
    if report:
        from arcless.report import template

        template.import_ahead()


def write(result: "Result", folder: "OutputFolder", *, report: bool) -> list[Path]:
    """Write the files of a run; of one that stopped early, the result alone."""
    from arcless.results.run_folder import files
    from arcless.validate import reference_rows

    return files.write(result, folder, reference_rows if report else None)


def tell(result: "Result", written: list[Path], *, json: bool, quiet: bool) -> None:
    """Print the results, and leave with exit code 3 if a criterion is not met."""
    if not result.is_complete:
        _tell_stopped(result, written[0], json=json)
        return
    assessment = result.assessment.to_dict()
    if json:
        console.data(console.json_text(assessment))
    else:
        _show(result.scenario, assessment)
        say_written(written)
    finish(assessment, quiet=quiet)


def _tell_stopped(result: "Result", file: Path, *, json: bool) -> None:
    state = result.metadata["state"]
    facts = {
        "scenario": result.scenario.name,
        "position_m": state["position_m"],
        "time_s": result.metadata["simulated_time_s"],
        "step": state["step"],
        "result": str(file),
    }
    if json:
        console.data(console.json_text({"stopped": facts}))
        return
    place, time = f"{facts['position_m']:.2f} m", f"{facts['time_s']:g} s"
    console.data(f"stopped at {place}, {time}, after step {facts['step']}")
    say_written([file])
    console.data(f"continue with: arcless resume {file}")


def finish(assessment: dict[str, Any], *, quiet: bool) -> None:
    """Leave with exit code 3 if a criterion is not met whose limit decides."""
    from arcless.assess import decides

    missed = [item for item in assessment["criteria"] if item["passed"] is False]
    failed = _titles(item for item in missed if decides(item["mark"]))
    shown = _titles(item for item in missed if not decides(item["mark"]))
    if shown and not quiet:
        console.note(
            f"not met, by a limit that is not verified and does not set the exit code: {shown}"
        )
    if not failed:
        return
    if not quiet:
        console.note(f"exit code {NOT_MET}, not met: {failed}")
    raise typer.Exit(NOT_MET)


def _titles(criteria: Iterable[dict[str, Any]]) -> str:
    return "; ".join(dict.fromkeys(item["title"] for item in criteria))


def say_written(files: list[Path]) -> None:
    """Name the files that were written."""
    for file in files:
        console.data(f"wrote {file}")


def _show(scenario: "Scenario", assessment: dict[str, Any]) -> None:
    from arcless.cli.terminal import tables
    from arcless.model.advice.unverified import unverified_data
    from arcless.validate import case_of, compare

    case = case_of(scenario)
    rows = compare(case, assessment) if case else []
    console.show(*tables.summary(assessment, unverified_data(scenario), rows))
    console.show(f"Computed with {scenario.choice.sentence}.\n")
    if case:
        console.show(f"Published ranges: {case.source}.\n")
