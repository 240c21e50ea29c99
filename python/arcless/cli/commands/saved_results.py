"""`arcless report`: the page of a saved result."""

from pathlib import Path
from typing import Annotated

import typer

from arcless.cli.terminal import console

ResultArgument = Annotated[
    Path,
    typer.Argument(
        metavar="RUN",
        help="A run: the folder that `arcless run` wrote, or the result.nc in it.",
        show_default=False,
    ),
]


def report(
    result: ResultArgument,
    out: Annotated[
        Path | None,
        typer.Option(
            "--out",
            metavar="FILE",
            help="The file to write; report.html beside the result if not named.",
            show_default=False,
        ),
    ] = None,
) -> None:
    """Write the HTML report of a saved run again."""
    from arcless.results import open as open_result
    from arcless.results import result_file

    target = out or result_file(result).with_name("report.html")
    open_result(result).write_report(target)
    console.data(f"wrote {target}")
