"""Sentences on what makes runs less comparable than their numbers look."""

from collections.abc import Sequence

from arcless.comparison.measured.remarks import remarks
from arcless.comparison.subjects.runs import Slot
from arcless.comparison.subjects.sides import SAME_PLACE_M, Side
from arcless.results import Result


def cautions(
    sides: Sequence[Side], names: Sequence[str], slots: Sequence[Slot], by_name: bool
) -> list[str]:
    """Return what differs between runs and measurements besides what was changed on purpose."""
    found = _of_measurements(sides, names)
    assessments = [one.assessment for one in sides]
    results = [one.result for one in sides if one.result is not None]
    runs = [name for name, one in zip(names, sides, strict=True) if one.result is not None]
    facts = [one.metadata for one in results]

    def told(what: str, texts: Sequence[str], why: str = "") -> None:
        if len(set(texts)) > 1:
            whose = names if len(texts) == len(names) else runs
            each = "; ".join(f"{name}: {text}" for name, text in zip(whose, texts, strict=True))
            found.append(f"{what} ({each}){why}")

    told("the analysis sections differ", [_section(a.section_m) for a in assessments],
         ": statistics are of other parts of the line")  # fmt: skip
    filters = [f"{a.low_pass_Hz:g} Hz, bands at {a.band_split_Hz:g} Hz" for a in assessments]
    told("the filters differ", filters, "; names of bands are those of the first run")
    told("the limits are those of different supplies", [a.supply for a in assessments])
    told("the versions of Arcless differ", [str(f["arcless_version"] or "–") for f in facts])
    told("the numbers of pantographs differ", [f"{len(a.pantographs)}" for a in assessments])
    told("the time steps differ", [_step(f["time_step_s"]) for f in facts])
    told("the schemes differ", [str(f["scheme"] or "–") for f in facts])
    told("some runs are planar, others spatial", [_space(one) for one in results],
         ": only the spatial ones have a lateral position")  # fmt: skip
    told("some lines have droppers, others have none",
         ["droppers" if one.latest["dropper"].values.size else "none" for one in results]
         if all("dropper" in one.latest for one in results) else [])  # fmt: skip
    if not by_name and len(slots) > 0:
        pairs = ", ".join(slot.name for slot in slots)
        found.append(f"no pantograph has the same name in all runs: matched by order ({pairs})")
    return found


def _of_measurements(sides: Sequence[Side], names: Sequence[str]) -> list[str]:
    """Return remarks on measurements: how they lie on the line, and what they are compared over."""
    if all(one.placed is None for one in sides):
        return []
    found = []
    reference = next((one for one in sides if one.placed is None), sides[0])
    for name, one in zip(names, sides, strict=True):
        if one.placed is not None:
            found += remarks(name, one.placed, one.assessment, reference.assessment.speed_m_s)
    begin, end = sides[0].assessment.section_m
    own = None if reference.result is None else reference.result.assessment.section_m
    if own is not None and _section(own) != _section((begin, end)):
        found.append(
            f"all are compared from {begin:.1f} to {end:.1f} m, which they share: less than the"
            f" analysis section of the run, {own[0]:.1f} to {own[1]:.1f} m"
        )
    return found


def _section(ends: Sequence[float]) -> str:
    low, high = (round(end / SAME_PLACE_M) * SAME_PLACE_M for end in ends)
    return f"{low:.7g} to {high:.7g} m"


def _step(value: object) -> str:
    return f"{1e3 * value:.4g} ms" if isinstance(value, float) else "–"


def _space(result: Result) -> str:
    """Return whether a run was computed in space or in the plane."""
    asked = result.scenario.solver.dimension
    spatial = asked == "spatial" or (asked == "auto" and result.scenario.line.is_spatial)
    return "spatial" if spatial else "planar"
