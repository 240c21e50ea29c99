"""Numbers of the assessment as text for the page's tables."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import Any

from arcless.assess import (
    RELATION_SIGNS,
    TOO_CLOSE,
    Assessment,
    Criterion,
    allowance,
    decimals_of,
    shown_verdict,
    uncertainty_of,
    verdict_of,
)
from arcless.assess.quantities import OF_LINE, OF_PANTOGRAPH, WEAR, label_of
from arcless.display.numbers import difference, number, pair, real_minus
from arcless.figures.run.energy import energy_terms, settled
from arcless.figures.run.run_data import RunData

# Labels of the times that a machine took, which are no part of a document that is signed.
STEPS_TOOK, SET_UP_TOOK = "wall time of the time steps", "wall time of the set-up"
REAL_TIME = "real-time factor, simulated over wall time"
TIMES = {STEPS_TOOK, SET_UP_TOOK, REAL_TIME}
REFERENCE_KEYS = ("quantity", "value", "low", "high", "verdict", "mark", "source")


def indicator_rows(assessment: Assessment) -> list[tuple[str, str, list[str]]]:
    """Return label, unit and one value per pantograph for every indicator."""
    rows = []
    worn = assessment.pantographs[0].wear_mechanical_mm3_km is not None
    for key, quantity in ({**OF_PANTOGRAPH, **WEAR} if worn else OF_PANTOGRAPH).items():
        values = [_with_certainty(p, key, quantity.decimals) for p in assessment.pantographs]
        rows.append((_label(assessment, key), quantity.unit, values))
    return rows


def line_rows(run: RunData) -> list[tuple[str, str, str]]:
    """Return label, unit and value of the line's numbers."""
    keys = OF_LINE if run.has_droppers else ["max_uplift_at_support_mm"]
    return [
        (OF_LINE[key].label, OF_LINE[key].unit,
         _with_certainty(run.assessment, key, OF_LINE[key].decimals))
        for key in keys
    ]  # fmt: skip


def number_rows(run: RunData) -> list[list[tuple[str, str, list[str]]]]:
    """Return the numbers in two parts: forces of the pantographs, then all others."""
    rows = indicator_rows(run.assessment)
    line = [(label, unit, [value]) for label, unit, value in line_rows(run)]
    forces = [row for row in rows if row[1] == "N"]
    return [forces, [row for row in rows if row[1] != "N"] + line]


def _label(assessment: Assessment, key: str) -> str:
    low_pass, split = assessment.low_pass_Hz, assessment.band_split_Hz
    return label_of(key, low_pass_Hz=low_pass, band_split_Hz=split)


def _with_certainty(of: Any, key: str, decimals: int) -> str:
    """Return a number of a pantograph or of the run, with how sure it is where that is known."""
    known = uncertainty_of((of.certainty or {}).get(key))
    return pair(getattr(of, key), known, decimals)


def certainty_rows(assessment: Assessment) -> list[dict[str, Any]]:
    """Return spread and discretisation of every number of a pantograph, and of those of the run."""
    rows = []
    for p in assessment.pantographs:
        for key in (*OF_PANTOGRAPH, *WEAR):
            known = (p.certainty or {}).get(key)
            rows += [] if known is None else [_parts(assessment, p.name, key, known)]
    for key in OF_LINE:
        known = (assessment.certainty or {}).get(key)
        rows += [] if known is None else [_parts(assessment, "", key, known)]
    return rows


def _parts(
    assessment: Assessment, pantograph: str, key: str, known: Mapping[str, float | None]
) -> dict[str, Any]:
    quantity = {**OF_PANTOGRAPH, **WEAR, **OF_LINE}[key]
    texts = {
        name: number(known[name], quantity.decimals + 1) for name in ("spread", "discretisation")
    }
    label = _label(assessment, key)
    return {"pantograph": pantograph, "label": label, "unit": quantity.unit, **texts}


def computation(run: RunData, facts: Mapping[str, Any]) -> list[tuple[str, str]]:
    """Return the facts of the computation as label and text."""
    a = run.assessment
    residual, step = a.energy_residual_relative, facts.get("time_step_s")
    return [
        ("time steps", f"{a.steps:,}".replace(",", " ")),
        ("time step", "–" if step is None else f"{1e3 * float(step):.4g} ms"),
        ("scheme", _scheme(facts)),
        ("simulated time", f"{float(facts['simulated_time_s']):.2f} s"),
        (STEPS_TOOK, f"{number(a.wall_time_s, 2)} s"),
        (SET_UP_TOOK, f"{number(a.setup_time_s, 2)} s"),
        (REAL_TIME, number(a.real_time_factor)),
        ("relative residual of the energy balance", "–" if residual is None else f"{residual:.1e}"),
    ]


def _scheme(facts: Mapping[str, Any]) -> str:
    """Return the scheme of the steps, and why it has a matrix where that was left to `auto`."""
    why = facts.get("why_matrix")
    return f"{facts.get('scheme') or '–'}{f'; a matrix because {why}' if why else ''}"


def criterion_rows(assessment: Assessment) -> list[dict[str, Any]]:
    """Return the criteria as text; text that repeats the row above is left empty."""
    above = ["", *(c.name for c in assessment.criteria)]
    repeated = dict.fromkeys(("title", "source", "note"), "")
    return [
        criterion_row(c) | (repeated if c.name == previous else {})
        for c, previous in zip(assessment.criteria, above, strict=False)
    ]


def criterion_row(c: Criterion) -> dict[str, Any]:
    """Return a criterion as text."""
    decimals = decimals_of(asdict(c))
    return {
        "name": c.name,
        "title": c.title,
        "pantograph": c.pantograph or "",
        "value": pair(c.value, uncertainty_of(c.certainty), decimals),
        "limit": _limit(c, decimals),
        "margin": _margin(c, decimals),
        "unit": "" if c.unit == "1" else c.unit,
        "verdict": shown_verdict(asdict(c)),
        "state": "missed" if c.fails else verdict_of(asdict(c)).split(" (")[0],
        "mark": c.mark,
        "source": c.source,
        "note": c.note,
        "reason": _reason(c),
    }


def _margin(criterion: Criterion, decimals: int) -> str:
    """Return the distance to the limit, negative beyond it, of value and limit as printed."""
    if criterion.value is None or criterion.limit is None:
        return number(None)
    if criterion.relation == "<=":
        return difference(criterion.limit + criterion.tolerance, criterion.value, decimals)
    return difference(criterion.value, criterion.limit - criterion.tolerance, decimals)


def _limit(criterion: Criterion, decimals: int) -> str:
    if criterion.limit is None:
        return "–"
    limit = number(criterion.limit, decimals)
    return f"{RELATION_SIGNS[criterion.relation]} {limit}{allowance(asdict(criterion))}"


def _reason(criterion: Criterion) -> str:
    """Return why a criterion is too close to tell, which its verdict says already."""
    if criterion.reason is None or verdict_of(asdict(criterion)) != TOO_CLOSE:
        return ""
    return criterion.reason.removeprefix(f"{TOO_CLOSE}: ")


def reference_cells(rows: Sequence[Mapping[str, Any]]) -> list[dict[str, str]]:
    """Return reference rows as text: numbers to four digits, a dash where there is none."""
    return [{key: _cell(row.get(key)) for key in REFERENCE_KEYS} for row in rows]


def energy_rows(run: RunData) -> list[tuple[str, str, str]]:
    """Return the label, meaning, and value in J at the end of the run of each term of energy."""
    return [
        (
            label,
            str(run.dataset[name].attrs.get("long_name", "")),
            real_minus(f"{settled(run, name)[-1]:.3g}"),
        )
        for name, label in energy_terms(run)
        if settled(run, name).size
    ]


def _cell(value: Any) -> str:
    if value is None:
        return "–"
    return real_minus(f"{value:.4g}") if isinstance(value, float) else str(value)
