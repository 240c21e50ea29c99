"""`arcless compare`: runs side by side."""

from pathlib import Path
from typing import Annotated

import typer

from arcless.cli.arguments.paper import FieldOption, PdfOption, fields_for
from arcless.cli.arguments.scenario import JsonOption, QuietOption
from arcless.cli.completion import names
from arcless.cli.terminal import console

RunsArgument = Annotated[
    list[Path],
    typer.Argument(
        metavar="RUN RUN ...",
        help="Two runs or more, each its folder or the result.nc in it. Differences are to the"
        " first one.",
        autocompletion=names.runs,
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
    json: JsonOption = False,
    quiet: QuietOption = False,
) -> None:
    """Compare runs: numbers with differences, changed fields, verdicts, overlays.

    Nothing is simulated: all of it comes from the result files. Criteria do not set the exit code.
    """
    from arcless.comparison import compare as compare_runs

    fields = fields_for(pdf, field)
    compared = compare_runs(runs)
    if out is not None:
        compared.write_report(out)
    if pdf is not None:
        compared.write_pdf(pdf, fields=fields)
    if json:
        console.data(console.json_text(compared.to_dict()))
        return
    from arcless.cli.terminal import comparison_tables as tables

    for text in () if quiet else compared.warnings:
        console.warn(text)
    same = "No field of the scenarios differs.\n"
    console.show(
        tables.fields(compared) if compared.fields else same,
        tables.numbers(compared),
        tables.verdicts(compared),
    )
    for file in (out, pdf):
        if file is not None:
            console.data(f"wrote {file}")
