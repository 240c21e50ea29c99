"""`arcless export`: a saved run for other programs."""

from pathlib import Path
from typing import Annotated

import typer

from arcless.cli.commands.saved_results import ResultArgument
from arcless.cli.terminal import console


def export(
    result: ResultArgument,
    *,
    to: Annotated[
        Path,
        typer.Option(
            "--to",
            metavar="FILE",
            help="The file to write: .csv, .xlsx, .mat or .parquet; one that exists is replaced.",
            show_default=False,
        ),
    ],
) -> None:
    """Write a saved run for other programs, by the ending of the file.

    .csv and .parquet have contact channels over time, the filtered contact force among them, with
    units in the header; .mat has droppers and supports as well; .xlsx also assessment and criteria.
    """
    from arcless.results import open as open_result
    from arcless.results.export.files import check_target

    check_target(to)
    open_result(result).export(to)
    console.data(f"wrote {to}")
