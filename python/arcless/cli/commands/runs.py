"""`arcless runs`: the runs below a folder."""

from pathlib import Path
from typing import Annotated

import typer

from arcless.cli.arguments.scenario import JsonOption
from arcless.cli.terminal import console


def runs(
    folder: Annotated[
        Path | None,
        typer.Argument(
            metavar="FOLDER",
            help="Where to look, with all folders in it; runs if not named.",
            show_default=False,
        ),
    ] = None,
    *,
    json: JsonOption = False,
) -> None:
    """List the runs below a folder: verdict, main numbers, and what was set for each.

    From the oldest to the newest. Of several pantographs, the numbers are those of the one with the
    largest standard deviation; --json has all of them. A file that cannot be read is listed with
    the reason. Verdicts do not set the exit code.
    """
    from arcless.results.kept_runs.places import RUNS
    from arcless.results.kept_runs.search import search

    found = search(folder)
    if json:
        console.data(console.json_text([one.to_dict() for one in found.runs]))
    elif found.runs:
        from arcless.cli.terminal import runs_list

        console.show(*runs_list.lines(found.runs, folder or RUNS), fold=False)
    else:
        console.note(f"no runs below {folder or RUNS}: `arcless run SCENARIO` makes one")
    for study in found.studies:
        console.note(f"{study} is a study: `arcless study status {study}`")
