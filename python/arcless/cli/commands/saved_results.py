"""`arcless assess` and `arcless report`: what follows from a saved result."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from arcless.cli.arguments.paper import FieldOption, PdfOption, fields_for
from arcless.cli.arguments.scenario import JsonOption, QuietOption
from arcless.cli.completion import names
from arcless.cli.output.outcome import finish
from arcless.cli.terminal import console

if TYPE_CHECKING:
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
    result: ResultArgument,
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
    out: Annotated[
        Path | None,
        typer.Option("--out", metavar="FILE", help="Write the assessment as JSON to this file."),
    ] = None,
    json: JsonOption = False,
    quiet: QuietOption = False,
) -> None:
    """Assess a saved run again, over another section or with another filter.

    Nothing is simulated: the statistics and criteria are computed from result.nc. The section
    and the low-pass filter are those of the scenario unless others are given.
    Exit code 3 means that a criterion is not met.
    """
    from arcless.assess import assess as assess_dataset
    from arcless.cli.terminal import tables
    from arcless.results import open as open_result
    from arcless.storage.whole_files import write_bytes

    section = _quantity("--from", start, "m"), _quantity("--to", end, "m")
    cutoff = _quantity("--low-pass", low_pass, "Hz")
    opened = open_result(result)
    found = assess_dataset(opened.latest, section=_section(opened, *section), low_pass_Hz=cutoff)
    if out is not None:
        write_bytes(out, found.to_json().encode())
    if json:
        console.data(found.to_json())
    else:
        section_text = f"Section: {found.section_m[0]:.1f} m to {found.section_m[1]:.1f} m.\n"
        assessment = found.to_dict()
        console.show(
            tables.statistics(assessment),
            tables.criteria(assessment),
            *tables.certainty(assessment),
            *tables.notes(assessment),
            section_text,
        )
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
) -> None:
    """Write the report of a saved run again: the HTML page, or a PDF file, or both.

    With --pdf alone only the PDF file is written.
    """
    from arcless.cli.output.outcome import reference_rows
    from arcless.results import RESULT_NAME, result_file
    from arcless.results import open as open_result

    fields = fields_for(pdf, field)
    file = result_file(result)
    # Other names are those of several runs in one folder, whose pages must not be one.
    own = file.with_name("report.html") if file.name == RESULT_NAME else file.with_suffix(".html")
    opened = open_result(result)
    rows = reference_rows(opened.scenario, opened.assessment.to_dict())
    page = out if out or pdf else own
    if page is not None:
        opened.write_report(page, reference_rows=rows)
        console.data(f"wrote {page}")
    if pdf is not None:
        opened.write_pdf(pdf, fields=fields, reference_rows=rows)
        console.data(f"wrote {pdf}")


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
