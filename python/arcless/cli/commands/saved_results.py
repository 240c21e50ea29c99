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
            help="The file to write; if not named, report.html next to a result.nc, and NAME.html"
            " next to a NAME.nc.",
            show_default=False,
        ),
    ] = None,
) -> None:
    """Write the HTML report of a saved run again."""
    from arcless.results import RESULT_NAME, result_file
    from arcless.results import open as open_result

    file = result_file(result)
    # Other names are those of several runs in one folder, whose pages must not be one.
    own = file.with_name("report.html") if file.name == RESULT_NAME else file.with_suffix(".html")
    target = out or own
    open_result(result).write_report(target)
    console.data(f"wrote {target}")
