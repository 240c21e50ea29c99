"""Fits of a receptance as tables, for a terminal or a text file."""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from rich.table import Table

from arcless.cli.terminal.tables import table
from arcless.pantograph.receptance import tables as rows
from arcless.pantograph.receptance.words import significant

if TYPE_CHECKING:
    from rich.console import RenderableType

    from arcless.pantograph.receptance import Fit


def blocks(fit: "Fit") -> "Iterator[RenderableType]":
    """Yield what was found, with ±."""
    size, place = fit.largest
    yield (
        f"{fit.chain.order} masses, damping {rows.DAMPING_WORDS[fit.chain.kind]}: misfit"
        f" {significant(100 * fit.misfit, 3)} % (root mean square), largest"
        f" {significant(100 * size, 3)} % at {place:g} Hz. ± covers 95 %.\n"
    )
    yield _filled("Modes, head free", rows.MODES, rows.mode_rows(fit))
    yield _filled("Masses from base to head", rows.parameter_titles(fit), rows.parameter_rows(fit))


def order_blocks(fits: "Sequence[Fit]") -> "Iterator[RenderableType]":
    """Yield the list by which an order is chosen."""
    yield _filled("Orders", rows.ORDERS, rows.order_rows(fits), texts=2)
    yield f"{rows.ORDERS_READ}\n"


def _filled(
    title: str, columns: Sequence[str], cells: Sequence[Sequence[str]], texts: int = 1
) -> Table:
    made = table(title, *columns, numbers=columns[texts:])
    for row in cells:
        made.add_row(*row)
    return made
