"""`arcless validate`: the reference cases."""

import dataclasses
from pathlib import Path
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
    report: Annotated[
        Path | None,
        typer.Option(
            "--report",
            metavar="FILE",
            help="Write the figures and verdicts of `seed` to this HTML file.",
            show_default=False,
        ),
    ] = None,
    json: JsonOption = False,
    quiet: QuietOption = False,
) -> None:
    """Run the reference cases and compare them with what is published.

    `en50318`: published ranges of the standard's cases. `seed`: the three conclusions of the
    paper that the method was founded on, on its worked example.

    Exit code 1 means that a value is outside of a range, or a conclusion does not hold, that was
    read in a source (mark A). Values outside of ranges that are only remembered (mark C*) are
    shown as such and do not count.
    """
    from arcless import validate as cases

    with console.progress(quiet=quiet) as progress:
        rows = compute(lambda: cases.run(suite, progress, report=report))
    violated = sum(row.violates for row in rows)
    if json:
        console.data(console.json_text([dataclasses.asdict(row) for row in rows]))
    else:
        from arcless.cli import tables

        verified = sum(row.mark == cases.VERIFIED for row in rows)
        sources = [cases.SEED_SOURCE] if suite != "en50318" else []
        console.show(
            tables.comparisons(rows),
            *tables.remarks(rows),
            *(f"Source of the conclusions: {source}.\n" for source in sources),
            f"{verified - violated} of {verified} values are inside the verified ranges.\n",
            *([f"wrote {report}"] if report else []),
        )
    if violated:
        raise typer.Exit(FAILED)
