"""Numbers of the assessment as text for the page's tables."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from arcless.assess import Assessment
from arcless.report.line import energy_terms, settled
from arcless.report.scene import Scene

REFERENCE_KEYS = ("quantity", "value", "low", "high", "verdict", "mark", "source")
SIGNS = {"<=": "≤", ">=": "≥", ">": ">"}

# Key of a pantograph's indicators → label, unit, decimals.
INDICATORS: dict[str, tuple[str, str, int]] = {
    "mean_force_N": ("mean force F_m", "N", 1),
    "std_force_N": ("standard deviation σ", "N", 1),
    "std_force_0_5Hz_N": ("σ, lower band", "N", 1),
    "std_force_5_20Hz_N": ("σ, upper band", "N", 1),
    "max_force_N": ("highest force", "N", 1),
    "min_force_N": ("lowest force", "N", 1),
    "statistical_max_N": ("F_m + 3σ", "N", 1),
    "statistical_min_N": ("F_m − 3σ", "N", 1),
    "unfiltered_max_force_N": ("highest force, unfiltered", "N", 1),
    "unfiltered_min_force_N": ("lowest force, unfiltered", "N", 1),
    "contact_loss_percent": ("loss of contact, share of time", "%", 3),
    "longest_loss_s": ("longest loss of contact", "s", 3),
    "max_gap_mm": ("largest gap", "mm", 1),
    "contact_point_range_mm": ("range of the contact point's height", "mm", 1),
}
# Shown for a scenario with coefficients of wear.
WEAR: dict[str, tuple[str, str, int]] = {
    "wear_mechanical_mm3_km": ("wear by friction", "mm³/km", 3),
    "wear_joule_mm3_km": ("wear by the current through the contact", "mm³/km", 3),
    "wear_arc_mm3_km": ("wear by arcs", "mm³/km", 3),
    "wear_total_mm3_km": ("wear in sum", "mm³/km", 3),
}


@dataclass(frozen=True)
class Verdict:
    """The page's headline: a class for its colour, a sentence, and what was missed."""

    state: str
    text: str
    missed: list[str]


def number(value: float | None, decimals: int = 1) -> str:
    """Return a number with a real minus sign, a dash when there is none."""
    if value is None:
        return "–"
    return f"{value:.{decimals}f}".replace("-", "−")


def verdict(assessment: Assessment) -> Verdict:
    """Return the verdict over all criteria."""
    judged = [c for c in assessment.criteria if c.passed is not None]
    missed = [c for c in judged if not c.passed]
    open_count = len(assessment.criteria) - len(judged)
    rest = f"; {open_count} could not be judged" if open_count else ""
    names = [
        f"{c.title} ({', '.join(filter(None, [c.pantograph, f'mark {c.mark}']))})" for c in missed
    ]
    if missed:
        text = f"{len(missed)} of {len(judged)} judged criteria missed{rest}"
        return Verdict("missed", text, names)
    return Verdict("met", f"All {len(judged)} judged criteria met{rest}", names)


def indicator_rows(assessment: Assessment) -> list[tuple[str, str, list[str]]]:
    """Return label, unit and one value per pantograph for every indicator."""
    rows = []
    worn = assessment.pantographs[0].wear_mechanical_mm3_km is not None
    for key, (label, unit, decimals) in (INDICATORS | (WEAR if worn else {})).items():
        values = [number(getattr(p, key), decimals) for p in assessment.pantographs]
        rows.append((label, unit, values))
    return rows


def fact_pairs(scene: Scene) -> list[tuple[str, str]]:
    """Return the facts of the whole run as label and text."""
    a = scene.assessment
    begin, end = a.section_m
    residual = a.energy_residual_relative
    droppers = [
        ("lowest dropper force", f"{number(a.min_dropper_force_N)} N"),
        ("most droppers slack at once", number(a.slack_droppers_max, 0)),
    ]
    return [
        ("speed", f"{number(3.6 * a.speed_m_s)} km/h"),
        ("section assessed", f"{begin:.0f} to {end:.0f} m"),
        ("highest uplift at a support", f"{number(a.max_uplift_at_support_mm)} mm"),
        *(droppers if scene.has_droppers else []),
        ("energy residual, relative", "–" if residual is None else f"{residual:.1e}"),
        ("time steps", f"{a.steps:,}".replace(",", " ")),
        ("time-stepping loop", f"{number(a.wall_time_s, 2)} s"),
        ("set-up", f"{number(a.setup_time_s, 2)} s"),
        ("real-time factor", number(a.real_time_factor)),
    ]


def criterion_rows(assessment: Assessment) -> list[dict[str, Any]]:
    """Return the criteria as text; what repeats from the row above is left empty."""
    above = ["", *(c.name for c in assessment.criteria)]
    return [
        {
            "title": "" if c.name == previous else c.title,
            "pantograph": c.pantograph or "",
            "value": number(c.value, _decimals(c.unit)),
            "limit": f"{SIGNS[c.relation]} {number(c.limit, _decimals(c.unit))}",
            "unit": "" if c.unit == "1" else c.unit,
            "verdict": {True: "met", False: "missed", None: "not judged"}[c.passed],
            "mark": c.mark,
            "source": "" if c.name == previous else c.source,
            "note": "" if c.name == previous else c.note,
        }
        for c, previous in zip(assessment.criteria, above, strict=False)
    ]


def reference_cells(rows: Sequence[Mapping[str, Any]]) -> list[dict[str, str]]:
    """Return reference rows as text: numbers to four digits, a dash where there is none."""
    return [{key: _cell(row.get(key)) for key in REFERENCE_KEYS} for row in rows]


def energy_rows(scene: Scene) -> list[tuple[str, str, str]]:
    """Return each ledger term's label, meaning, and value at the end of the run in J."""
    return [
        (
            label,
            str(scene.dataset[name].attrs.get("long_name", "")),
            f"{settled(scene, name)[-1]:.6g}".replace("-", "−"),
        )
        for name, label in energy_terms(scene)
        if settled(scene, name).size
    ]


def _cell(value: Any) -> str:
    if value is None:
        return "–"
    return f"{value:.4g}".replace("-", "−") if isinstance(value, float) else str(value)


def _decimals(unit: str) -> int:
    return {"%": 3, "1": 3}.get(unit, 1)
