"""Comparison → one HTML page: what was run, what differs, verdicts, differences, overlays."""

from collections.abc import Mapping, Sequence
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path
from typing import Any

from arcless.comparison import cells
from arcless.comparison.compared import Compared
from arcless.comparison.indicators import Indicator
from arcless.comparison.subjects.sides import drawn
from arcless.figures.comparison import Overlaid
from arcless.figures.description import Figure
from arcless.figures.description.thinning import every
from arcless.figures.run.track import MARKS
from arcless.report.template import render
from arcless.storage.whole_files import write_bytes

# Changed fields on the first screen, and in the whole table.
FEW_FIELDS, MOST_FIELDS = 8, 400

_SECTIONS: tuple[tuple[str, str, tuple[str, ...], bool], ...] = (
    ("force", "Contact force along the track", ("force",), True),
    ("spans", "Contact force by span", ("folded", "by_span"), False),
    ("spectra", "Spectra", ("spectrum", "wavelengths"), False),
    ("distribution", "Distribution and bands", ("histogram", "octaves"), False),
    ("wire", "Contact wire", ("height", "uplift"), True),
    ("droppers", "Droppers", ("droppers",), True),
)


def write(compared: Compared, figures: Mapping[str, Sequence[Figure]], path: str | Path) -> None:
    """Write the page of a comparison: one HTML file that opens without a network.

    Parameters
    ----------
    compared
        The comparison.
    figures
        Its overlays by their keys.
    path
        The file to write; its folder must exist.
    """
    write_bytes(path, html(compared, figures).encode())


def html(compared: Compared, figures: Mapping[str, Sequence[Figure]]) -> str:
    """Return the page of a comparison as one HTML text; see `write`."""
    sections = [
        (key, title, [name for name in names if figures[name]], stacked)
        for key, title, names, stacked in _SECTIONS
        if any(figures[name] for name in names)
    ]
    contents = [("summary", "Summary"), *((key, title) for key, title, _, _ in sections)]
    if compared.bands:
        contents.append(("bands", "Bands"))
    if compared.acceptance:
        contents.append(("acceptance", "Simulation against line test"))
    contents += [("numbers", "Numbers"), ("criteria", "Criteria")]
    if sum(one.result is not None for one in compared.sides) > 1:
        contents.append(("fields", "Changed fields"))
    return render(
        "comparison.html",
        figures,
        track=_track(compared),
        title=_title(compared),
        names=compared.names,
        colours=[Overlaid((), ()).colour(k).replace("_", "-") for k in range(len(compared.names))],
        runs=_runs(compared),
        warnings=compared.warnings,
        few=compared.fields[:FEW_FIELDS],
        fields=compared.fields[:MOST_FIELDS],
        count=len(compared.fields),
        verdicts=_verdicts(compared),
        several=len(compared.pantographs) > 1,
        placement=_placement(compared),
        bands=_bands(compared),
        acceptance=_acceptance(compared),
        simulated=sum(one.result is not None for one in compared.sides),
        main=_rows([one for one in compared.indicators if one.key in cells.MAIN], compared),
        numbers=_rows(compared.indicators, compared),
        contents=contents,
        sections=sections,
        version=version("arcless"),
        date=f"{datetime.now(UTC):%Y-%m-%d %H:%M}",
    )


def _title(compared: Compared) -> str:
    """Return how many runs there are, and of which scenario, where that is one."""
    runs = [one.result.scenario.name for one in compared.sides if one.result is not None]
    measured = len(compared.sides) - len(runs)
    of = f" of {runs[0]}" if len(set(runs)) == 1 else ""
    counted = ((len(runs), "run"), (measured, "measurement"))
    texts = [f"a {word}" if count == 1 else f"{count} {word}s" for count, word in counted if count]
    return f"Comparison of {' and '.join(texts)}{of}"


def _runs(compared: Compared) -> list[dict[str, str]]:
    found = []
    for name, side in zip(compared.names, compared.sides, strict=True):
        a, run = side.assessment, side.result
        facts = {"arcless_version": None, "created": None} if run is None else run.metadata
        missed = sum(one.fails for one in a.criteria)
        models = [] if run is None else [one.model.name for one in run.scenario.pantographs]
        found.append({
            "name": name, "scenario": "measurement" if run is None else run.scenario.name,
            "line": cells.NONE if run is None else run.scenario.line.name,
            "pantographs": ", ".join(dict.fromkeys(models)) or cells.NONE,
            "speed": f"{3.6 * a.speed_m_s:.4g} km/h",
            "section": f"{a.section_m[0]:.0f} to {a.section_m[1]:.0f} m",
            "verdict": "met" if a.passed else f"{missed} not met",
            "state": "met" if a.passed else "missed",
            "version": str(facts["arcless_version"] or cells.NONE),
            "computed": str(facts["created"] or cells.NONE)[:16].replace("T", " "),
        })  # fmt: skip
    return found


def _rows(chosen: Sequence[Indicator], compared: Compared) -> list[dict[str, Any]]:
    """Return rows of a table of indicators: value of each run, and difference of all but one."""
    return [
        {
            "label": one.label, "unit": one.unit, "pantograph": one.pantograph or "",
            "cells": [
                (cells.value(one, run),
                 cells.difference(one, run) if run and one.differences[run] is not None else "")
                for run in range(len(compared.names))
            ],
        }
        for one in chosen
    ]  # fmt: skip


def _placement(compared: Compared) -> list[dict[str, Any]]:
    """Return rows of how measurements lie on the line of the first run."""
    return [
        {"run": run, "pantograph": one.name, "cells": cells.alignment(by)}
        for run, side in enumerate(compared.sides)
        if side.placed is not None
        for one, by in zip(side.placed.measurement.pantographs, side.placed.alignments, strict=True)
    ]


def _bands(compared: Compared) -> list[dict[str, Any]]:
    """Return rows of the bands: deviation of each, difference and correlation of all but one."""
    runs = range(len(compared.names))
    return [
        {
            "label": one.label, "kind": one.kind, "pantograph": one.pantograph,
            "cells": [
                (cells.amount(one.deviations_N[run], "N"),
                 cells.band_difference(one, run) if run and one.differences_N[run] is not None
                 else "",
                 f"r {one.correlations[run]:.3f}" if one.correlations[run] is not None else "")
                for run in runs
            ],
        }
        for one in compared.bands
    ]  # fmt: skip


def _acceptance(compared: Compared) -> list[dict[str, Any]]:
    """Return the tables of each run against each measurement."""
    pairs = dict.fromkeys((one.run, one.measurement) for one in compared.acceptance)
    return [
        {
            "run": compared.names[run], "measurement": compared.names[measured],
            "rows": [
                {"label": one.label, "unit": one.unit, "pantograph": one.pantograph or "",
                 "cells": cells.accepted(one), "within": one.within, "source": one.source or ""}
                for one in compared.acceptance if (one.run, one.measurement) == (run, measured)
            ],
        }
        for run, measured in pairs
    ]  # fmt: skip


def _verdicts(compared: Compared) -> list[dict[str, Any]]:
    """Return rows of criteria: verdict of each run, with value and limit."""
    return [
        {
            "title": one.title, "unit": one.unit, "pantograph": one.pantograph or "",
            "cells": [
                (word or cells.NONE, "missed" if fails else (word or "absent").split(" (")[0],
                 cells.limit(one, run))
                for run, (word, fails) in enumerate(zip(one.verdicts, one.fails, strict=True))
            ],
        }
        for one in compared.criteria
    ]  # fmt: skip


def _track(compared: Compared) -> dict[str, Any]:
    """Return section and supports of the first run in m, for buttons and the cross hair."""
    run = drawn(compared.sides)[0]
    supports = run.supports[every(run.supports.size, MARKS)] if run.supports.size else run.supports
    return {
        "section": [float(end) for end in run.assessment.section_m],
        "supports": [round(float(x), 2) for x in supports],
    }
