"""`arcless compare`: runs, and measured test runs, side by side."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from arcless.cli.arguments.amounts import amount
from arcless.cli.arguments.head import (
    AccelerationDownOption,
    HeadLiftOption,
    HeadMassOption,
    head_of,
)
from arcless.cli.arguments.paper import FieldOption, PdfOption, fields_for
from arcless.cli.arguments.scenario import JsonOption, QuietOption
from arcless.cli.completion import names
from arcless.cli.terminal import console

if TYPE_CHECKING:
    from arcless.comparison import Comparison
    from arcless.comparison.measured.placing import Aligning
    from arcless.comparison.subjects.runs import Subject
    from arcless.measurements import Head

RunsArgument = Annotated[
    list[Path],
    typer.Argument(
        metavar="RUN RUN ...",
        help="Two runs or more, each its folder or the result.nc in it, or the CSV file of a"
        " measured test run. Differences are to the first one.",
        autocompletion=names.runs_and_measurements,
        show_default=False,
    ),
]


def compare(
    runs: RunsArgument,
    *,
    out: Annotated[
        Path | None,
        typer.Option(
            "--out",
            metavar="FILE",
            help="Write one HTML page with overlays to this file; at most six runs.",
            show_default=False,
        ),
    ] = None,
    pdf: PdfOption = None,
    field: FieldOption = None,
    align: Annotated[
        str,
        typer.Option(
            "--align",
            metavar="WAY",
            help="How measurements are put on the line of the first run: by `correlation` of the"
            " forces, by `supports` (what all spans have in common), or `none`.",
        ),
    ] = "correlation",
    align_by: Annotated[
        str | None,
        typer.Option(
            "--align-by",
            metavar="CHANNEL",
            help="The channel that is aligned: `force`, or `height` of the contact point. If not"
            " given, the force, or the height where the force is that of sensors below the strips"
            " without --head-mass.",
            show_default=False,
        ),
    ] = None,
    offset: Annotated[
        str | None,
        typer.Option(
            "--offset",
            metavar="LENGTH",
            help='By hand: what is added to the first measured position, such as "3.2 m".',
        ),
    ] = None,
    scale: Annotated[
        float | None,
        typer.Option(
            "--scale", metavar="NUMBER", help="With --offset: metres on the line for one measured."
        ),
    ] = None,
    search: Annotated[
        str | None,
        typer.Option(
            "--search",
            metavar="LENGTH",
            help="How far from zero the offset is searched; half of a span if not given, and"
            " everything where the positions are not those of the line.",
        ),
    ] = None,
    drift: Annotated[
        str | None,
        typer.Option(
            "--drift",
            metavar="PART",
            help="How far the scale of the odometer may be from 1; 0.5 % if not given.",
        ),
    ] = None,
    speed: Annotated[
        str | None,
        typer.Option(
            "--speed", metavar="SPEED", help='Of a CSV file without speeds, such as "250 km/h".'
        ),
    ] = None,
    head_mass: HeadMassOption = None,
    head_lift: HeadLiftOption = None,
    acceleration_down: AccelerationDownOption = False,
    json: JsonOption = False,
    quiet: QuietOption = False,
) -> None:
    """Compare runs, simulated or measured, with the first.

    There are numbers with differences, changed fields, verdicts, overlays. Nothing is simulated:
    all of it comes from the result files. Criteria do not set the exit code. A run may also be the
    CSV file of a measured test run: it is put on the line of the first run, and compared band by
    band and with the tolerances of EN 50318 (from memory).
    """
    from arcless.comparison import compare as compare_runs

    fields = fields_for(pdf, field)
    how = _aligning((align, align_by), offset, scale, search=search, drift=drift)
    head = head_of(head_mass, head_lift, acceleration_down)
    compared = compare_runs(_read(runs, speed, head), aligning=how)
    if out is not None:
        compared.write_report(out)
    if pdf is not None:
        compared.write_pdf(pdf, fields=fields)
    if json:
        console.data(console.json_text(compared.to_dict()))
        return
    for text in () if quiet else compared.warnings:
        console.warn(text)
    _show(compared)
    for file in (out, pdf):
        if file is not None:
            console.data(f"wrote {file}")


def _show(compared: "Comparison") -> None:
    """Print what the runs are, what differs, numbers and verdicts."""
    from arcless.cli.terminal import comparison_tables as tables
    from arcless.comparison.cells import DIFFERENCES_READ

    several = sum(one.result is not None for one in compared.sides) > 1
    same = ["No field of the scenarios differs.\n"] if several else []
    console.show(tables.runs(compared))
    console.show(tables.origins(compared), fold=False)
    console.show(
        *([tables.fields(compared)] if compared.fields else same),
        *tables.placement(compared),
        tables.numbers(compared),
        f"{DIFFERENCES_READ.format(compared.names[0])}\n",
        tables.verdicts(compared),
        *tables.bands(compared),
        *tables.acceptance(compared),
    )


def _aligning(
    ways: tuple[str, str | None],
    offset: str | None,
    scale: float | None,
    *,
    search: str | None,
    drift: str | None,
) -> "Aligning":
    """Return how measurements are aligned, from the options."""
    from arcless.comparison.measured.placing import SCALE_WITHIN, Aligning
    from arcless.errors import ComparisonError

    if scale is not None and offset is None:
        raise ComparisonError("--scale without --offset", expected="the offset, such as 0 m")
    return Aligning(
        *ways,
        None if offset is None else amount("--offset", offset, "m"),
        1.0 if scale is None else scale,
        None if search is None else amount("--search", search, "m"),
        SCALE_WITHIN if drift is None else amount("--drift", drift, "1"),
    )


def _read(runs: list[Path], speed: str | None, head: "Head | None") -> "list[Subject | str | Path]":
    """Read measurements with the options for them; runs are read by the comparison."""
    from arcless.comparison.subjects.runs import refuse_twice
    from arcless.errors import ComparisonError
    from arcless.measurements import is_measured, read

    if not any(map(is_measured, runs)) and (speed is not None or head is not None):
        given = "--speed" if head is None else "--head-mass"
        raise ComparisonError(
            f"{given} without a measurement",
            expected="a file that ends in .csv among those that are compared",
            hint="speed and masses of a run are those of its scenario",
        )
    refuse_twice([one.resolve() for one in runs], [str(one) for one in runs])
    asked = None if speed is None else amount("--speed", speed, "m/s")
    return [read(one, speed=asked, head=head) if is_measured(one) else one for one in runs]
