"""The line at rest as a card for notebooks, in the words of its page."""

from typing import Any

from arcless.display import cards
from arcless.equilibrium.initial_configuration import InitialConfiguration
from arcless.figures.statics import LineData
from arcless.report.statics_page import as_built_rows, dropper_table, main_numbers, support_table


def card(found: InitialConfiguration) -> str:
    """Return the main numbers as HTML, and folded away droppers and supports."""
    titles = ("quantity", "value", "unit")
    numbers = cards.table(titles, [*main_numbers(found), *_as_built(found)], numbers=("value",))
    folded = [
        cards.folded(title, _table(of))
        for title, of in (
            ("Droppers", dropper_table(found)),
            ("Supports", support_table(LineData(found))),
        )
        if of
    ]
    places = found.equilibrium.support_places()
    about = f"{len(places) - 1} spans, {places[-1] - places[0]:.0f} m"
    return cards.card(f"{found.scenario.line.name} at rest", numbers, *folded, about=about)


def _as_built(found: InitialConfiguration) -> list[tuple[str, str, str]]:
    return [(f"as built: {label}", value, unit) for label, value, unit in as_built_rows(found)]


def _table(of: dict[str, Any]) -> str:
    """Return a table of the page; its first columns are texts."""
    return cards.table(of["titles"], of["rows"], numbers=of["titles"][of["texts"] :])
