"""Tables and figures of a study → one HTML file that needs no network."""

import warnings
from contextlib import suppress
from pathlib import Path
from typing import Any

from arcless.errors import OutputError
from arcless.report.drawing.bokeh_objects import Model
from arcless.report.template import render
from arcless.storage.whole_files import write_bytes
from arcless.study.analysis import findings
from arcless.study.definition.study import Study
from arcless.study.evaluation.version import code_version
from arcless.study.folder.status import DamagedJournalWarning, StudyStatus
from arcless.study.report import tables
from arcless.study.report.figures import (
    MOST_OUTPUTS,
    MOST_VARIABLES,
    PAIRED_OUTPUTS,
    PAIRED_VARIABLES,
    Drawing,
)
from arcless.study.report.record import Record
from arcless.study.report.sensitivity import sections
from arcless.study.report.speeds import WIDE, SpeedMarks, marks

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
    figures: dict[str, Any] = {}
    groups: dict[str, list[Any]] = {"effects": [], "pairs": []}
    fronts: list[str] = []
    drawn = 0
    speeds = marks(record) if record.done else None
    if record.done:
        drawing = Drawing(record, speeds)
        drawn = len(drawing.drawn)
        figures["table"] = tables.data_table(drawing)
        for kind, found in (("effects", drawing.effects()), ("pairs", drawing.pairs())):
            for output, panels in found:
                names = [f"{kind} {len(figures) + place}" for place in range(len(panels))]
                figures |= dict(zip(names, panels, strict=True))
                groups[kind].append((output, names))
        for place, panel in enumerate(drawing.fronts()):
            fronts.append(f"front {place}")
            figures[fronts[-1]] = panel
    sensitivity = sections(record)
    for place, section in enumerate(sensitivity):
        figures[f"sensitivity {place}"] = section.pop("figure")
    return render(
        "study.html",
        figures,
        widgets=True,
        **_texts(record, drawn),
        **_speeds(speeds),
        **groups,
        wide=[name for name, made in figures.items() if WIDE in _tags(made)],
        fronts=fronts,
        sensitivity=sensitivity,
    )


def _tags(made: Model | None) -> list[str]:
    return [] if made is None else vars(made).get("tags", [])


def _texts(record: Record, drawn: int) -> dict[str, Any]:
    study, status = record.study, record.status
    reasons, stops = tables.failures(record), tables.stops(record)
    return {
        "study": study,
        "state": _state(record),
        "facts": _facts(record),
        "variables": tables.variable_rows(study),
        "changes": [(path, tables.written(value)) for path, value in study.changes.items()],
        "outputs": tables.output_rows(record),
        "percentiles": tables.percentile_rows(record),
        "stops": stops[: tables.STOPS],
        "more_stops": len(stops) - tables.STOPS,
        "reasons": reasons[: tables.REASONS],
        "more_reasons": len(reasons) - tables.REASONS,
        "leaders": tables.leaders(record),
        "best": tables.best(record),
        "drawn": drawn,
        "status": status,
        "most": {
            "variables": MOST_VARIABLES,
            "outputs": MOST_OUTPUTS,
            "paired": PAIRED_VARIABLES,
            "coloured": PAIRED_OUTPUTS,
        },
        "file": study.file,
        "folder": str(record.place.path),
        "version": code_version(),
    }


def _speeds(found: SpeedMarks | None) -> dict[str, Any]:
    if found is None:
        return {"speeds": [], "speed_unit": "", "speed_notes": ()}
    unit = found.column.unit
    return {"speeds": found.rows(), "speed_unit": unit, "speed_notes": found.notes}


def _state(record: Record) -> tuple[str, str]:
    """Return a class for the headline's colour, and the headline."""
    found = record.status
    parts = [f"{found.done} of {found.total} variants computed"]
    parts += [f"{found.pruned} pruned"] if found.pruned else []
    parts += [f"{found.invalid} invalid"] if found.invalid else []
    parts += [f"{found.failed} failed"] if found.failed else []
    if found.missing:
        parts.append(f"{found.missing} missing")
        how = "it is being computed now" if found.running else "it is not being computed"
        return "open", f"Incomplete: {', '.join(parts)}; {how}"
    if not found.done:
        return "missed", f"No variant has a value: {', '.join(parts[1:])}"
    whole = found.done + found.pruned == found.total
    return "met" if whole else "open", f"Complete: {', '.join(parts)}"


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
