"""`arcless pantograph fit`: a measured frequency response as a pantograph."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer

from arcless.cli.arguments.amounts import amount
from arcless.cli.arguments.scenario import JsonOption, QuietOption
from arcless.cli.completion import names
from arcless.cli.terminal import console

if TYPE_CHECKING:
    from arcless.pantograph.receptance import Fit, MeasuredReceptance

app = typer.Typer(rich_markup_mode=None, add_completion=False, no_args_is_help=True)
# Masses of the list from which an order is chosen.
LISTED = 4


@app.callback()
def pantograph() -> None:
    """Make pantographs of what was measured."""


@app.command()
def fit(
    table: Annotated[
        Path,
        typer.Argument(
            metavar="TABLE",
            help="A CSV file with frequency [Hz], phase [deg], and receptance [m/N] or mobility, "
            "accelerance, dynamic_stiffness, impedance, apparent_mass.",
            autocompletion=names.tables,
            show_default=False,
        ),
    ],
    *,
    order: Annotated[
        int | None,
        typer.Option(
            "--order",
            metavar="NUMBER",
            help="Masses of the model; without it the errors of several are listed.",
            show_default=False,
        ),
    ] = None,
    damping: Annotated[
        Literal["joints", "full"],
        typer.Option("--damping", help="A damper in each joint, or a full damping matrix."),
    ] = "joints",
    out: Annotated[
        Path | None,
        typer.Option(
            "--out",
            metavar="NAME.yaml",
            help="Write the pantograph to this model file.",
            show_default=False,
        ),
    ] = None,
    report: Annotated[
        Path | None,
        typer.Option(
            "--report",
            metavar="FILE",
            help="Write one HTML page with data and model to this file.",
            show_default=False,
        ),
    ] = None,
    static_force: Annotated[
        str | None,
        typer.Option(
            "--static-force",
            metavar="FORCE",
            help='Static force of the pantograph, such as "70 N"; a scenario gives it if not.',
            show_default=False,
        ),
    ] = None,
    largest_misfit: Annotated[
        str | None,
        typer.Option(
            "--largest-misfit",
            metavar="PERCENT",
            help='Misfit that is accepted, root mean square; "10 %" if not given.',
            show_default=False,
        ),
    ] = None,
    overwrite: Annotated[
        bool, typer.Option("--overwrite", help="Replace a model file that exists.")
    ] = False,
    json: JsonOption = False,
    quiet: QuietOption = False,
) -> None:
    """Fit a chain of masses to a measured frequency response of the collector head.

    The model is stable and passive whatever was measured: masses above zero, springs and dampers
    not below. Without --order nothing is written: the list of orders says what each gains. With
    --out it becomes a pantograph that scenarios name, with the source, the misfit and ± in its
    file.
    """
    from arcless.pantograph import receptance

    _check(order, out, report, overwrite=overwrite)
    force = None if static_force is None else amount("--static-force", static_force, "N")
    limit = (
        receptance.LARGEST_MISFIT
        if largest_misfit is None
        else amount("--largest-misfit", largest_misfit, "1")
    )
    data = receptance.read(table)
    if order is None:
        _list(data, json=json, quiet=quiet)
        return
    found = receptance.fit(data, order, damping=damping, largest_misfit=limit)
    name = (out or table).stem
    text = receptance.text(found, name, static_force=force)
    receptance.pantograph(found, name, static_force=force)  # refuses before anything is written
    written = _write(found, name, text, out, report, quiet=quiet)
    if json:
        console.data(console.json_text(receptance.to_dict(found)))
        return
    from arcless.cli.terminal import receptance_tables

    console.show(*receptance_tables.blocks(found))
    for remark in [] if quiet else receptance.remarks(found):
        console.warn(remark)
    for path in written:
        console.data(f"wrote {path}")
    if out is not None:
        console.data(f"next: name it in a scenario: pantographs: [{{model: {out.name}}}]")


def _check(order: int | None, out: Path | None, report: Path | None, *, overwrite: bool) -> None:
    """Refuse files that could not be written, before anything is computed."""
    import os

    from arcless.errors import ModelError, OutputError
    from arcless.storage.endings import check_ending
    from arcless.storage.whole_files import check_writable

    if order is None and (out is not None or report is not None):
        raise ModelError("--order", got="none", expected="a number of masses to write",
                         hint="without --out and --report it lists the orders")  # fmt: skip
    if out is not None:
        check_ending(out, names.MODELS, "not a name of a model file")
        if os.path.lexists(out) and not overwrite:
            raise OutputError("the file exists", where=str(out), expected="a new name",
                              hint="choose another name, or add --overwrite")  # fmt: skip
        check_writable(out)
    if report is not None:
        check_writable(report)


def _list(data: "MeasuredReceptance", *, json: bool, quiet: bool) -> None:
    from arcless.pantograph import receptance

    with console.progress(quiet=quiet) as progress:
        fits = receptance.orders(data, LISTED, progress=progress)
    if json:
        console.data(console.json_text([receptance.to_dict(one) for one in fits]))
        return
    from arcless.cli.terminal import receptance_tables

    console.show(*receptance_tables.order_blocks(fits))
    console.data("next: choose one: --order NUMBER --out NAME.yaml")


def _write(
    found: "Fit", name: str, text: str, out: Path | None, report: Path | None, *, quiet: bool
) -> list[Path]:
    from arcless.pantograph import receptance
    from arcless.storage.whole_files import write_bytes

    written: list[Any] = []
    if report is not None:
        from arcless.report.receptance import page

        highest = min(found.chain.order + 1, receptance.MOST_MASSES)
        with console.progress(quiet=quiet) as progress:
            fits = receptance.orders(found.data, highest, progress=progress)
        page.write(found, fits, name, text, report)
        written.append(report)
    if out is not None:
        write_bytes(out, text.encode())
        written.append(out)
    return written
