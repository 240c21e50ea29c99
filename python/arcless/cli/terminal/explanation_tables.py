"""An explanation of σ as tables, for a terminal or a text file."""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from rich.table import Table

from arcless.cli.terminal.tables import table
from arcless.explanation import tables as rows

if TYPE_CHECKING:
    from rich.console import RenderableType

    from arcless.explanation import Explanation, PantographExplanation

_MODES = ("Hz", "band, Hz", "damping ratio", "share that does not repeat, %", "all in the band, %")
_PLACES = ("position, m", "span", "force, N", "deviation, N")


def blocks(found: "Explanation") -> "Iterator[RenderableType]":
    """Yield sentences and tables of an explanation."""
    yield "".join(f"{text}\n" for text in found.sentences)
    for one in found.pantographs:
        of = f", {one.name}" if len(found.pantographs) > 1 else ""
        yield _filled(f"Parts of the variance σ²{of}", rows.GROUPS, rows.group_rows(one))
        if one.modes:
            yield _filled(f"Natural modes of the pantograph{of}", ("mode", *_MODES),
                          rows.mode_rows(one))  # fmt: skip
        yield _by_span(one, f"σ by span{of}")
        yield _places(f"Largest deviations from F_m{of}", rows.place_rows(one.worst))
        what = f"Largest deviations from what repeats{of}"
        yield _places(what, rows.place_rows(one.irregular))
    if found.sensitivities is not None:
        yield _sensitivities(found)
    notes = [*found.notes, *(found.sensitivities.left_out if found.sensitivities else ())]
    if notes:
        yield "".join(f"Note: {text}.\n" for text in notes)


def _filled(title: str, columns: Sequence[str], cells: Sequence[Sequence[str]]) -> Table:
    made = table(title, *columns, numbers=columns[1:])
    for row in cells:
        made.add_row(*row)
    return made


def _by_span(one: "PantographExplanation", title: str) -> Table:
    made = table(title, "span", "from, m", "to, m", "σ, N", numbers=("from, m", "to, m", "σ, N"))
    for span in one.by_span:
        made.add_row(
            str(span.span), f"{span.begin_m:.1f}", f"{span.end_m:.1f}", f"{span.std_N:.1f}"
        )
    return made


def _places(title: str, cells: Sequence[Sequence[str]]) -> Table:
    changed = any(row[5] for row in cells)
    made = table(title, *_PLACES, "where", *(["not as designed"] if changed else []),
                 numbers=_PLACES)  # fmt: skip
    for row in cells:
        made.add_row(*row[: None if changed else 5])
    return made


def _sensitivities(found: "Explanation") -> Table:
    known = found.sensitivities
    assert known is not None
    numbers = ("% of σ per %", "±")
    made = table(
        f"Sensitivity of σ, central differences over ± {known.step_percent:g} %",
        "parameter", "pantograph", *numbers, "remark", numbers=numbers,
    )  # fmt: skip
    for row in rows.sensitivity_rows(known):
        made.add_row(*row)
    return made
