"""A comparison as tables, for a terminal or a text file."""

from collections.abc import Sequence
from textwrap import wrap
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
# Characters that the heads of all runs have side by side: of 80 in a line they leave 30 to the
# quantities. A head has no fewer than a difference with its percentage needs, "+16.3 (+30.5 %)".
HEADS, LEAST_HEAD = 40, 15
_STYLES = {"met": "green", "not met": "bold red"}


def runs(compared: "Comparison") -> Table:
    """Set what each run is, and where it was assessed, one below the other."""
    made = _table("Runs", "run", "scenario", "speed", "section", "limits that decide")
    for name, side in zip(compared.names, compared.sides, strict=True):
        scenario = "measurement" if side.result is None else side.result.scenario.name
        words, state = cells.decided(side.assessment)
        made.add_row(
            *map(_wrapped, (name, scenario)),
            cells.speed(side.assessment),
            cells.section(side.assessment),
            Text(words, "green" if state == "met" else "bold red"),
        )
    return made


def origins(compared: "Comparison") -> str:
    """Return a line for each run: its whole name where that is no head, its file, the digest."""
    lines = []
    sides = zip(compared.names, compared.full_names, compared.files, compared.digests, strict=True)
    for name, whole, file, digest in sides:
        told = (cells.unsaid(whole, name, file), cells.origin(file, digest))
        lines.append(f"{name}: {', '.join(filter(None, told))}")
    return "\n".join([*lines, ""])


def fields(compared: "Comparison") -> Table:
    """Set the fields in which the scenarios differ side by side."""
    made = _table("Changed fields", "field", heads=compared.names)
    for one in compared.fields[:MOST_FIELDS]:
        made.add_row(one.path, *(cells.NONE if value is None else value for value in one.values))
    left = len(compared.fields) - MOST_FIELDS
    if left > 0:
        made.add_row(f"{left} more: --json has all of them", *[""] * len(compared.names))
    return made


def numbers(compared: "Comparison") -> Table:
    """Set the numbers of the runs side by side, the difference to the first below each other."""
    made = _table("Numbers", "quantity", "unit", heads=compared.names, right=True)
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
            below = [] if one.differences[run] is None else [cells.difference(one, run)]
            row.append("\n".join([cells.value(one, run), *below]))
        made.add_row(one.label, one.unit, *row)
    return made


def verdicts(compared: "Comparison") -> Table:
    """Set value and limit of each criterion side by side, the verdict below."""
    made = _table("Criteria: value / limit", "criterion", "unit", heads=compared.names, right=True)
    several = len(compared.pantographs) > 1
    for one in compared.criteria:
        of = f", {one.pantograph}" if several and one.pantograph else ""
        row = []
        for run, word in enumerate(one.verdicts):
            style = _STYLES.get(word or "", "")
            row.append(Text.assemble(cells.limit(one, run), "\n", (word or cells.NONE, style)))
        made.add_row(f"{one.title}{of}", one.unit, *row)
    return made


def _table(title: str, *columns: str, heads: Sequence[str] = (), right: bool = False) -> Table:
    """Make a table with columns that are alike at the end; words are wrapped, never cut.

    `heads` are those of the columns at the end.
    """
    made = table(title)
    for column in columns:
        made.add_column(column, overflow="fold")
    for head in heads:  # two of them may be the same word
        made.add_column(_wrapped(head, len(heads)), justify="right" if right else "left",
                        overflow="fold")  # fmt: skip
    return made


def _wrapped(name: str, beside: int = 2) -> str:
    """Return a name in lines of its share of the heads, broken at blanks and hyphens first."""
    return "\n".join(wrap(name, max(HEADS // beside, LEAST_HEAD)))


def placement(compared: "Comparison") -> list[Table]:
    """Set how measurements lie on the line of the first run."""
    placed = [(name, one.placed) for name, one in zip(compared.names, compared.sides, strict=True)
              if one.placed is not None]  # fmt: skip
    if not placed:
        return []
    on = "" if compared.placed_on is None else f", placed on {compared.placed_on}"
    made = _table(f"Positions of measurements{on}", "measurement", "placed by",
                  heads=("offset", "drift", "correlation", "next best"), right=True)  # fmt: skip
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
    made = _table("Bands: σ, correlation r with the first", "band",
                  heads=compared.names, right=True)  # fmt: skip
    several = len(compared.pantographs) > 1
    for one in compared.bands:
        if one.kind != "filtered":
            continue
        row = [f"{one.label}, {one.pantograph}" if several else one.label]
        for run, value in enumerate(one.deviations_N):
            lines = [cells.amount(value, "N")]
            if run and one.differences_N[run] is not None:
                lines += [cells.band_difference(one, run), f"r {number(one.correlations[run], 3)}"]
            row.append("\n".join(lines))
        made.add_row(*row)
    return [made]


def acceptance(compared: "Comparison") -> list[Table]:
    """Set each run against each measurement, with the tolerances that are remembered."""
    found = []
    for run, by in dict.fromkeys((a.run, a.measurement) for a in compared.acceptance):
        names = compared.names[run], compared.names[by]
        title = f"{names[0]} against {names[1]}: tolerances from memory (mark C) decide nothing"
        heads = ("simulated", "measured", "difference", "tolerance", "within")
        made = _table(title, "quantity, unit", heads=heads, right=True)
        several = len(compared.pantographs) > 1
        for one in compared.acceptance:
            if (one.run, one.measurement) == (run, by):
                whose = f", {one.pantograph}" if several and one.pantograph else ""
                simulated, measured, less, *judged = cells.accepted(one)
                less = less.replace(" (", "\n(")
                unit = f", {one.unit}" if one.unit else ""
                made.add_row(f"{one.label}{whose}{unit}", simulated, measured, less, *judged)
        found.append(made)
    return found
