"""`arcless export` and `arcless stress`: what a saved run holds besides its assessment."""

from pathlib import Path
from typing import Annotated

import typer

from arcless.cli.arguments.scenario import JsonOption
from arcless.cli.commands.saved_results import ResultArgument
from arcless.cli.completion import names
from arcless.cli.terminal import console


def export(
    result: Annotated[
        Path,
        typer.Argument(
            metavar="RUN|STUDY",
            help="A run: the folder that `arcless run` wrote, or the result.nc in it. Or a study:"
            " its folder.",
            autocompletion=names.runs_and_studies,
            show_default=False,
        ),
    ],
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
    """Write a saved run, or the table of a study, for other programs.

    .csv and .parquet have contact channels over time, the filtered contact force among them, with
    units in the header; .mat has droppers and supports as well, and what supports carry over time;
    .xlsx also assessment and criteria. Recorded motion of the wires stays in result.nc, and a note
    says so. The table of a study goes to .csv and .xlsx, a row for each variant.
    """
    from arcless.results import open as open_result
    from arcless.results.export.files import check_target
    from arcless.results.kept_runs.places import study_folder

    check_target(to)
    if (folder := study_folder(result)) is not None:
        from arcless.study import open as open_study

        open_study(folder).export(to)
        console.data(f"wrote {to}")
        return
    run = open_result(result)
    run.export(to)
    if "motion_up" in run.latest:
        console.note(
            "the recorded motion of the wires is not exported: result.nc has it, a NetCDF file"
        )
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
        str | None,
        typer.Option(
            "--area",
            metavar="AREA",
            help='Area of the contact wire, such as "120 mm²"; a bare number is in mm². That of a '
            "full round section without it.",
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
    """Show the stress of the contact wire and count its cycles.

    Places are clamps of droppers and supports. Nothing is simulated. The stress is T/A and the
    bending by the forces of droppers, steady arms and strips at the place; cycles are counted by
    the rainflow method. There is no verdict: the Wöhler line of the wire is yours.
    """
    from arcless.cli.terminal.stress_tables import stress_tables
    from arcless.results import open as open_result

    found = open_result(result).wire_stress(
        area=_amount("--area", area, "m2", bare="mm²"),
        tension=_amount("--tension", tension, "N"),
        exponent=exponent,
    )
    for note in found.notes:
        console.warn(note)
    if json:
        console.data(console.json_text(found.to_dict()))
        return
    console.show(*stress_tables(found))


def _amount(option: str, text: str | None, unit: str, *, bare: str = "") -> float | None:
    """Return the amount of an option in SI; a number without a unit is in `bare`."""
    from arcless.errors import ModelError
    from arcless.units import show, to_si

    if text is None:
        return None
    try:
        float(text)
    except ValueError:
        bare = ""
    try:
        return to_si(f"{text} {bare}", unit)
    except ModelError as error:
        error.where, error.got = option, show(text)
        raise
