"""Measured run → one HTML page, of the family of a simulated run's."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path
from typing import Any

from arcless.display.numbers import number
from arcless.figures.measured import MeasuredData, figures
from arcless.report import tables
from arcless.report.page import STACKED, track_of
from arcless.report.run_content import first_screen, marks_of, sections_of
from arcless.report.template import render
from arcless.storage.whole_files import write_bytes

# Stretches in the table of what is left out; a file with a gap each second has more.
MOST_STRETCHES = 200
_COLUMNS = ("pantograph", "why", "column", "from line", "to line", "samples", "from, s", "to, s",
            "from, m", "to, m")  # fmt: skip


@dataclass(frozen=True)
class Facts:
    """Facts of a measurement that its page shows.

    Attributes
    ----------
    name, file
        Name of the measurement, and of its file.
    words
        Text for each kind of fault.
    """

    name: str
    file: str
    words: Mapping[str, str]


def write(data: MeasuredData, facts: Facts, path: str | Path) -> None:
    """Write the page of a measured run: one HTML file that opens without a network.

    Parameters
    ----------
    data
        The measurement and its assessment.
    facts
        What it is called, and words for its faults.
    path
        The file to write; its folder must exist.

    Raises
    ------
    OutputError
        The file cannot be written; nothing half-written stays behind.
    """
    write_bytes(path, html(data, facts).encode())


def html(data: MeasuredData, facts: Facts) -> str:
    """Return the page of a measured run as one HTML text; see `write`."""
    drawn, assessment = figures(data), data.assessment
    contents = [("summary", "Summary"), ("criteria", "Criteria"), ("numbers", "Numbers")]
    contents += [(key, title) for key, title, _ in sections_of(drawn)]
    return render(
        "run.html",
        drawn,
        track=track_of(data),
        title=facts.name,
        description="A measured run.",
        identity=_identity(data, facts),
        contents=[*contents, ("sampling", "Sampling")],
        numbers=_numbers(data),
        marks=marks_of(assessment),
        sampling=_sampling(data, facts),
        version=version("arcless"),
        date=f"{datetime.now(UTC):%Y-%m-%d %H:%M}",
        stacked=STACKED,
        **first_screen(data, drawn),
    )


def _identity(data: MeasuredData, facts: Facts) -> list[tuple[str, str]]:
    a = data.assessment
    assumed = any(one.mark == "assumed" for one in a.criteria)
    begin, end = a.section_m
    return [
        ("File", facts.file),
        ("Pantograph" if len(a.pantographs) == 1 else "Pantographs",
         ", ".join(one.name for one in a.pantographs)),
        ("Speed", f"{3.6 * a.speed_m_s:.4g} km/h"),
        ("Section", f"{begin:.0f} to {end:.0f} m"),
        ("Supply", f"{a.supply} (assumed)" if assumed else a.supply),
        ("Arcless", version("arcless")),
    ]  # fmt: skip


def _numbers(data: MeasuredData) -> list[list[tuple[str, str, list[str]]]]:
    """Return the numbers as a run's page has them, without what was not measured."""
    nothing = number(None)
    return [
        [row for row in part if any(value != nothing for value in row[2])]
        for part in tables.number_rows(data)
    ]


def _sampling(data: MeasuredData, facts: Facts) -> dict[str, Any]:
    told = data.assessment.measurement or {}
    each = told["pantographs"]
    alone = len(each) == 1
    rows: list[Sequence[str]] = [
        [
            one["name"], facts.words[part["kind"]], part["channel"] or "",
            str(part["line"]), str(part["last_line"]), str(part["samples"]),
            *(number(part[key], 3) for key in ("begin_s", "end_s")),
            *(number(part[key], 1) for key in ("begin_m", "end_m")),
        ]
        for one in each for part in one["left_out"]
    ]  # fmt: skip
    shares = ", ".join(
        f"{one['left_out_percent']:.1f} %" + ("" if alone else f" of {one['name']}") for one in each
    )
    return {
        "share": f"Left out of the time in the section: {shares}.",
        "facts": [fact for one in each for fact in _facts(one, alone, told["edge_s"])],
        "table": {"titles": _COLUMNS, "rows": rows[:MOST_STRETCHES], "texts": 3},
        "more": max(0, len(rows) - MOST_STRETCHES),
    }


def _facts(one: Mapping[str, Any], alone: bool, edge_s: float) -> list[tuple[str, str]]:
    of = "" if alone else f", {one['name']}"
    spaced = "interpolated to equal steps" if one["interpolated"] else "equally spaced"
    return [
        (
            f"samples{of}",
            f"{one['rate_Hz']:.4g} a second, every {one['spacing_m']:.3g} m, {spaced}",
        ),
        (f"pieces without a gap{of}", str(one["pieces"])),
        (f"left out at each end of a piece{of}", f"{edge_s:g} s, for the filter"),
        (f"left out of the time in the section{of}", f"{one['left_out_percent']:.1f} %"),
    ]
