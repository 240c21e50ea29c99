"""`arcless validate`: the reference cases."""

import dataclasses
from typing import Annotated, Literal

import typer

from arcless.cli import console
from arcless.cli.background import compute
from arcless.cli.guard import FAILED
from arcless.cli.scenario import JsonOption, QuietOption


def validate(
    suite: Annotated[
        Literal["en50318", "seed", "all"], typer.Argument(help="Which reference cases to run.")
    ] = "all",
    json: JsonOption = False,
    quiet: QuietOption = False,
) -> None:
    """Run the reference cases and hold them against published ranges.

    Exit code 1 means that a value is outside of a range that was read in a source (mark A).
    Values outside of ranges that are only remembered (mark C*) are shown as such and do not
    count. This version has no `seed` cases; `all` runs those that exist.
    """
    from arcless import validate as cases

    with console.progress(quiet=quiet) as progress:
        rows = compute(lambda: cases.run(suite, progress))
    violated = sum(row.violates for row in rows)
    if json:
        console.data(console.json_text([dataclasses.asdict(row) for row in rows]))
    else:
        from arcless.cli import tables

        verified = sum(row.mark == cases.VERIFIED for row in rows)
        console.show(
            tables.comparisons(rows),
            f"{verified - violated} of {verified} values are inside the verified ranges.\n",
        )
    if violated:
        raise typer.Exit(FAILED)
