"""`arcless validate`: the reference cases."""

import dataclasses
from collections import Counter
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer

from arcless.cli.arguments.certainty import CertaintyOption, number_of
from arcless.cli.arguments.scenario import JsonOption, QuietOption
from arcless.cli.process.background import compute
from arcless.cli.process.guard import NOT_MET
from arcless.cli.terminal import console

if TYPE_CHECKING:
    from arcless.validate import Topic


def validate(
    suite: Annotated[
        Literal["en50318", "seed", "all"], typer.Argument(help="Which reference cases to run.")
    ] = "all",
    report: Annotated[
        Path | None,
        typer.Option(
            "--report",
            metavar="FILE",
            help="Write values, figures and verdicts to this HTML file.",
            show_default=False,
        ),
    ] = None,
    *,
    certainty: CertaintyOption = None,
    once: Annotated[
        bool, typer.Option("--once", help="Run each case once, without saying how sure it is.")
    ] = False,
    json: JsonOption = False,
    quiet: QuietOption = False,
) -> None:
    """Compare the reference cases with published values.

    `en50318`: published ranges of the standard's cases. `seed`: the three conclusions of the
    paper that the method was founded on, on its worked example.

    Values come with how sure they are: their spread over eight starts within a span, or as many as
    --certainty says, and their error of discretisation. One that is nearer to a bound of its range
    than that is too close to tell, inside or outside, and decides nothing. --once saves the time.

    Exit code 3 means that a value is outside of a range, or a conclusion does not hold, that was
    read in a source (mark A). Values outside of ranges that are only remembered (mark C*) are
    shown as such and do not count.

    With --report, one page: values in their ranges, the paper's statements with the figures that
    show them, and for `all` the recorded evidence.

    `all` also lists the evidence that the tests of this version recorded: closed forms, orders of
    convergence, conservation, other programs. It is not computed again here; `make evidence` in the
    source does that, and docs/validation has every value with its tolerance and its reason.
    """
    from arcless import validate as cases

    with console.progress(quiet=quiet) as progress:
        rows = compute(
            lambda _cancel: cases.run(
                suite, progress, report=report, certainty=number_of(certainty, once=once)
            )
        )
    violated = sum(row.violates for row in rows)
    topics = cases.recorded() if suite == "all" else []
    if json:
        noted = [row for topic in topics for row in topic.as_rows()]
        console.data(console.json_text([dataclasses.asdict(row) for row in [*rows, *noted]]))
    else:
        from arcless.assess import decides
        from arcless.cli.terminal import tables

        verified = [row for row in rows if decides(row.mark)]
        inside = sum(row.verdict == cases.INSIDE for row in verified)
        close = sum(row.verdict.endswith(cases.CLOSE) for row in verified)
        sources = [cases.SEED_SOURCE] if suite != "en50318" else []
        console.show(
            tables.comparisons(rows),
            *tables.remarks(rows),
            *(f"Source of the conclusions: {source}.\n" for source in sources),
            f"{inside} of {len(verified)} values are inside the verified ranges"
            f"{f', {close} too close to tell' if close else ''}.\n",
            *(_evidence(topics) if topics else []),
            *([f"wrote {report}"] if report else []),
        )
    if violated:
        raise typer.Exit(NOT_MET)


def _evidence(topics: list["Topic"]) -> list[Any]:
    from arcless.cli.terminal import tables

    versions = " and ".join(sorted({topic.version for topic in topics}))
    verdicts = Counter(row.verdict for topic in topics for row in topic.rows)
    counts = ", ".join(f"{count} {verdict}" for verdict, count in verdicts.items())
    return [
        tables.evidence(topics),
        "used: largest part of a tolerance that a value uses up; faults: broken on purpose, and "
        f"noticed.\n{verdicts.total()} values: {counts}.\nRecorded by the tests of version "
        f"{versions}, not computed again here. docs/validation has each with its\nreference, its "
        "tolerance and its reason.\n",
    ]
