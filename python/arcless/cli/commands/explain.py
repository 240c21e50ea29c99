"""`arcless explain`: why σ of a saved run is as it is."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from arcless.cli.arguments.scenario import JsonOption, QuietOption
from arcless.cli.commands.saved_results import ResultArgument
from arcless.cli.process.background import compute
from arcless.cli.terminal import console

if TYPE_CHECKING:
    from arcless.explanation import Sensitivities
    from arcless.results import Result


def explain(
    result: ResultArgument,
    *,
    sensitivity: Annotated[
        bool,
        typer.Option(
            "--sensitivity",
            help="Vary dropper stiffness, tensions and pantograph masses too: four runs for each.",
        ),
    ] = False,
    step: Annotated[
        float | None,
        typer.Option(
            "--step",
            metavar="PERCENT",
            help="Step of --sensitivity in % of each parameter; 5 without it.",
            show_default=False,
        ),
    ] = None,
    out: Annotated[
        Path | None,
        typer.Option(
            "--out",
            metavar="FILE",
            help="Write one HTML page with figures to this file.",
            show_default=False,
        ),
    ] = None,
    json: JsonOption = False,
    quiet: QuietOption = False,
) -> None:
    """Explain the standard deviation σ of a run's contact force.

    Which part of the variance repeats with spans, which with droppers, which lies in the bands of
    the pantograph's modes; σ by span; where the force deviates most, and what is there. All of
    it comes from result.nc; only --sensitivity runs the scenario again. The section is that of the
    scenario, two spans at least.
    """
    from arcless.cli.terminal import explanation_tables
    from arcless.results import open as open_result

    opened = open_result(result)
    opened.explain()  # a section that is too short is told before anything is run
    known = _sensitivities(opened, step, quiet=quiet) if sensitivity else None
    if step is not None and not sensitivity:
        console.warn("--step has no effect without --sensitivity")
    found = opened.explain(known)
    if out is not None:
        from arcless.results import explanation_page

        explanation_page.write(opened, found, out)
    if json:
        console.data(console.json_text(found.to_dict()))
        return
    console.show(*explanation_tables.blocks(found))
    if out is not None:
        console.data(f"wrote {out}")


def _sensitivities(result: "Result", step: float | None, *, quiet: bool) -> "Sensitivities":
    from arcless.simulate.central_differences import STEP_PERCENT, sensitivities

    with console.progress(quiet=quiet) as progress:
        return compute(
            lambda cancel: sensitivities(
                result, step_percent=step or STEP_PERCENT, progress=progress, cancel=cancel
            )
        )
