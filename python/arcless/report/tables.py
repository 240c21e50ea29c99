"""Numbers of the assessment as text for the page's tables."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

from arcless.assess import (
    TOO_CLOSE,
    Assessment,
    Criterion,
    allowance,
    uncertainty_of,
    verdict_of,
)
from arcless.report.figures.line_at_rest import energy_terms, settled
from arcless.report.figures.run_data import RunData

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
    "NQ_percent": ("arcing NQ, losses above 5 ms", "%", 3),
    "contact_loss_percent": ("loss of contact, all losses", "%", 3),
    "longest_loss_s": ("longest loss of contact", "s", 3),
    "max_gap_mm": ("largest gap", "mm", 1),
    "contact_point_range_mm": ("range of the contact point's height", "mm", 1),
    "max_lateral_position_mm": ("largest lateral position of the wire", "mm", 0),
}
# Shown for a scenario with coefficients of wear.
WEAR: dict[str, tuple[str, str, int]] = {
    "wear_mechanical_mm3_km": ("wear by friction", "mm³/km", 3),
    "wear_joule_mm3_km": ("wear by the current through the contact", "mm³/km", 3),
    "wear_arc_mm3_km": ("wear by arcs", "mm³/km", 3),
    "wear_total_mm3_km": ("wear in sum", "mm³/km", 3),
}
# Numbers of the whole run, of those that are known to be sure or not.
OF_RUN: dict[str, tuple[str, str, int]] = {
    "max_uplift_at_support_mm": ("highest uplift at a support", "mm", 1),
    "min_dropper_force_N": ("lowest dropper force", "N", 1),
    "slack_droppers_max": ("most droppers slack at once", "", 0),
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
    beyond = [c for c in judged if not c.passed]
    missed = [c for c in beyond if c.fails]
    unsure = len(beyond) - len(missed)
    close = sum(verdict_of(asdict(c)) == TOO_CLOSE for c in assessment.criteria)
    open_count = len(assessment.criteria) - len(judged) - close
    rest = f"; {close} too close to tell" if close else ""
    rest += f"; {open_count} could not be judged" if open_count else ""
    rest += f"; {unsure} not met by limits that are not verified" if unsure else ""
    names = [
        f"{c.title} ({', '.join(filter(None, [c.pantograph, f'mark {c.mark}']))})" for c in beyond
    ]
    if missed:
        text = f"{len(missed)} of {len(judged)} judged criteria not met{rest}"
        return Verdict("missed", text, names)
    count = f"All {len(judged)}" if not unsure else f"{len(judged) - unsure} of {len(judged)}"
    state = "open" if close or unsure else "met"
    return Verdict(state, f"{count} judged criteria met{rest}", names)


def indicator_rows(assessment: Assessment) -> list[tuple[str, str, list[str]]]:
    """Return label, unit and one value per pantograph for every indicator."""
    rows = []
    worn = assessment.pantographs[0].wear_mechanical_mm3_km is not None
    for key, (label, unit, decimals) in (INDICATORS | (WEAR if worn else {})).items():
        values = [_with_certainty(p, key, decimals) for p in assessment.pantographs]
        rows.append((label, unit, values))
    return rows


def _with_certainty(of: Any, key: str, decimals: int) -> str:
    """Return a number of a pantograph or of the run, with how sure it is where that is known."""
    known = uncertainty_of((of.certainty or {}).get(key))
    return pair(getattr(of, key), known, decimals)


def pair(value: float | None, uncertainty: float | None, decimals: int) -> str:
    """Return a number with the text after its ±, where there is any."""
    text = number(value, decimals)
    return text if uncertainty is None else f"{text} ± {number(uncertainty, decimals)}"


def certainty_rows(assessment: Assessment) -> list[dict[str, Any]]:
    """Return spread and discretisation of every number of a pantograph, and of those of the run."""
    rows = []
    for p in assessment.pantographs:
        for key, (label, unit, decimals) in (INDICATORS | WEAR).items():
            known = (p.certainty or {}).get(key)
            rows += [] if known is None else [_parts(p.name, label, unit, decimals, known)]
    for key, (label, unit, decimals) in OF_RUN.items():
        known = (assessment.certainty or {}).get(key)
        rows += [] if known is None else [_parts("", label, unit, decimals, known)]
    return rows


def _parts(
    pantograph: str, label: str, unit: str, decimals: int, known: Mapping[str, float | None]
) -> dict[str, Any]:
    texts = {name: number(known[name], decimals + 1) for name in ("spread", "discretisation")}
    return {"pantograph": pantograph, "label": label, "unit": unit, **texts}


def fact_pairs(scene: RunData) -> list[tuple[str, str]]:
    """Return the facts of the whole run as label and text."""
    a = scene.assessment
    begin, end = a.section_m
    residual = a.energy_residual_relative
    droppers = [
        ("lowest dropper force", f"{_with_certainty(a, 'min_dropper_force_N', 1)} N"),
        ("most droppers slack at once", _with_certainty(a, "slack_droppers_max", 0)),
    ]
    return [
        ("speed", f"{number(3.6 * a.speed_m_s)} km/h"),
        ("section assessed", f"{begin:.0f} to {end:.0f} m"),
        ("highest uplift at a support", f"{_with_certainty(a, 'max_uplift_at_support_mm', 1)} mm"),
        *(droppers if scene.has_droppers else []),
        ("energy residual, relative", "–" if residual is None else f"{residual:.1e}"),
        ("time steps", f"{a.steps:,}".replace(",", " ")),
        ("time-stepping loop", f"{number(a.wall_time_s, 2)} s"),
        ("set-up", f"{number(a.setup_time_s, 2)} s"),
        ("real-time factor", number(a.real_time_factor)),
    ]


def criterion_rows(assessment: Assessment) -> list[dict[str, Any]]:
    """Return the criteria as text; text that repeats the row above is left empty."""
    above = ["", *(c.name for c in assessment.criteria)]
    return [
        {
            "title": "" if c.name == previous else c.title,
            "pantograph": c.pantograph or "",
            "value": pair(c.value, uncertainty_of(c.certainty), _decimals(c)),
            "limit": f"{SIGNS[c.relation]} {number(c.limit, _decimals(c))}{allowance(asdict(c))}",
            "unit": "" if c.unit == "1" else c.unit,
            "verdict": verdict_of(asdict(c)),
            "state": "missed" if c.fails else verdict_of(asdict(c)).split(" (")[0],
            "mark": c.mark,
            "source": "" if c.name == previous else c.source,
            "note": "" if c.name == previous else c.note,
            "reason": _reason(c),
        }
        for c, previous in zip(assessment.criteria, above, strict=False)
    ]


def _reason(criterion: Criterion) -> str:
    """Return why a criterion is too close to tell, which its verdict says already."""
    if criterion.reason is None or verdict_of(asdict(criterion)) != TOO_CLOSE:
        return ""
    return criterion.reason.removeprefix(f"{TOO_CLOSE}: ")


def reference_cells(rows: Sequence[Mapping[str, Any]]) -> list[dict[str, str]]:
    """Return reference rows as text: numbers to four digits, a dash where there is none."""
    return [{key: _cell(row.get(key)) for key in REFERENCE_KEYS} for row in rows]


def energy_rows(scene: RunData) -> list[tuple[str, str, str]]:
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


def _decimals(criterion: Criterion) -> int:
    """Return the decimals of a criterion's numbers: one more where a ± must show."""
    return {"%": 3, "1": 3}.get(criterion.unit, 1 if criterion.certainty is None else 2)
