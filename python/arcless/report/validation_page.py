"""Reference cases as one page: values in ranges, the paper's conclusions, recorded evidence."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path

from arcless.assess import decides, telling_decimals
from arcless.display.numbers import number, pair, real_minus
from arcless.figures.description import Figure
from arcless.figures.run import RunData
from arcless.figures.validation import (
    Compared,
    force_intervals,
    force_over_time,
    gap_over_time,
    overview,
    state_of,
)
from arcless.model import MARKS as MEANINGS
from arcless.report.summary import Verdict
from arcless.report.template import render
from arcless.report.validation_subject import Evidence, Subject
from arcless.storage.whole_files import write_bytes

# Length of a bar in the drawing, and parts of it below and above the range.
LENGTH, BEYOND = 1000.0, 0.25
GAPS_ABOVE = 300 / 3.6  # m/s: the paper shows gaps at 340 and 360 km/h only


@dataclass(frozen=True)
class RangeBar:
    """A value in its range, from 0 to `LENGTH`: the band, the value, ± (None where not known)."""

    band: tuple[float, float]
    value: float
    sure: tuple[float, float] | None


@dataclass(frozen=True)
class Entry:
    """A comparison as text, and as a bar where it has a value and a range."""

    quantity: str
    value: str
    unit: str
    limit: str
    mark: str
    verdict: str
    state: str
    note: str
    words: str
    bar: RangeBar | None


def write(subject: Subject, path: Path) -> None:
    """Write the page: one HTML file that opens without a network.

    Raises
    ------
    OutputError
        The file cannot be written; nothing half-written stays behind.
    """
    write_bytes(path, html(subject, path.name).encode())


def html(subject: Subject, name: str = "report.html") -> str:
    """Return the page as one HTML text; `name` is that of its file."""
    drawn = _figures(subject)
    used = {row.mark for row in subject.rows}
    contents = [("summary", "Summary")]
    contents += [("ranges", "Published ranges")] if subject.cases else []
    contents += [("paper", "Founding paper")] if subject.conclusions else []
    contents += [("evidence", "Recorded evidence")] if subject.evidence else []
    once = "" if subject.certainty or not subject.cases else " --once"
    starts = "once" if subject.certainty is None else f"from {subject.certainty} starts"
    return render(
        "validation.html",
        drawn,
        suite=subject.suite,
        identity=_identity(subject, starts),
        verdict=verdict(subject.rows),
        parts=_parts(subject),
        cases=[(one, _count(one.rows), [entry(row) for row in one.rows]) for one in subject.cases],
        conclusions=[(one, [entry(row) for row in one.rows]) for one in subject.conclusions],
        evidence=_evidence(subject.evidence),
        evidence_words=_evidence_words(subject.evidence),
        versions=" and ".join(sorted({one.version for one in subject.evidence})),
        source=subject.source,
        marks={mark: meaning for mark, meaning in MEANINGS.items() if mark in used},
        contents=contents,
        command=f"arcless validate {subject.suite}{once} --report {name}",
        certain=subject.certainty is not None,
    )


def verdict(rows: Sequence[Compared]) -> Verdict:
    """Return the headline over all values whose range decides."""
    counted = [row for row in rows if decides(row.mark)]
    outside = [row for row in counted if state_of(row.verdict) == "not_met"]
    close = [row for row in counted if state_of(row.verdict) == "open"]
    other = len(rows) - len(counted)
    inside = len(counted) - len(outside) - len(close)
    words = f"{inside} of {len(counted)} values are inside the verified ranges"
    rest = [f"{len(close)} too close to tell"] if close else []
    if outside:
        rest.insert(0, f"{inside} inside")
        words = f"Outside its verified range: {len(outside)} of {len(counted)} values"
    others = "; ".join(rest)
    items = [_item(row) for row in (*outside, *close)]
    if other:
        held = sum(state_of(row.verdict) == "met" for row in rows if not decides(row.mark))
        items.append(
            f"{held} of {other} values are inside ranges that are from memory, not checked in the"
            " standard; these do not count."
        )
    if outside:
        return Verdict("missed", "✘", words, others, items)
    return Verdict("open" if close else "met", "≈" if close else "✔", words, others, items)


def entry(row: Compared) -> Entry:
    """Return a comparison as a page shows it."""
    value = _shown(row)
    remembered = "" if decides(row.mark) else ", from memory"
    allowed = f"range {row.limit} {row.unit}{remembered}"
    words = f"{row.quantity}: {value} {row.unit}, {allowed}: {row.verdict}"
    return Entry(
        row.quantity, value, row.unit, real_minus(row.limit), row.mark, row.verdict,
        state_of(row.verdict).replace("_", "-"), row.note, words, _bar(row),
    )  # fmt: skip


def _shown(row: Compared) -> str:
    """Return a value with ±, to so many decimals that it is told apart from a bound near it."""
    decimals = telling_decimals(row.value, (row.low, row.high), row.digits)
    return pair(row.value, row.uncertainty, decimals)


def _item(row: Compared) -> str:
    unit = f" {row.unit}" if row.unit else ""
    return (
        f"{row.case}, {row.quantity}: {_shown(row)}{unit}, range {row.limit}{unit} ({row.verdict},"
        f" mark {row.mark})"
    )


def _bar(row: Compared) -> RangeBar | None:
    """Return a value in a range with two bounds; a range of one number is a line in the middle."""
    if row.value is None or row.low is None or row.high is None:
        return None
    sure = row.uncertainty or 0.0
    width = row.high - row.low or 2.0 * (abs(row.value - row.low) or sure or 1.0)
    low = min(row.low - BEYOND * width, row.value - sure)
    high = max(row.high + BEYOND * width, row.value + sure)

    def place(value: float) -> float:
        return round(LENGTH * (value - low) / (high - low), 1)

    ends = None
    if row.uncertainty is not None:
        ends = (place(row.value - sure), place(row.value + sure))
    return RangeBar((place(row.low), place(row.high) - place(row.low)), place(row.value), ends)


def _count(rows: Sequence[Compared]) -> dict[str, int]:
    """Return how many values there are in each state."""
    states = Counter(state_of(row.verdict) for row in rows)
    return {"values": len(rows), **{name: states[name] for name in ("met", "not_met", "open")}}


def _parts(subject: Subject) -> list[tuple[str, str, dict[str, int], bool]]:
    """Return a line for each case and conclusion: address, title, counts, whether it decides."""
    cases = [
        (f"case-{place}", one.title, _count(one.rows), any(decides(row.mark) for row in one.rows))
        for place, one in enumerate(subject.cases, start=1)
    ]
    return cases + [
        (f"conclusion-{place}", f"Founding paper, {one.heading}", _count(one.rows), True)
        for place, one in enumerate(subject.conclusions, start=1)
    ]


def _figures(subject: Subject) -> dict[str, Sequence[Figure]]:
    whole = overview(subject.rows, [decides(row.mark) for row in subject.rows])
    runs = [RunData(run.latest, run.assessment) for run in subject.runs]
    fast = [run for run in runs if run.assessment.speed_m_s > GAPS_ABOVE]
    return {
        "overview": [] if whole is None else [whole],
        "force": [force_over_time(run) for run in runs],
        "interval": [force_intervals(runs)] if runs else [],
        "gap": [gap_over_time(run) for run in fast],
    }


def _identity(subject: Subject, starts: str) -> list[tuple[str, str]]:
    return [
        ("Suite", subject.suite),
        *([("Cases", f"{len(subject.cases)}, each run {starts}")] if subject.cases else []),
        ("Computed", f"{datetime.now(UTC):%Y-%m-%d %H:%M}"),
        ("Arcless", version("arcless")),
    ]


def _evidence_words(topics: Sequence[Evidence]) -> str:
    """Return how many values there are, and how many of them are where."""
    values, inside, unverified = (
        sum(getattr(one, name) for one in topics) for name in ("values", "inside", "unverified")
    )
    outside = values - inside - unverified
    words = f"{values} values: {inside} inside"
    words += f", {outside} outside" if outside else ""
    return words + (f", {unverified} outside of unverified ranges" if unverified else "")


def _evidence(topics: Sequence[Evidence]) -> list[tuple[str, list[tuple[Evidence, str]]]]:
    """Return the topics by group, each with the used part of its tolerances in percent."""
    return [
        (
            group,
            [
                (one, "–" if one.used is None else number(100 * one.used, 0))
                for one in topics
                if one.group == group
            ],
        )
        for group in dict.fromkeys(one.group for one in topics)
    ]
