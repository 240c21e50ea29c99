"""Content of a report of a comparison, the same for the page and for paper."""

from collections.abc import Mapping, Sequence
from typing import Any

from arcless.comparison import cells
from arcless.comparison.compared import Compared
from arcless.comparison.indicators import Indicator
from arcless.figures.description import Figure

# Changed fields on the first screen, and in the whole table.
FEW_FIELDS, MOST_FIELDS = 8, 400

NUMBERS_READ = (
    "Below each value its difference to the first run, in the unit and in % of the first value."
)
LEFT_OUT = (
    "Names, descriptions, sources and marks are left out, and so is what follows from other fields."
)
SAME = "No field of the scenarios differs."

_SECTIONS: tuple[tuple[str, str, tuple[str, ...], bool], ...] = (
    ("force", "Contact force along the track", ("force",), True),
    ("spans", "Contact force by span", ("folded", "by_span"), False),
    ("spectra", "Spectra", ("spectrum", "wavelengths"), False),
    ("wire", "Uplift", ("uplift",), True),
    ("droppers", "Droppers", ("droppers",), True),
)


def comparison_content(
    compared: Compared, figures: Mapping[str, Sequence[Figure]]
) -> dict[str, Any]:
    """Return what a report of a comparison tells, by names as the template of the page has them."""
    return {
        "title": _title(compared),
        "names": compared.names,
        "runs": _runs(compared),
        "warnings": compared.warnings,
        "few": compared.fields[:FEW_FIELDS],
        "fields": compared.fields[:MOST_FIELDS],
        "count": len(compared.fields),
        "verdicts": _verdicts(compared),
        "several": len(compared.pantographs) > 1,
        "main": _rows([one for one in compared.indicators if one.key in cells.MAIN], compared),
        "numbers": _rows(compared.indicators, compared),
        "numbers_read": NUMBERS_READ,
        "left_out": LEFT_OUT,
        "same": SAME,
        "sections": [
            (key, title, [name for name in names if figures[name]], stacked)
            for key, title, names, stacked in _SECTIONS
            if any(figures[name] for name in names)
        ],
    }


def _title(compared: Compared) -> str:
    """Return how many runs there are, and of which scenario, where that is one."""
    scenarios = {one.scenario.name for one in compared.results}
    of = f" of {scenarios.pop()}" if len(scenarios) == 1 else ""
    return f"Comparison of {len(compared.names)} runs{of}"


def _runs(compared: Compared) -> list[dict[str, str]]:
    found = []
    for name, result in zip(compared.names, compared.results, strict=True):
        a, facts = result.assessment, result.metadata
        missed = sum(one.fails for one in a.criteria)
        models = dict.fromkeys(one.model.name for one in result.scenario.pantographs)
        found.append({
            "name": name, "scenario": result.scenario.name, "line": result.scenario.line.name,
            "pantographs": ", ".join(models), "speed": f"{3.6 * a.speed_m_s:.4g} km/h",
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
