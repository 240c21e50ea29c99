"""First screen of a run's page: identity, verdict, criteria as bars with their limits."""

from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from itertools import groupby, pairwise
from typing import Any

import numpy as np

from arcless.assess import (
    MET,
    NOT_JUDGED,
    NOT_MET,
    NOT_MET_UNVERIFIED,
    RELATION_SIGNS,
    RULES,
    TOO_CLOSE,
    Assessment,
    Criterion,
    decides,
    decimals_of,
    is_at_limit,
    shown_verdict,
    uncertainty_of,
    verdict_of,
)
from arcless.display.cards import SIGNS
from arcless.display.numbers import difference, number, pair
from arcless.figures.run.along_track import worst
from arcless.figures.run.run_data import RunData
from arcless.figures.run.track import place_name
from arcless.model import Scenario
from arcless.report.model_data import origin_of_force

# Distance in m within which the end of a section is at a support. Larger, a span that is assessed
# in part is not named; smaller, a rounding error names the next span.
SAME_PLACE = 0.01
# Part of a limit, in per cent, from which a distance to it is not said in per cent.
MOST_PERCENT = 200.0
# Length of a bar in the drawing, places of upper and lower limits on it, the least that is drawn.
LENGTH, UPPER, LOWER, LEAST = 1000.0, 800.0, 200.0, 4.0


@dataclass(frozen=True)
class Verdict:
    """Headline: class for its colour, sign, sentence, the other verdicts, criteria behind it."""

    state: str
    sign: str
    text: str
    rest: str
    items: list[str]


@dataclass(frozen=True)
class Bar:
    """A value against its limit, from 0 to `LENGTH`: parts beyond, the value, ±, the limit."""

    beyond: list[tuple[float, float]]
    begin: float
    width: float
    sure: tuple[float, float] | None
    bound: float


@dataclass(frozen=True)
class Bullet:
    """A criterion on the first screen, as text, and as a bar where it has value and limit."""

    title: str
    pantograph: str
    value: str
    unit: str
    limit: str
    verdict: str
    state: str
    words: str
    bar: Bar | None


def identity(
    scenario: Scenario, assessment: Assessment, facts: Mapping[str, Any]
) -> list[tuple[str, str]]:
    """Return what was run, as label and text."""
    names = [placement.model.name for placement in scenario.pantographs]
    places = [placement.distance for placement in scenario.pantographs]
    gaps = [behind - front for front, behind in pairwise(places)]
    supply = assessment.supply
    if scenario.line.design.supply is None:
        supply += " (assumed)"
    text = ", ".join(dict.fromkeys(names))
    if len(names) > 1:
        text = f"{len(names)} × {text}, {', '.join(f'{one:g} m' for one in gaps)} apart"
    stop = assessment.stopped_m
    return [
        *([] if stop is None else [("Stopped early", f"at {stop:.1f} m")]),
        ("Line", scenario.line.name),
        ("Pantograph" if len(names) == 1 else "Pantographs", text),
        ("Speed", f"{3.6 * assessment.speed_m_s:.4g} km/h"),
        *_static_forces(scenario, facts.get("static_force_found") or {}),
        ("Supply", supply),
        ("Computed", str(facts.get("created", "–"))[:16].replace("T", " ")),
        ("Arcless", str(facts.get("arcless_version", "–"))),
    ]


def _static_forces(scenario: Scenario, found: Mapping[str, float]) -> list[tuple[str, str]]:
    """Return the static forces of the run with their origin; nothing where none is known."""
    alone = len(scenario.pantographs) == 1
    texts = [
        f"{'' if alone else f'{one.name} '}{number(found[one.name])} N, {origin_of_force(one)}"
        for one in scenario.pantographs
        if one.name in found
    ]
    return [("Static force" if alone else "Static forces", "; ".join(texts))] if texts else []


def verdict(assessment: Assessment) -> Verdict:
    """Return the verdict over all criteria: the least favourable one, then how many have which."""
    over_all = assessment.headline
    alone = len(assessment.pantographs) == 1
    items = [_item(replace(one, pantograph=None) if alone else one) for one in assessment.criteria
             if verdict_of(asdict(one)) not in (MET, NOT_JUDGED)]  # fmt: skip
    told = (assessment.measurement or {}).get("pantographs", [])
    items += [text for each in told for text in each["doubts"]]
    sign = SIGNS[over_all.state]
    return Verdict(over_all.state, sign, over_all.text, over_all.rest, items)


def leading(assessment: Assessment) -> Criterion | None:
    """Return the criterion that a line of few words names: of the least favourable verdict.

    Of several the one that is furthest beyond its limit, or nearest to it: the margin as a part of
    the limit, of the mean force where the limit is a force of zero. Where all are met it is the
    largest standard deviation; None where nothing has a value and a limit.
    """
    means = {one.name: one.mean_force_N for one in assessment.pantographs}

    def share(one: Criterion) -> float:
        size = abs(one.limit or 0.0) or abs(means.get(one.pantograph or "", 0.0)) or 1.0
        return (one.margin or 0.0) / size

    known = [one for one in assessment.criteria if one.value is not None and one.limit is not None]
    for word in (NOT_MET, NOT_MET_UNVERIFIED, TOO_CLOSE):
        of_word = [one for one in known if verdict_of(asdict(one)) == word]
        if of_word:
            return min(of_word, key=share)
    deviations = [one for one in known if one.name == "standard_deviation"]
    return max(deviations, key=lambda one: one.value or 0.0, default=None)


def judged_on(run: RunData) -> str:
    """Return the section that the verdict is of, the spans in it, and who chose it, in words."""
    begin, end = run.assessment.section_m
    supports = run.supports
    text = f"Judged on {begin:.0f}–{end:.0f} m"
    if supports.size < 2:  # noqa: PLR2004 - a span has two supports
        return f"{text}."
    count = supports.size - 1
    inside = (supports[1:] > begin + SAME_PLACE) & (supports[:-1] < end - SAME_PLACE)
    numbers = np.flatnonzero(inside) + 1
    if not numbers.size:
        return f"{text}."
    spans = f"spans {numbers[0]} to {numbers[-1]}" if numbers.size > 1 else f"span {numbers[0]}"
    return f"{text}, {spans} of {count}."


def worst_place(run: RunData) -> str:
    """Return the place with the largest deviation from the mean, in words."""
    pantograph, kind, x, force = worst(run)
    of = f" of {run.pantographs[pantograph]}" if len(run.pantographs) > 1 else ""
    why = " (the low-pass undershoots where contact is lost)" if force < 0.0 else ""
    return f"{kind} contact force{of}, {number(force, 0)} N{why}, at {place_name(run, x)}."


def bullets(assessment: Assessment) -> list[Bullet]:
    """Return the criteria as bars, in the order of the table."""
    means = {p.name: p.mean_force_N for p in assessment.pantographs}
    alone = len(means) == 1
    return [
        _bullet(replace(one, pantograph=None) if alone else one,
                means.get(one.pantograph or "", 0.0))
        for one in assessment.criteria
    ]  # fmt: skip


def grouped(found: list[Bullet]) -> list[list[Bullet]]:
    """Return neighbours of one criterion together: those of several pantographs."""
    return [list(same) for _, same in groupby(found, key=lambda one: one.title)]


def _item(criterion: Criterion) -> str:
    """Return a criterion that is not met, or too close to tell: value, limit, distance."""
    data = asdict(criterion)
    decimals = decimals_of(data)
    value, limit, words = criterion.value, criterion.limit, verdict_of(data)
    assert value is not None and limit is not None, "only what was compared has such a verdict"
    of = f", {criterion.pantograph}" if criterion.pantograph else ""
    unit = "" if criterion.unit == "1" else f" {criterion.unit}"
    side = "above" if value > limit else "below"
    apart = difference(max(value, limit), min(value, limit), decimals)
    distance = f"{apart}{unit} {side} it"
    share = 100.0 * abs(value / limit - 1.0) if limit else MOST_PERCENT
    if share < MOST_PERCENT and words != TOO_CLOSE:
        distance += f" ({share:.0f} %)"
    if is_at_limit(data):
        distance = f"{side} it by less than {10.0**-decimals:g}{unit}"
    uncertainty = uncertainty_of(criterion.certainty)
    if words == TOO_CLOSE:
        distance += f", certain to ± {number(uncertainty, decimals)}{unit} only"
    unsure = (
        "" if decides(criterion.mark) else f"; the limit is not verified, mark {criterion.mark}"
    )
    stated = _limit(criterion, decimals)
    return f"{criterion.title}{of}: {number(value, decimals)}{unit}, {stated}, {distance}{unsure}"


def _bullet(criterion: Criterion, mean_force_N: float) -> Bullet:
    data = asdict(criterion)
    decimals = decimals_of(data)
    unit = "" if criterion.unit == "1" or criterion.value is None else criterion.unit
    uncertainty = uncertainty_of(criterion.certainty)
    value = pair(criterion.value, uncertainty, decimals)
    limit = _limit(criterion, decimals)
    words = verdict_of(data)
    state = "met" if words == MET else "not-met" if criterion.fails else "open"
    words = shown_verdict(data)
    return Bullet(
        criterion.title, criterion.pantograph or "", value, unit, limit, words, state,
        f"{value} {unit}, {limit}: {words}", _bar(criterion, uncertainty, mean_force_N),
    )  # fmt: skip


def _limit(criterion: Criterion, decimals: int) -> str:
    """Return a limit with its relation, its origin where it is a part of F_m, and its tolerance."""
    if criterion.limit is None:
        return "no limit given"
    unit = "" if criterion.unit == "1" else f" {criterion.unit}"
    text = f"limit {RELATION_SIGNS[criterion.relation]} {number(criterion.limit, decimals)}{unit}"
    factors = {rule.limit.factor for rule in RULES
               if rule.name == criterion.name and rule.limit.of == "mean_force_N"}  # fmt: skip
    text += "".join(f" = {factor:g} F_m" for factor in factors)
    tolerance = f", tolerance {criterion.tolerance:g}{unit}" if criterion.tolerance else ""
    return text + tolerance


def _bar(criterion: Criterion, uncertainty: float | None, mean_force_N: float) -> Bar | None:
    """Return a value against its limit; None where either is missing.

    Limits have the same place on all bars: upper ones at `UPPER`, zero at the beginning; lower ones
    at `LOWER`, the mean force, or the value itself, as far behind it as there is room. A value
    beyond the end is drawn up to the end.
    """
    value, limit = criterion.value, criterion.limit
    if value is None or limit is None:
        return None
    upper = criterion.relation == "<="
    if upper:
        size, bound = max(abs(limit), 1e-12) / UPPER, UPPER
    else:
        of_force = mean_force_N if criterion.unit == "N" else 0.0
        bound = LOWER
        size = max(of_force, abs(value - limit), 1e-12) / (LENGTH - LOWER)

    def place(number: float) -> float:
        return round(min(max(bound + (number - limit) / size, 0.0), LENGTH), 1)

    beyond = [(bound, LENGTH - bound)] if upper else [(0.0, bound)]
    sure = None
    if uncertainty is not None:
        sure = (place(value - uncertainty), place(value + uncertainty))
    return Bar(beyond, 0.0, max(place(value), LEAST), sure, bound)  # a value of 0 is seen too
