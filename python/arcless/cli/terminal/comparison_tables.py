"""A comparison as tables, for a terminal or a text file."""

from typing import TYPE_CHECKING

from rich.table import Table
from rich.text import Text

from arcless.cli.terminal.tables import table
from arcless.comparison import cells

if TYPE_CHECKING:
    from arcless.comparison import Comparison

# Changed fields that are printed; all of them are in the JSON.
MOST_FIELDS = 40
_STYLES = {"met": "green", "not met": "bold red"}


def fields(compared: "Comparison") -> Table:
    """Set the fields in which the scenarios differ side by side."""
    made = table("Changed fields", "field", *compared.names)
    for one in compared.fields[:MOST_FIELDS]:
        made.add_row(one.path, *(cells.NONE if value is None else value for value in one.values))
    left = len(compared.fields) - MOST_FIELDS
    if left > 0:
        made.add_row(f"{left} more: --json has all of them", *[""] * len(compared.names))
    return made


def numbers(compared: "Comparison") -> Table:
    """Set the numbers of the runs side by side, each with its difference to the first."""
    first, *others = compared.names
    headings = [first]
    for name in others:
        headings += [name, f"less {first}" if len(others) == 1 else "difference"]
    made = table("Numbers", "quantity", "unit")
    for heading in headings:  # two of them may be the same word
        made.add_column(heading, justify="right")
    said: str | None = ""
    several = len(compared.pantographs) > 1
    for one in compared.indicators:
        if one.pantograph != said:
            made.add_section()
            if several and one.pantograph is not None:
                made.add_row(one.pantograph, style="bold")
            said = one.pantograph
        row = [cells.value(one, 0)]
        for run in range(1, len(compared.names)):
            row += [cells.value(one, run), cells.difference(one, run)]
        made.add_row(one.label, one.unit, *row)
    return made


def verdicts(compared: "Comparison") -> Table:
    """Set the verdicts on each criterion side by side."""
    made = table("Criteria", "criterion", *compared.names)
    several = len(compared.pantographs) > 1
    for one in compared.criteria:
        of = f", {one.pantograph}" if several and one.pantograph else ""
        words = [word or cells.NONE for word in one.verdicts]
        made.add_row(f"{one.title}{of}", *(Text(word, _STYLES.get(word, "")) for word in words))
    return made
