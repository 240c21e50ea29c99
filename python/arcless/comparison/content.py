"""Content of a report of a comparison, the same for the page and for paper."""

from collections.abc import Mapping, Sequence
from typing import Any

from arcless.comparison import cells
from arcless.comparison.change_words import change_words
from arcless.comparison.compared import Compared
from arcless.comparison.indicators import Indicator
from arcless.figures.description import Figure

# Changed fields on the first screen, and in the whole table.
FEW_FIELDS, MOST_FIELDS = 8, 400

NUMBERS_READ = (
    "Below each value: its difference from the first run, in its unit and in % of the first value."
)
LEFT_OUT = "Names, descriptions, sources, marks and derived values are not compared."
SAME = "No field of the scenarios differs."
PLACEMENT_READS = (
    "The offset is added to the first measured position, the drift to every kilometre of the"
    " odometer. The correlation is that of the two filtered forces or heights. The offset"
    " includes the delay of the instrument's amplifier times the speed."
)
BANDS_READ = (
    "Standard deviation of the contact force in each band. Below each value: its difference from"
    " the first run, and the correlation r of the two bands at equal places of the line. The first"
    " bands are those of the filtered force; third octaves follow from the spectrum of the"
    " unfiltered force."
)
ACCEPTANCE_READS = (
    "Tolerances are from memory of EN 50318:2002 (mark C): the standard was not read, and no source"
    " that quotes them was found. They decide nothing. The difference is the simulated number less"
    " the measured one; rows without a tolerance show it alone."
)

_SECTIONS: tuple[tuple[str, str, tuple[str, ...], bool], ...] = (
    ("force", "Contact force along the track", ("force",), True),
    ("spans", "Contact force by span", ("folded", "by_span"), False),
    ("spectra", "Spectra", ("spectrum", "wavelengths"), False),
    ("distribution", "Distribution and bands", ("histogram", "octaves"), False),
    ("wire", "Contact wire", ("height", "uplift"), True),
    ("droppers", "Droppers", ("droppers",), True),
)


def comparison_content(
    compared: Compared, figures: Mapping[str, Sequence[Figure]]
) -> dict[str, Any]:
    """Return what a report of a comparison tells, by names as the template of the page has them."""
    return {
        "title": _title(compared),
        "names": compared.names,
        "numbered": any(
            not name.endswith(whole)
            for name, whole in zip(compared.names, compared.full_names, strict=True)
        ),
        "runs": _runs(compared),
        "warnings": compared.warnings,
        "few": compared.fields[:FEW_FIELDS],
        "fields": compared.fields[:MOST_FIELDS],
        "count": len(compared.fields),
        "verdicts": _verdicts(compared),
        "several": len(compared.pantographs) > 1,
        "placement": _placement(compared),
        "placed_on": compared.placed_on,
        "bands": _bands(compared),
        "acceptance": _acceptance(compared),
        "simulated": sum(one.result is not None for one in compared.sides),
        "main": _rows([one for one in compared.indicators if one.key in cells.MAIN], compared),
        "numbers": _rows(compared.indicators, compared),
        "changes": change_words(compared),
        "differences_read": cells.DIFFERENCES_READ.format(compared.names[0]),
        "numbers_read": NUMBERS_READ,
        "placement_reads": PLACEMENT_READS,
        "bands_read": BANDS_READ,
        "acceptance_reads": ACCEPTANCE_READS,
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
    runs = [one.result.scenario.name for one in compared.sides if one.result is not None]
    measured = len(compared.sides) - len(runs)
    of = f" of {runs[0]}" if len(set(runs)) == 1 else ""
    counted = ((len(runs), "run"), (measured, "measurement"))
    texts = [f"a {word}" if count == 1 else f"{count} {word}s" for count, word in counted if count]
    return f"Comparison of {' and '.join(texts)}{of}"


def _runs(compared: Compared) -> list[dict[str, str]]:
    found = []
    for place, (name, side) in enumerate(zip(compared.names, compared.sides, strict=True)):
        a, run = side.assessment, side.result
        facts = {"arcless_version": None, "created": None} if run is None else run.metadata
        verdict, state = cells.decided(a)
        models = [] if run is None else [one.model.name for one in run.scenario.pantographs]
        found.append({
            "name": name, "full_name": cells.unsaid(compared.full_names[place], name, side.file),
            "file": cells.IN_MEMORY if side.file is None else str(side.file),
            "digest": compared.digests[place] or cells.NONE,
            "scenario": "measurement" if run is None else run.scenario.name,
            "line": cells.NONE if run is None else run.scenario.line.name,
            "pantographs": ", ".join(dict.fromkeys(models)) or cells.NONE,
            "speed": cells.speed(a), "section": cells.section(a),
            "verdict": verdict, "state": state,
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
