"""Content of a study's report, the same for the page and for paper: texts, tables, sections."""

from dataclasses import dataclass
from typing import Any

from arcless.figures.description import Figure
from arcless.study.designs.samples import Sample
from arcless.study.evaluation.version import code_version
from arcless.study.folder.status import StudyStatus
from arcless.study.report import summary, tables, wording
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
from arcless.study.report.spacing import spacing_texts

Groups = list[tuple[Column | None, list[Figure]]]

GRIDS = (
    "The map has a cell for each variant; cells have equal size whatever the distance between"
    " values."
)


@dataclass(frozen=True)
class Section:
    """A section of figures: address, title, text, heading and figures of each group.

    `selects` says that variants are selected in its figures where a medium can do that.
    """

    key: str
    title: str
    text: str
    selects: bool
    groups: list[tuple[str, str]]

    @property
    def names(self) -> list[str]:
        """Names of the groups' figures."""
        return [name for _, name in self.groups]


@dataclass(frozen=True)
class StudyContent:
    """Content of a report of a study.

    Attributes
    ----------
    texts
        Texts and tables by names as the template of the page has them.
    figures
        Figures of each group, and of each output's sensitivity, by name.
    canvas
        Variants as they are drawn; None where none has a value.
    """

    texts: dict[str, Any]
    figures: dict[str, Any]
    canvas: Canvas | None


def study_content(record: Record) -> StudyContent:
    """Return what a report of a study shows, of as many rows as there are."""
    verdicts = judge(record)
    speeds = marks(record) if record.done else None
    canvas = Canvas(record, verdicts) if record.done else None
    figures, rows = ({}, []) if canvas is None else _figures(canvas, speeds)
    sensitivity = sections(record) if record.done else []
    for place, section in enumerate(sensitivity):
        figures[f"sensitivity {place}"] = section.pop("figure")
    criteria = [] if canvas is None else summary.criterion_rows(verdicts)
    unknown = () if canvas is None else verdicts.unknown
    texts = {
        **_texts(record),
        **_speeds(speeds),
        "spacing": spacing_texts(record) if record.done else [],
        "verdict": summary.headline(record, verdicts),
        "ranges": [] if canvas is None else summary.ranges(canvas),
        "criteria": criteria,
        "rows": rows,
        "lead": next((name for row in rows for name in row.names), ""),
        "sensitivity": sensitivity,
        "words": {
            "judged": wording.judged(any_criterion=bool(criteria)),
            "not_judged": wording.not_judged(unknown),
            "outputs": wording.outputs_of(record.study),
            "percentiles": wording.percentiles(record.status),
            "speeds": wording.SPEEDS,
            "indices": f"{_kind(sensitivity)} {wording.INDICES}",
            "best": wording.best(len(getattr(record.study.design, "objectives", ()))),
            "no_best": wording.NO_BEST,
            "lowest": wording.LOWEST,
            "stops": wording.STOPS,
            "reasons": wording.reasons(record.study.file),
        },
        "again": wording.again(record.study.file),
    }
    return StudyContent(texts, figures, canvas)


def _kind(sensitivity: list[dict[str, Any]]) -> str:
    return wording.SOBOL if sensitivity and sensitivity[0]["sobol"] else wording.MORRIS


def _figures(canvas: Canvas, speeds: SpeedMarks | None) -> tuple[dict[str, Any], list[Section]]:
    """Return all figures by group, and the sections that they stand in."""
    scatters, two = Scatters(canvas, speeds), factors(canvas)
    figures: dict[str, Any] = {}
    found: list[Section] = []

    def add(key: str, title: str, text: str, selects: bool, groups: Groups) -> None:
        names = []
        for output, made in groups:
            name = f"{key} {'' if output is None else canvas.key(output)}"
            figures[name] = made
            names.append(("" if output is None else output.heading, name))
        if names:
            found.append(Section(key, title, text, selects, names))

    if two is not None:
        grids = Grids(canvas, *two, speeds)
        shown = canvas.outputs[:MOST_OUTPUTS]
        add(
            "grids",
            "Outputs over both variables",
            GRIDS,
            True,
            [(out, grids.figures(out)) for out in shown],
        )
    else:
        add("effects", "Outputs over variables", _effects_text(canvas), True, [*scatters.effects()])
        add("pairs", "Two variables at a time", _pairs_text(canvas), False, [*scatters.pairs()])
    fronts = scatters.fronts()
    add("fronts", "Outputs against each other", "", False, [(None, fronts)] if fronts else [])
    return figures, found


def _effects_text(canvas: Canvas) -> str:
    parts = ["Each mark is one variant; the marks of a sweep are connected."]
    if isinstance(canvas.record.study.design, Sample):
        parts.append(
            "The line with error bars shows the mean of the variants at each value, or of tenths of"
            " the variants, with its standard error."
        )
    if len(canvas.varied) > MOST_VARIABLES:
        parts.append(
            f"The figures show {MOST_VARIABLES} of {len(canvas.varied)} variables: those that alone"
            " explain the largest share of the variance of an output."
        )
    if len(canvas.outputs) > MOST_OUTPUTS:
        parts.append(f"The figures show the first {MOST_OUTPUTS} outputs.")
    return " ".join(parts)


def _pairs_text(canvas: Canvas) -> str:
    most = (
        f"; the {PAIRED_VARIABLES} variables that explain most of it"
        if len(canvas.varied) > PAIRED_VARIABLES
        else ""
    )
    return f"Coloured by an output{most}. Of overlapping marks, the last one is visible."


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
