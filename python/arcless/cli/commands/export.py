"""`arcless export`: a saved run for other programs."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from arcless.cli.commands.saved_results import ResultArgument
from arcless.cli.terminal import console

if TYPE_CHECKING:
    from arcless.errors import ResultFormatError


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
    units in the header; .mat has droppers and supports as well, and what supports carry over time;
    .xlsx also assessment and criteria.
    """
    from arcless.results import open as open_result
    from arcless.results import result_file
    from arcless.results.export.files import check_target
    from arcless.study import is_study
    from arcless.study.folder.folder import TABLE

    check_target(to)
    table = result / TABLE
    if table.is_file() and not result_file(result).exists():
        hint = f"{table} has the numbers of all its variants, for the same programs"
        raise _no_run(result, "the folder of a study", hint)
    if not result.is_dir() and is_study(str(result)):
        raise _no_run(result, "a study file", f"arcless study run {result} computes it")
    open_result(result).export(to)
    console.data(f"wrote {to}")


def _no_run(given: Path, got: str, hint: str) -> "ResultFormatError":
    from arcless.errors import ResultFormatError

    return ResultFormatError("not a run", where=str(given), got=got, expected="a run", hint=hint)
