"""`arcless export` and `arcless stress`: what a saved run holds besides its assessment."""

from pathlib import Path
from typing import Annotated

import typer

from arcless.cli.arguments.scenario import JsonOption
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
    units in the header; .mat has droppers and supports as well, and what supports carry over time;
    .xlsx also assessment and criteria.
    """
    from arcless.results import open as open_result
    from arcless.results.export.files import check_target

    check_target(to)
    open_result(result).export(to)
    console.data(f"wrote {to}")


def stress(
    result: ResultArgument,
    *,
    exponent: Annotated[
        float | None,
        typer.Option(
            "--exponent",
            metavar="M",
            help="Exponent of the Wöhler line of the wire, for the equivalent range; none without.",
            show_default=False,
        ),
    ] = None,
    area: Annotated[
        float | None,
        typer.Option(
            "--area",
            metavar="MM2",
            help="Area of the contact wire in mm²; that of a full round section without it.",
            show_default=False,
        ),
    ] = None,
    tension: Annotated[
        str | None,
        typer.Option(
            "--tension",
            metavar="FORCE",
            help='Tension of the contact wire, such as "11.2 kN"; that of the design without it.',
            show_default=False,
        ),
    ] = None,
    json: JsonOption = False,
) -> None:
    """Tell the stress of the contact wire at clamps and supports, and its cycles.

    Nothing is simulated. The stress is T/A and the bending by the forces of droppers, steady arms
    and strips at the place; cycles are counted by the rainflow method. There is no verdict: the
    Wöhler line of the wire is yours.
    """
    from arcless.cli.terminal.stress_tables import stress_tables
    from arcless.results import open as open_result
    from arcless.units import to_si

    force = None
    if tension is not None:
        from arcless.errors import ModelError

        try:
            force = to_si(tension, "N")
        except ModelError as error:
            error.where = "--tension"
            raise
    found = open_result(result).wire_stress(
        area=None if area is None else 1e-6 * area, tension=force, exponent=exponent
    )
    if json:
        console.data(console.json_text(found.to_dict()))
        return
    console.show(*stress_tables(found))
