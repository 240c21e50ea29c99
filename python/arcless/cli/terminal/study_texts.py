"""Texts about a study on a terminal, and its data: progress, pruning, the best variants."""

from typing import TYPE_CHECKING, Any

from arcless.cli.terminal import console

if TYPE_CHECKING:
    from arcless.study import Progress, Study, StudyFolder, StudyStatus
    from arcless.study.analysis.spacings import SpacingCurve
    from arcless.study.journal.row import Row

# Variants of a front that are printed.
_MOST_SHOWN = 10


def facts_of(loaded: "Study", place: "StudyFolder", done: "Progress") -> dict[str, Any]:
    """Return the final state of a study as plain data."""
    return {
        "study": loaded.name,
        "folder": str(place.path),
        "total": done.total,
        **{status: done.counts[status] for status in ("done", "pruned", "invalid", "failed")},
        "computed": done.computed,
        "elapsed_s": round(done.elapsed_s, 3),
        "variants_per_s": None if done.rate is None else round(done.rate, 3),
        **_saving(loaded, place),
    }


def _saving(loaded: "Study", place: "StudyFolder") -> dict[str, Any]:
    """Return the steps that pruning has saved; None of a study whose runs nobody observes."""
    from arcless.study.folder.status import saving_of

    found = saving_of(loaded, place)
    if found is None:
        return {}
    percent = round(found.percent, 2)
    saved = round(found.saved)
    return {"steps_taken": found.taken, "steps_saved": saved, "steps_saved_percent": percent}


def front_of(loaded: "Study", place: "StudyFolder") -> "list[Row] | None":
    """Return the best rows of an optimisation; None of other studies."""
    from arcless import study as studies

    design = loaded.design
    return design.best(place.rows()) if isinstance(design, studies.Optimise) else None


def show_front(loaded: "Study", front: "list[Row] | None") -> None:
    """Print the best variants of an optimisation; nothing of other studies."""
    if front is None:
        return
    if not front:
        console.data("best: no variant that meets the constraints")
    for row in front[:_MOST_SHOWN]:
        console.data(f"best: variant {row.variant}: {_in_words(loaded, row)}")
    if len(front) > _MOST_SHOWN:
        console.data(f"and {len(front) - _MOST_SHOWN} more, none of which surpasses another")


def _in_words(loaded: "Study", row: "Row") -> str:
    """Return variables in the units of the study file, and outputs, of a row."""
    from arcless.study.folder.table import unit_of_output

    parts = [f"{axis.name} {axis.shown(row.values[axis.name])}" for axis in loaded.axes]
    for name, value in row.outputs.items():
        number = "–" if value is None else f"{value:.6g} {unit_of_output(loaded, name)}".rstrip()
        parts.append(f"{name} {number}")
    return ", ".join(parts)


def spacings_of(loaded: "Study", place: "StudyFolder") -> "list[SpacingCurve]":
    """Return the curves over the spacing of two pantographs; none of other studies."""
    from arcless.study.analysis.spacings import spacing_axis, spacing_curves

    return [] if spacing_axis(loaded) is None else spacing_curves(loaded, place.rows())


def show_spacings(loaded: "Study", curves: "list[SpacingCurve]") -> None:
    """Print the worst and the best spacing of each curve."""
    for curve in curves[:_MOST_SHOWN]:
        shown = [
            f"{axis.name} {axis.shown(curve.others[axis.name])}"
            for axis in loaded.axes
            if axis.name in curve.others
        ]
        where = f" at {', '.join(shown)}" if shown else ""
        worst, best = (
            f"{curve.spacings[i]:g} m ({curve.values[i]:.1f} N)" for i in (curve.worst, curve.best)
        )
        console.data(f"{curve.output}{where}: worst spacing {worst}, best {best}")
    if len(curves) > _MOST_SHOWN:
        console.data(f"and {len(curves) - _MOST_SHOWN} more curves over the spacing")
    if curves:
        console.data("`arcless study report` says which waves explain it")


def show_done(facts: dict[str, Any]) -> None:
    """Print the final state of a study."""
    rate = facts["variants_per_s"]
    speed = "" if rate is None else f" in {facts['elapsed_s']:.1f} s, {rate:.3g} variants/s"
    pruned = f"{facts['pruned']} pruned, " if "steps_saved" in facts else ""
    console.data(
        f"{facts['study']}: {facts['done']} of {facts['total']} done, {pruned}"
        f"{facts['invalid']} invalid, {facts['failed']} failed; "
        f"computed {facts['computed']}{speed}"
    )
    if "steps_saved" in facts:
        share = f"{facts['steps_saved_percent']:.3g} % of all"
        console.data(f"pruning saved some {facts['steps_saved']} steps, {share}")


def show_status(found: "StudyStatus") -> None:
    """Print the status of a study."""
    console.data(f"{found.name}: {found.sentence}")
    if found.pruned:
        console.data(f"pruning saved some {found.steps_saved} steps; {found.steps_taken} taken")
    for error, count in list(found.errors.items())[:10]:
        console.data(f"  {count} × {error}")
    if len(found.versions) > 1:
        versions = ", ".join(f"{count} by {version}" for version, count in found.versions.items())
        console.data(f"  rows of several versions: {versions}")
    if found.damage is not None:
        console.warn(found.damage)
    if found.journal is not None:
        console.data(f"journal: {found.journal}")
    console.data(f"table: {found.folder}/table.parquet")
