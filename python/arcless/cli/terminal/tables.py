"""Numbers as tables, for a terminal or a text file."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from rich.box import SIMPLE_HEAD
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from arcless.assess import (
    MET,
    NOT_JUDGED,
    NOT_MET,
    NOT_MET_UNVERIFIED,
    TOO_CLOSE,
    allowance,
    uncertainty_of,
    verdict_of,
)

if TYPE_CHECKING:
    from arcless.validate import Row, Topic

# key of the assessment, label, unit, digits after the point
_STATISTICS = (
    ("mean_force_N", "mean force", "N", 1),
    ("std_force_N", "standard deviation σ", "N", 1),
    ("std_force_0_5Hz_N", "σ, 0–5 Hz", "N", 1),
    ("std_force_5_20Hz_N", "σ, 5–20 Hz", "N", 1),
    ("statistical_max_N", "statistical maximum Fm + 3σ", "N", 1),
    ("statistical_min_N", "statistical minimum Fm − 3σ", "N", 1),
    ("max_force_N", "maximum force", "N", 1),
    ("min_force_N", "minimum force", "N", 1),
    ("unfiltered_max_force_N", "maximum force, unfiltered", "N", 1),
    ("unfiltered_min_force_N", "minimum force, unfiltered", "N", 1),
    ("NQ_percent", "arcing NQ, losses above 5 ms", "%", 2),
    ("contact_loss_percent", "loss of contact, all losses", "%", 2),
    ("longest_loss_s", "longest loss of contact", "s", 3),
    ("max_gap_mm", "largest gap", "mm", 1),
    ("contact_point_range_mm", "range of contact-point height", "mm", 1),
    ("max_lateral_position_mm", "largest lateral position of the wire", "mm", 0),
)
_WEAR = (
    ("wear_mechanical_mm3_km", "wear by friction", "mm³/km", 3),
    ("wear_joule_mm3_km", "wear by the current through the contact", "mm³/km", 3),
    ("wear_arc_mm3_km", "wear by arcs", "mm³/km", 3),
    ("wear_total_mm3_km", "wear in sum", "mm³/km", 3),
)
_RUN = (
    ("max_uplift_at_support_mm", "maximum uplift at a support", "mm", 1),
    ("min_dropper_force_N", "minimum dropper force", "N", 1),
    ("slack_droppers_max", "most droppers slack at once", "", 0),
    ("energy_residual_relative", "energy ledger, relative residual", "", -1),
    ("steps", "time steps", "", 0),
    ("wall_time_s", "wall time of the time steps", "s", 2),
    ("real_time_factor", "simulated over wall time", "", 1),
)
_STYLES = {
    "inside": "green",
    "outside": "bold red",
    "outside (unverified)": "yellow",
    "inside, too close to tell": "yellow",
    "outside, too close to tell": "yellow",
    MET: "green",
    NOT_MET: "bold red",
    NOT_MET_UNVERIFIED: "yellow",
    TOO_CLOSE: "yellow",
    NOT_JUDGED: "dim",
}
_RELATIONS = {"<=": "≤", ">=": "≥", ">": ">"}


def table(title: str, *columns: str, numbers: Sequence[str] = (), lines: bool = False) -> Table:
    """Make an empty table; the columns named in `numbers` are set flush right."""
    made = Table(
        title=title, box=SIMPLE_HEAD, title_justify="left", title_style="bold", show_lines=lines
    )
    for column in columns:
        made.add_column(column, justify="right" if column in numbers else "left")
    return made


def number(value: float | None, digits: int) -> str:
    """Print a number with so many digits after the point; -1 means one significant digit."""
    if value is None:
        return "–"
    return f"{value:.1e}" if digits < 0 else f"{value:.{digits}f}"


def statistics(assessment: dict[str, Any], published: "Sequence[Row]" = ()) -> Table:
    """Set the numbers of a run side by side with the ranges published for it, if any."""
    names = [pantograph["name"] for pantograph in assessment["pantographs"]]
    ranges = {row.key: row for row in published}
    extra = ("published range", "verdict") if ranges else ()
    title = f"{assessment['scenario']} at {assessment['speed_m_s'] * 3.6:.0f} km/h"
    made = table(title, "quantity", "unit", *names, *extra, numbers=names)
    pantographs = assessment["pantographs"]
    wear = _WEAR if _WEAR[0][0] in pantographs[0] else ()
    columns = _columns(((_STATISTICS + wear, pantographs), (_RUN, [assessment])), len(names))
    for keys in (_STATISTICS + wear, _RUN):
        for key, label, unit, _ in keys:
            values = [column[key] for column in columns]
            made.add_row(label, unit, *values, *_published(ranges.get(key), bool(ranges)))
        made.add_section()
    return made


def _columns(groups: Any, count: int) -> list[dict[str, str]]:
    """Return the numbers of each column by key, with how sure they are one below the other."""
    columns: list[dict[str, str]] = []
    for index in range(count):
        numbers: dict[str, tuple[str, str]] = {}
        for keys, sources in groups:
            source = sources[index] if index < len(sources) else None
            sure = {} if source is None else source.get("certainty") or {}
            for key, _, _, digits in keys:
                value = "" if source is None else number(source.get(key), digits)
                numbers[key] = value, _digits(uncertainty_of(sure.get(key)), digits)
        columns.append(aligned(numbers))
    return columns


def aligned(numbers: dict[str, tuple[str, str]]) -> dict[str, str]:
    """Return values with how sure they are, by key, so that what follows ± stands in a column."""
    width = max((len(sure) for _, sure in numbers.values()), default=0)
    if not width:
        return {key: value for key, (value, _) in numbers.items()}
    return {
        key: f"{value} ± {sure:>{width}}" if sure else f"{value}{' ' * (width + 3)}"
        for key, (value, sure) in numbers.items()
    }


def _digits(value: float | None, digits: int) -> str:
    return "" if value is None else number(value, digits)


def criteria(assessment: dict[str, Any]) -> Table:
    """Set out the criteria with limit, verdict and source."""
    made = table(
        f"Criteria, {assessment['supply']}",
        *("criterion", "for", "value", "limit", "unit", "verdict", "source (mark)"),
        numbers=("value", "limit"),
    )
    numbers = {
        str(row): (
            number(item["value"], _of(item)),
            _digits(uncertainty_of(item.get("certainty")), _of(item)),
        )
        for row, item in enumerate(assessment["criteria"])
    }
    values = aligned(numbers)
    for row, item in enumerate(assessment["criteria"]):
        made.add_row(
            item["title"],
            item["pantograph"] or "run",
            values[str(row)],
            f"{_RELATIONS[item['relation']]} {number(item['limit'], _of(item))}{allowance(item)}",
            item["unit"].replace("1", ""),
            _verdict(verdict_of(item)),
            f"{item['source']} ({item['mark']})",
        )
    return made


def notes(assessment: dict[str, Any]) -> list[str]:
    """Return remarks about the numbers, a line each."""
    if not assessment["notes"]:
        return []
    return ["Notes:\n" + "".join(f"- {note}\n" for note in assessment["notes"])]


def _of(item: dict[str, Any]) -> int:
    """Return the digits after the point of a criterion's numbers."""
    return 3 if item["unit"] == "1" else 2


def certainty(assessment: dict[str, Any]) -> list[str]:
    """Say how sure the numbers are, and why; nothing where nobody asked."""
    from arcless.assess.certainty_words import explained

    method = assessment.get("certainty_method")
    close = [f"{item['title']}: {item['reason']}." for item in assessment["criteria"]
             if verdict_of(item) == TOO_CLOSE]  # fmt: skip
    told = [] if method is None else [" ".join(explained(method))]
    return [f"{text}\n" for text in ["\n".join(close), *told] if text]


def comparisons(rows: "Sequence[Row]") -> Table:
    """Set values side by side with what is published."""
    made = table(
        "Reference cases", "case", "quantity", "unit", "value", "published", "verdict",
        numbers=("value",),
    )  # fmt: skip
    case = None
    values = aligned(
        {
            str(place): (number(row.value, row.digits), _digits(row.uncertainty, row.digits))
            for place, row in enumerate(rows)
        }
    )
    for place, row in enumerate(rows):
        if case not in (None, row.case):
            made.add_section()
        made.add_row(
            row.case if row.case != case else "",
            Text.assemble(row.quantity, (f"\n{row.note}", "dim")) if row.note else row.quantity,
            row.unit,
            values[str(place)],
            *_published(row, True),
        )
        case = row.case
    return made


def evidence(topics: "Sequence[Topic]") -> Table:
    """Set out the recorded evidence, a line for each topic."""
    from arcless.validate.evidence import GROUPS

    counts = ("values", "inside", "used", "faults")
    made = table("Evidence recorded by the tests", "topic", *counts, numbers=counts)
    group = None
    for topic in topics:
        if topic.group != group:
            made.add_section()
            made.add_row(Text(GROUPS[topic.group], style="bold"))
            group = topic.group
        used = "" if topic.most_used is None else f"{100 * topic.most_used:.0f} %"
        numbers = (str(len(topic.rows)), str(topic.inside), used, str(len(topic.faults)))
        made.add_row(topic.title, *numbers)
    return made


def remarks(rows: "Sequence[Row]") -> list[Padding]:
    """Say for each case what was checked and under which assumption, where rows say so."""
    cases = {row.case: row for row in rows if row.checked}
    return [
        Padding(
            Text.assemble(
                (case, "bold"), f"\nChecked: {row.checked}\nAssumption: {row.assumption}"
            ),
            (0, 0, 1, 2),
        )
        for case, row in cases.items()
    ]


def _published(row: "Row | None", wanted: bool) -> list[Text | str]:
    if not wanted:
        return []
    if row is None:
        return ["", ""]
    return [f"{row.limit} ({row.mark})", _verdict(row.verdict)]


def _verdict(verdict: str) -> Text:
    return Text(verdict, style=_STYLES[verdict])
