"""`arcless assess` and `arcless report`: what follows from a saved result, or a measured run."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from arcless.cli.arguments.head import (
    AccelerationDownOption,
    HeadLiftOption,
    HeadMassOption,
    head_of,
)
from arcless.cli.arguments.paper import FieldOption, PdfOption, fields_for
from arcless.cli.arguments.scenario import JsonOption, QuietOption
from arcless.cli.completion import names
from arcless.cli.output.outcome import finish
from arcless.cli.terminal import console

if TYPE_CHECKING:
    from arcless.assess import Assessment
    from arcless.model import Scenario
    from arcless.report.drawing.animation import Animation
    from arcless.results import Result

ResultArgument = Annotated[
    Path,
    typer.Argument(
        metavar="RUN",
        help="A run: the folder that `arcless run` wrote, or the result.nc in it.",
        autocompletion=names.runs,
        show_default=False,
    ),
]


def assess(
    subject: Annotated[
        Path,
        typer.Argument(
            metavar="RUN|FILE.csv",
            help="A run: the folder that `arcless run` wrote, or the result.nc in it. Or a measured"
            " test run: a CSV file with units in its header.",
            autocompletion=names.runs_and_measurements,
            show_default=False,
        ),
    ],
    *,
    start: Annotated[
        str | None,
        typer.Option("--from", metavar="LENGTH", help='Where the section begins, such as "550 m".'),
    ] = None,
    end: Annotated[
        str | None, typer.Option("--to", metavar="LENGTH", help='Where it ends, such as "1100 m".')
    ] = None,
    low_pass: Annotated[
        str | None,
        typer.Option(
            "--low-pass", metavar="FREQUENCY", help='Cut-off of the filter, such as "20 Hz".'
        ),
    ] = None,
    speed: Annotated[
        str | None,
        typer.Option(
            "--speed",
            metavar="SPEED",
            help='Of a CSV file without speeds: the constant speed, such as "250 km/h".',
        ),
    ] = None,
    supply: Annotated[
        str | None,
        typer.Option(
            "--supply",
            metavar="SUPPLY",
            help='Of a CSV file: the supply whose limits decide, such as "AC 25 kV" or "DC 3 kV".',
        ),
    ] = None,
    pantograph: Annotated[
        str | None,
        typer.Option(
            "--pantograph",
            metavar="NAME",
            help="Of a CSV file: the pantograph to assess; all without it.",
        ),
    ] = None,
    head_mass: HeadMassOption = None,
    head_lift: HeadLiftOption = None,
    acceleration_down: AccelerationDownOption = False,
    out: Annotated[
        Path | None,
        typer.Option("--out", metavar="FILE", help="Write the assessment as JSON to this file."),
    ] = None,
    report: Annotated[
        Path | None,
        typer.Option("--report", metavar="FILE", help="Of a CSV file: write an HTML page of it."),
    ] = None,
    json: JsonOption = False,
    quiet: QuietOption = False,
) -> None:
    """Assess a saved run again, or a measured run.

    Nothing is simulated: the statistics and criteria are computed from result.nc. Section
    and low-pass filter are those of the scenario unless others are given.

    A CSV file is assessed in the same way: time or position, speed, and contact force, with units
    in the header. Gaps, jumps and clipped samples are left out and listed; without --from and --to
    it is assessed as a whole.

    Exit code 3 means that a criterion is not met.
    """
    from arcless.measurements import is_measured
    from arcless.storage.whole_files import write_bytes

    scenario: Scenario | None = None
    section = _quantity("--from", start, "m"), _quantity("--to", end, "m")
    cutoff = _quantity("--low-pass", low_pass, "Hz")
    head = head_of(head_mass, head_lift, acceleration_down)
    if is_measured(subject):
        options = {"speed": speed, "pantograph": pantograph, "head": head}
        found = _measured(subject, options, section, cutoff, supply=supply, report=report)
        _warn([] if quiet else (found.measurement or {})["pantographs"])
    else:
        given = {"--speed": speed, "--supply": supply, "--pantograph": pantograph,
                 "--head-mass": head_mass, "--report": report}  # fmt: skip
        _refuse_options(subject, [name for name, value in given.items() if value is not None])
        found, scenario = _of_run(subject, section, cutoff)
    if out is not None:
        write_bytes(out, found.to_json().encode())
    if json:
        console.data(found.to_json())
    else:
        _show(found, scenario)
    if report is not None and not json:
        console.data(f"wrote {report}")
    finish(found.to_dict(), quiet=quiet)


def report(
    result: ResultArgument,
    out: Annotated[
        Path | None,
        typer.Option(
            "--out",
            metavar="FILE",
            help="The page to write; if neither it nor --pdf is named, report.html next to a"
            " result.nc, and NAME.html next to a NAME.nc.",
            show_default=False,
        ),
    ] = None,
    pdf: PdfOption = None,
    field: FieldOption = None,
    animation: Annotated[
        bool,
        typer.Option(
            "--animation",
            help="The page also shows the line move, offline; the run must have recorded its"
            " motion: `arcless run --set output.motion=true`.",
        ),
    ] = False,
) -> None:
    """Write the report of a saved run again: the HTML page, or a PDF file, or both.

    With --pdf alone only the PDF file is written.
    """
    from arcless.results import RESULT_NAME, result_file
    from arcless.results import open as open_result
    from arcless.validate import reference_rows

    fields = fields_for(pdf, field)
    file = result_file(result)
    # Other names are those of several runs in one folder, whose pages must not be one.
    own = file.with_name("report.html") if file.name == RESULT_NAME else file.with_suffix(".html")
    opened = open_result(result)
    rows = reference_rows(opened.scenario, opened.assessment.to_dict())
    page = out if out or (pdf and not animation) else own
    if page is not None:
        opened.write_report(page, reference_rows=rows, animation=_animation(opened, animation))
        console.data(f"wrote {page}")
    if pdf is not None:
        opened.write_pdf(pdf, fields=fields, reference_rows=rows)
        console.data(f"wrote {pdf}")


def _animation(opened: "Result", wanted: bool) -> "Animation | None":
    if not wanted:
        return None
    from arcless.studio.animation.animation import animation_of

    return animation_of(opened)


def _of_run(
    subject: Path, section: tuple[float | None, float | None], cutoff: float | None
) -> tuple["Assessment", "Scenario"]:
    from arcless.assess import assess as assess_dataset
    from arcless.results import open as open_result

    opened = open_result(subject)
    part = _section(opened, *section)
    return assess_dataset(opened.latest, section=part, low_pass_Hz=cutoff), opened.scenario


def _measured(
    subject: Path,
    options: Mapping[str, Any],
    section: tuple[float | None, float | None],
    cutoff: float | None,
    *,
    supply: str | None,
    report: Path | None,
) -> "Assessment":
    from arcless.errors import MeasurementError, ModelError
    from arcless.measurements import assess as assess_measurement
    from arcless.measurements import read, write_report

    try:
        measurement = read(subject, **options)
    except (MeasurementError, ModelError) as error:  # all others name the file
        error.where = "--speed" if error.where is None else error.where
        raise
    given: dict[str, Any] = {} if cutoff is None else {"low_pass_Hz": cutoff}
    found = assess_measurement(measurement, supply=supply, section=section, **given)
    if report is not None:
        write_report(measurement, found, report)
    return found


def _warn(pantographs: Sequence[Mapping[str, Any]]) -> None:
    """Warn of what is doubtful about measured forces."""
    for text in (text for each in pantographs for text in each["doubts"]):
        console.warn(text)


def _show(found: "Assessment", scenario: "Scenario | None") -> None:
    """Show an assessment; of a simulated run also which of its data are from memory."""
    from arcless.cli.terminal import tables
    from arcless.model.advice.unverified import unverified_data

    warnings = [] if scenario is None else unverified_data(scenario)
    section = f"Section: {found.section_words}.\n"
    console.show(*tables.summary(found.to_dict(), warnings), section)


def _refuse_options(subject: Path, given: list[str]) -> None:
    """Refuse options that a run has no use for: its scenario says it."""
    from arcless.errors import ModelError

    if given:
        raise ModelError(
            f"{', '.join(given)} of a run",
            where=str(subject),
            expected="a measured run, a file that ends in .csv",
            hint="speed and supply of a run are those of its scenario, and `arcless report` writes"
            " its page",
        )


def _quantity(option: str, text: str | None, unit: str) -> float | None:
    from arcless.errors import ModelError
    from arcless.units import to_si

    try:
        return None if text is None else to_si(text, unit)
    except ModelError as error:
        error.where = option
        raise


def _section(
    result: "Result", start: float | None, end: float | None
) -> tuple[float, float] | None:
    """Complete a section of which one end is given; none given means the scenario's own."""
    if start is None and end is None:
        return None
    own_start, own_end = result.metadata["section_m"]
    return own_start if start is None else start, own_end if end is None else end
