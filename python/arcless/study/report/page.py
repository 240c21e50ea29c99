"""Tables and figures of a study → one HTML file that needs no network."""

import warnings
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from arcless.errors import OutputError
from arcless.figures.description import Figure
from arcless.report.drawing.bokeh_figure import Drawing
from arcless.report.template import render
from arcless.storage.whole_files import write_bytes
from arcless.study.analysis import findings
from arcless.study.definition.study import Study
from arcless.study.designs.samples import Sample
from arcless.study.evaluation.version import code_version
from arcless.study.folder.status import DamagedJournalWarning, StudyStatus
from arcless.study.report import summary, tables, variants
from arcless.study.report.data.judge import judge
from arcless.study.report.data.record import Column, Record
from arcless.study.report.figures.canvas import Canvas
from arcless.study.report.figures.grids import Grids, factors
from arcless.study.report.figures.scatters import (
    MOST_OUTPUTS,
    MOST_VARIABLES,
    PAIRED_VARIABLES,
    Scatters,
)
from arcless.study.report.figures.speeds import SpeedMarks, marks
from arcless.study.report.sensitivity import sections

NAME = "report.html"


def write(study: Study, folder: Path | None = None, path: Path | None = None) -> Path:
    """Write the report of a study, of as many rows as there are.

    Parameters
    ----------
    study
        From `arcless.study.load`.
    folder
        Its folder; ``runs/studies/NAME`` without.
    path
        The file to write; ``report.html`` in the folder without.

    Returns
    -------
    pathlib.Path
        The file that was written.

    Raises
    ------
    StudyError
        No study was begun there, or another one; a package is missing.
    OutputError
        The file cannot be written; nothing half-written stays behind.
    """
    record = Record(study, folder)
    if record.status.damage is not None:
        warnings.warn(record.status.damage, DamagedJournalWarning, stacklevel=2)
    target = path or record.place.path / NAME
    write_bytes(target, _page(record).encode())
    if not record.status.running:
        with suppress(OutputError):  # the page may stand elsewhere, and has them too
            findings.write(record.place, record.findings)
    return target


def html(study: Study, folder: Path | None = None) -> str:
    """Return the report as one HTML text; see `write`."""
    return _page(Record(study, folder))


def _page(record: Record) -> str:
    verdicts = judge(record)
    texts = _texts(record)
    if not record.done:
        return render("study.html", {}, verdict=summary.headline(record, verdicts), ranges=[],
                      criteria=[], unknown=(), variants=None, lead="", rows=[], speeds=[],
                      speed_notes=(), speed_unit="", sensitivity=[],
                      contents=_contents(texts, []), **texts)  # fmt: skip
    canvas, drawing, speeds = Canvas(record, verdicts), Drawing(), marks(record)
    figures, rows = _figures(canvas, speeds)
    sensitivity = sections(record)
    for place, section in enumerate(sensitivity):
        figures[f"sensitivity {place}"] = section.pop("figure")
    texts |= _speeds(speeds)
    shown = [*rows, *(["sensitivity"] if sensitivity else [])]
    return render(
        "study.html",
        figures,
        drawing=drawing,
        verdict=summary.headline(record, verdicts),
        ranges=summary.ranges(canvas),
        criteria=summary.criterion_rows(verdicts),
        unknown=verdicts.unknown,
        variants=variants.table(canvas, drawing),
        lead=next((name for row in rows for name in row.names), ""),
        rows=rows,
        sensitivity=sensitivity,
        contents=_contents(texts, shown),
        **texts,
    )


@dataclass(frozen=True)
class Section:
    """A section of figures: address, title, text, heading and figures of each group."""

    key: str
    title: str
    text: str
    groups: list[tuple[str, str]]

    @property
    def names(self) -> list[str]:
        """Names of the groups' figures."""
        return [name for _, name in self.groups]


def _figures(canvas: Canvas, speeds: SpeedMarks | None) -> tuple[dict[str, Any], list[Section]]:
    """Return all figures by group, and the sections that they stand in."""
    scatters, two = Scatters(canvas, speeds), factors(canvas)
    figures: dict[str, Any] = {}
    found: list[Section] = []

    def add(
        key: str, title: str, text: str, groups: list[tuple[Column | None, list[Figure]]]
    ) -> None:
        names = []
        for output, made in groups:
            name = f"{key} {'' if output is None else canvas.key(output)}"
            figures[name] = made
            names.append(("" if output is None else output.heading, name))
        if names:
            found.append(Section(key, title, text, names))

    if two is not None:
        grids = Grids(canvas, *two, speeds)
        shown = canvas.outputs[:MOST_OUTPUTS]
        add(
            "grids",
            "Outputs over both variables",
            GRIDS,
            [(out, grids.figures(out)) for out in shown],
        )
    else:
        add("effects", "Outputs over variables", _effects_text(canvas), [*scatters.effects()])
        add("pairs", "Two variables at a time", _pairs_text(canvas), [*scatters.pairs()])
    fronts = scatters.fronts()
    add("fronts", "Outputs against each other", "", [(None, fronts)] if fronts else [])
    return figures, found


SELECTS = (
    "Drag a box to select variants, or click one: they stay selected in all figures and in the"
    " table; a click on empty ground takes it back."
)
GRIDS = (
    "The map has a cell for each variant; cells have equal size whatever the distance between"
    f" values. {SELECTS}"
)


def _effects_text(canvas: Canvas) -> str:
    parts = ["A mark is a variant; of a sweep they are joined."]
    if isinstance(canvas.record.study.design, Sample):
        parts.append(
            "The line with bars has the means of the variants at each value, or of tenths of the"
            " variants, with their standard error."
        )
    parts.append(SELECTS)
    if len(canvas.varied) > MOST_VARIABLES:
        parts.append(
            f"Of {len(canvas.varied)} variables the {MOST_VARIABLES} are drawn that explain most of"
            " an output's variance, each by itself."
        )
    if len(canvas.outputs) > MOST_OUTPUTS:
        parts.append(f"The first {MOST_OUTPUTS} outputs are drawn.")
    return " ".join(parts)


def _pairs_text(canvas: Canvas) -> str:
    most = (
        f"; the {PAIRED_VARIABLES} variables that explain most of it"
        if len(canvas.varied) > PAIRED_VARIABLES
        else ""
    )
    return f"Coloured by an output{most}. Where marks fall on each other, the last one is seen."


def _contents(texts: dict[str, Any], shown: list[Any]) -> list[tuple[str, str]]:
    """Return the addresses and titles of the sections that the page has."""
    found = [("summary", "Summary")]
    figures = [(one.key, one.title) for one in shown if isinstance(one, Section)]
    done = texts["status"].done > 0
    given = [
        (done, "criteria", "Criteria"),
        (done, "outputs", "Outputs"),
        *((True, *one) for one in figures),
        (texts.get("speeds") or texts.get("speed_notes"), "speeds", "Resonance speeds"),
        ("sensitivity" in shown, "sensitivity", "Sensitivity"),
        (texts["best"] is not None, "best", "Best variants"),
        (done, "variants", "All variants"),
        (texts["stops"], "stops", "Stopped early"),
        (texts["reasons"], "reasons", "Without a value"),
        (True, "varied", "What was varied"),
        (True, "again", "Run it again"),
    ]
    return [*found, *((key, title) for is_there, key, title in given if is_there)]


def _texts(record: Record) -> dict[str, Any]:
    study, status = record.study, record.status
    reasons, stops = tables.failures(record), tables.stops(record)
    return {
        "study": study,
        "identity": summary.identity(record),
        "facts": _facts(record),
        "variables": tables.variable_rows(study),
        "changes": [(path, tables.written(value)) for path, value in study.changes.items()],
        "outputs": tables.output_rows(record),
        "percentiles": tables.percentile_rows(record),
        "stops": stops[: tables.STOPS],
        "more_stops": len(stops) - tables.STOPS,
        "reasons": reasons[: tables.REASONS],
        "more_reasons": len(reasons) - tables.REASONS,
        "best": tables.best(record),
        "printed": variants.PRINTED,
        "status": status,
        "file": study.file,
        "folder": str(record.place.path),
        "version": code_version(),
    }


def _speeds(found: SpeedMarks | None) -> dict[str, Any]:
    if found is None:
        return {"speeds": [], "speed_unit": "", "speed_notes": ()}
    unit = found.column.unit
    return {"speeds": found.rows(), "speed_unit": unit, "speed_notes": found.notes}


def _saving(status: StudyStatus) -> list[tuple[str, str]]:
    if status.steps_saved is None or status.steps_taken is None:
        return []
    share = 100.0 * status.steps_saved / max(status.steps_taken + status.steps_saved, 1)
    return [("steps saved by pruning", f"some {status.steps_saved}, {share:.3g} % of all")]


def _facts(record: Record) -> list[tuple[str, str]]:
    study, status = record.study, record.status
    versions = ", ".join(
        version if len(status.versions) == 1 else f"{version} ({count})"
        for version, count in status.versions.items()
    )
    return [
        ("scenario", study.scenario.name),
        ("design", tables.design_text(study)),
        ("variants", f"{status.total:,}".replace(",", " ")),
        ("computing, sum of all variants", f"{status.wall_time_s:.1f} s"),
        *_saving(status),
        ("begun", str(record.state.get("begun", "–")).replace("T", " ").replace("+00:00", " UTC")),
        ("computed by version", versions or "–"),
    ]
