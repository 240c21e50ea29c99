"""A comparison as tables, for a terminal or a text file."""

from typing import TYPE_CHECKING

from rich.table import Table
from rich.text import Text

from arcless.cli.terminal.tables import table
from arcless.comparison import cells
from arcless.display.numbers import number

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


def placement(compared: "Comparison") -> list[Table]:
    """Set how measurements lie on the line of the first run."""
    placed = [(name, one.placed) for name, one in zip(compared.names, compared.sides, strict=True)
              if one.placed is not None]  # fmt: skip
    if not placed:
        return []
    made = table("Positions of measurements", "measurement", "placed by")
    for heading in ("offset", "drift", "correlation", "next best"):
        made.add_column(heading, justify="right")
    for name, one in placed:
        several = len(one.alignments) > 1
        for pantograph, by in zip(one.measurement.pantographs, one.alignments, strict=True):
            whose = f"{name}, {pantograph.name}" if several else name
            made.add_row(whose, *cells.alignment(by))
    return [made]


def bands(compared: "Comparison") -> list[Table]:
    """Set the standard deviations of the bands side by side; third octaves are on the page."""
    if not compared.bands:
        return []
    first, *others = compared.names
    made = table("Bands", "band")
    for heading in (f"σ {first}", *(f"σ {name}" for name in others)):
        made.add_column(heading, justify="right")
    for name in others:
        made.add_column(f"{name} less {first}" if len(others) > 1 else "difference",
                        justify="right")  # fmt: skip
        made.add_column("correlation", justify="right")
    several = len(compared.pantographs) > 1
    for one in compared.bands:
        if one.kind != "filtered":
            continue
        row = [f"{one.label}, {one.pantograph}" if several else one.label]
        row += [cells.amount(value, "N") for value in one.deviations_N]
        for run in range(1, len(compared.names)):
            row += [cells.band_difference(one, run), number(one.correlations[run], 3)]
        made.add_row(*row)
    return [made]


def acceptance(compared: "Comparison") -> list[Table]:
    """Set each run against each measurement, with the tolerances that are remembered."""
    found = []
    for run, measured in dict.fromkeys((a.run, a.measurement) for a in compared.acceptance):
        names = compared.names[run], compared.names[measured]
        title = f"{names[0]} against {names[1]}: tolerances from memory (mark C) decide nothing"
        made = table(title, "quantity", "unit")
        for heading in ("simulated", "measured", "less measured", "tolerance"):
            made.add_column(heading, justify="right")
        made.add_column("within")
        several = len(compared.pantographs) > 1
        for one in compared.acceptance:
            if (one.run, one.measurement) == (run, measured):
                whose = f", {one.pantograph}" if several and one.pantograph else ""
                made.add_row(f"{one.label}{whose}", one.unit, *cells.accepted(one))
        found.append(made)
    return found
