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
    RELATION_SIGNS,
    TOO_CLOSE,
    allowance,
    decimals_of,
    shown_verdict,
    uncertainty_of,
    verdict_of,
)
from arcless.assess.quantities import (
    OF_COMPUTATION,
    OF_LINE,
    OF_PANTOGRAPH,
    QUANTITIES,
    WEAR,
    label_of,
)
from arcless.display import numbers as texts

if TYPE_CHECKING:
    from arcless.validate import Row, Topic

# Numbers of the whole run, by their keys in the assessment.
_RUN = [*OF_LINE, *(key for key in OF_COMPUTATION if key != "setup_time_s")]
_NOTHING = "–"
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
    if value is None or digits >= 0:
        return texts.number(value, digits)
    return f"{value:.1e}"


def statistics(assessment: dict[str, Any], published: "Sequence[Row]" = ()) -> Table:
    """Set the numbers of a run side by side with the ranges published for it, if any."""
    names = [pantograph["name"] for pantograph in assessment["pantographs"]]
    ranges = {row.key: row for row in published}
    extra = ("published range", "verdict") if ranges else ()
    speed = f"{assessment['speed_m_s'] * 3.6:.0f} km/h"
    title = f"{assessment['scenario']} at {speed}{_stopped(assessment)}"
    made = table(title, "quantity", "unit", *names, *extra, numbers=names)
    pantographs = assessment["pantographs"]
    worn = next(iter(WEAR)) in pantographs[0]
    of_each = [*OF_PANTOGRAPH, *(WEAR if worn else ())]
    columns = _columns(((of_each, pantographs), (_RUN, [assessment])), len(names))
    measured = "measurement" in assessment
    for keys in (of_each, _RUN):
        for key in keys:
            values = [column[key] for column in columns]
            if measured and all(value in ("", _NOTHING) for value in values):
                continue  # no column of the file has it
            label = label_of(
                key,
                low_pass_Hz=assessment["low_pass_Hz"],
                band_split_Hz=assessment["band_split_Hz"],
            )
            shown = _published(ranges.get(key), bool(ranges))
            made.add_row(label, QUANTITIES[key].unit, *values, *shown)
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
            for key in keys:
                digits = QUANTITIES[key].decimals
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
        f"Criteria, {assessment['supply']}{_stopped(assessment)}",
        *("criterion", "for", "value", "limit", "unit", "verdict", "source (mark)"),
        numbers=("value", "limit"),
    )
    numbers = {
        str(row): (
            number(item["value"], decimals_of(item)),
            _digits(uncertainty_of(item.get("certainty")), decimals_of(item)),
        )
        for row, item in enumerate(assessment["criteria"])
    }
    values = aligned(numbers)
    for row, item in enumerate(assessment["criteria"]):
        made.add_row(
            item["title"],
            item["pantograph"] or "run",
            values[str(row)],
            _limit(item),
            item["unit"].replace("1", ""),
            Text(shown_verdict(item), style=_STYLES[verdict_of(item)]),
            f"{item['source']} ({item['mark']})",
        )
    return made


def notes(assessment: dict[str, Any]) -> list[str]:
    """Return remarks about the numbers, a line each."""
    return listed("Notes", assessment["notes"])


def listed(title: str, lines: Sequence[str]) -> list[str]:
    """Return lines below a title; nothing where there are none."""
    return [f"{title}:\n" + "".join(f"- {line}\n" for line in lines)] if lines else []


def verdict(assessment: dict[str, Any]) -> str:
    """Return the verdict over all criteria, as the report has it."""
    return f"{assessment['verdict']}.\n"


def summary(
    assessment: dict[str, Any], warnings: Sequence[str], published: "Sequence[Row]" = ()
) -> list[Table | str]:
    """Return all that is told of an assessment: numbers, criteria, notes, and warnings below."""
    return [
        statistics(assessment, published),
        criteria(assessment),
        verdict(assessment),
        *certainty(assessment),
        *notes(assessment),
        *listed("Warnings", warnings),
    ]


def _stopped(assessment: dict[str, Any]) -> str:
    """Say of a run that stopped early that it did: numbers and verdicts are those of a part."""
    stop = assessment.get("stopped_m")
    return "" if stop is None else f", of the part run up to {stop:.1f} m: stopped early"


def _limit(item: dict[str, Any]) -> str:
    if item["limit"] is None:
        return _NOTHING
    limit = number(item["limit"], decimals_of(item))
    return f"{RELATION_SIGNS[item['relation']]} {limit}{allowance(item)}"


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
