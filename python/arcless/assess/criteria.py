"""Judging a run by the table of rules."""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from typing import Any

from arcless.assess.certainty import Certainty, Draws
from arcless.assess.rules import ANY_SUPPLY, RULES, Facts, Rule, decides, mark_of, quantity_of
from arcless.assess.statistics import PantographAssessment
from arcless.display.numbers import number

MET, NOT_MET = "met", "not met"
# Beyond a limit that is only remembered or assumed.
NOT_MET_UNVERIFIED = "not met (unverified)"
TOO_CLOSE, NOT_JUDGED = "too close to tell", "not judged"


@dataclass(frozen=True)
class Criterion:
    """One criterion with its verdict.

    ``passed`` is None when it could not be judged, or when it is too close to its limit to tell;
    ``reason`` says which.
    """

    name: str
    value: float | None
    limit: float | None
    passed: bool | None
    source: str
    mark: str
    title: str
    relation: str
    unit: str
    pantograph: str | None
    """None for a criterion of the whole run."""
    note: str
    reason: str | None = None
    """Why there is no verdict; None where there is one."""
    certainty: dict[str, float | None] | None = None
    """Spread and discretisation of value less limit; None where nobody asked."""
    tolerance: float = 0.0
    """Distance that the value may lie beyond the limit, in its unit."""

    @property
    def fails(self) -> bool:
        """True when it is not met, by a limit that decides: one that was not merely remembered."""
        return self.passed is False and decides(self.mark)

    @property
    def margin(self) -> float | None:
        """Distance of the value to the limit with its tolerance, negative beyond it; None for none.

        With the tolerance τ it is (limit + τ) − value for "<=" and value − (limit − τ) for ">="
        and ">". A difference of two floats has the sign of their comparison, so "<=" and ">=" are
        met exactly where it is 0 or more, and ">" where it is above 0.
        """
        if self.value is None or self.limit is None:
            return None
        if self.relation == "<=":
            return (self.limit + self.tolerance) - self.value
        return self.value - (self.limit - self.tolerance)

    def __repr__(self) -> str:
        data, decimals = asdict(self), decimals_of(asdict(self))
        of = "" if self.pantograph is None else f" of {self.pantograph}"
        unit = "" if self.unit == "1" else f" {self.unit}"
        limit = f"{RELATION_SIGNS[self.relation]} {number(self.limit, decimals)}{allowance(data)}"
        value = f"{number(self.value, decimals)}{unit}, limit {limit}{unit}"
        return f"<Criterion {self.name}{of}: {value}: {shown_verdict(data)}>"


def is_withheld(criterion: Mapping[str, Any]) -> bool:
    """Return whether a criterion, given as plain data, has value and limit but is not judged."""
    known = criterion["value"] is not None and criterion["limit"] is not None
    return known and verdict_of(criterion) == NOT_JUDGED


def verdict_of(criterion: Mapping[str, Any]) -> str:
    """Return the verdict on a criterion, given as plain data, in words."""
    if criterion["passed"] is not None:
        missed = NOT_MET if decides(criterion["mark"]) else NOT_MET_UNVERIFIED
        return MET if criterion["passed"] else missed
    return TOO_CLOSE if (criterion.get("reason") or "").startswith(TOO_CLOSE) else NOT_JUDGED


def allowance(criterion: Mapping[str, Any]) -> str:
    """Return the text after a printed limit: the tolerance of the comparison, if there is one."""
    if not criterion["tolerance"] or criterion["limit"] is None:
        return ""
    return f" {'−' if criterion['relation'].startswith('>') else '+'} {criterion['tolerance']:g}"


def uncertainty_of(certainty: Mapping[str, float | None] | None) -> float | None:
    """Return spread and discretisation together; None where neither is known."""
    return None if certainty is None else Certainty(**certainty).uncertainty


# Decimals of a criterion's numbers by its unit, and those at which numbers are as good as equal.
_DECIMALS: Mapping[str, int] = {"%": 2, "1": 3, "mm": 0}
_MOST_DECIMALS = 4
AT_LIMIT = "at the limit"


def decimals_of(criterion: Mapping[str, Any]) -> int:
    """Return the decimals of a criterion's numbers, given as plain data.

    They are so many that value and limit look different, but no more than are known: two digits of
    the uncertainty or, where that is not known, one decimal more than usual. Numbers that still
    look alike have the usual decimals, and are said to be at the limit: see `is_at_limit`.
    """
    least = _DECIMALS.get(criterion["unit"], 1)
    value, limit = criterion["value"], criterion["limit"]
    found = telling_decimals(value, [limit], least)
    if found <= _known_decimals(criterion, least):
        return found
    return least


def _known_decimals(criterion: Mapping[str, Any], least: int) -> int:
    """Return the decimals that mean something."""
    uncertainty = uncertainty_of(criterion.get("certainty"))
    if uncertainty is None:
        return least + 1
    if uncertainty == 0.0:
        return _MOST_DECIMALS
    return max(least, min(1 - math.floor(math.log10(uncertainty)), _MOST_DECIMALS))


def is_at_limit(criterion: Mapping[str, Any]) -> bool:
    """Return whether value and limit look alike and are not the same, given as plain data."""
    value, limit = criterion["value"], criterion["limit"]
    if value is None or limit is None or value == limit:
        return False
    decimals = decimals_of(criterion)
    return number(value, decimals) == number(limit, decimals)


def shown_verdict(criterion: Mapping[str, Any]) -> str:
    """Return the verdict as a table shows it: with a word where rounding hides the difference."""
    words = verdict_of(criterion)
    judged = criterion["passed"] is not None and is_at_limit(criterion)
    return f"{words}, {AT_LIMIT}" if judged else words


def telling_decimals(value: float | None, bounds: Sequence[float | None], least: int) -> int:
    """Return so many decimals that a value looks different from the bounds that it differs from."""
    others = [bound for bound in bounds if bound is not None and bound != value]
    if value is None:
        return least
    for decimals in range(least, _MOST_DECIMALS):
        if all(f"{value:.{decimals}f}" != f"{bound:.{decimals}f}" for bound in others):
            return decimals
    return _MOST_DECIMALS


@dataclass(frozen=True)
class Reasons:
    """Reasons why a criterion is not judged, by its name where that can be said more closely.

    Attributes
    ----------
    absent, without_limit
        Why there is no value, and no limit.
    usual_absent, usual_limit
        The same for criteria that are not named.
    of_pantograph
        Why nothing of a pantograph is judged, by its name: its forces are not contact forces.
    of_verdict
        Why one verdict cannot be given, by pantograph, criterion, and whether it would be met: the
        value is known to be a bound only.
    """

    absent: Mapping[str, str]
    without_limit: Mapping[str, str]
    usual_absent: str = "the value is not in the record"
    usual_limit: str = "the line's design data give no limit"
    of_pantograph: Mapping[str, str] = field(default_factory=dict)
    of_verdict: Mapping[tuple[str, str, bool], str] = field(default_factory=dict)


OF_RUN = Reasons(
    absent={
        "lateral_position": "the run is planar, so the wire has no lateral position",
        "wave_speed_use": "a rail has no wave speed, and older results do not name that of a wire",
    },
    without_limit={
        "lateral_position": "limits are known for a head_width of 1.60 m and 1.95 m only; the"
        " pantograph gives no such head_width and no lateral_range",
    },
)
OF_MEASUREMENT = Reasons(
    absent={},
    without_limit={},
    usual_absent="the file has no column for it",
    usual_limit="a measurement knows no design data of the line",
)

# Relations as printed.
RELATION_SIGNS: Mapping[str, str] = {"<=": "≤", ">=": "≥", ">": ">"}
RELATIONS: dict[str, Callable[[float, float, float], bool]] = {
    "<=": lambda value, limit, tolerance: value <= limit + tolerance,
    ">=": lambda value, limit, tolerance: value >= limit - tolerance,
    ">": lambda value, limit, tolerance: value > limit - tolerance,
}


def evaluate(
    facts: Facts,
    pantographs: list[PantographAssessment],
    draws: Draws | None = None,
    reasons: Reasons = OF_RUN,
) -> list[Criterion]:
    """Judge every rule that applies, for every pantograph where it is the pantograph's.

    Parameters
    ----------
    facts
        Supply, speed, and what belongs to the line.
    pantographs
        Their indicators; at least one.
    draws
        The runs that say how sure the numbers are; None where there are none.
    reasons
        Texts for criteria that are not judged.
    """
    return [
        _sure(rule, _judge(rule, facts, pantograph, reasons), draws)
        for rule in _rules_for(facts)
        for pantograph in (pantographs[:1] if rule.whole_run else pantographs)
    ]


def markdown_table() -> str:
    """Return the rules as a Markdown table, for the guide."""
    head = "| name | supply | km/h | value | | limit | unit | mark | source |"
    return "\n".join([head, "|" + "---|" * 9, *map(_markdown_row, RULES)]) + "\n"


def _rules_for(facts: Facts) -> Iterator[Rule]:
    seen: set[str] = set()
    for rule in RULES:
        if rule.applies(facts) and rule.name not in seen:
            seen.add(rule.name)
            yield rule


def _judge(
    rule: Rule, facts: Facts, pantograph: PantographAssessment, reasons: Reasons
) -> Criterion:
    value = quantity_of(rule.quantity, facts, pantograph)
    limit = rule.limit.value(facts, pantograph)
    passed, note, reason = None, rule.note, None
    if value is None:
        reason = reasons.absent.get(rule.name, reasons.usual_absent)
    elif limit is None:
        reason = reasons.without_limit.get(rule.name, reasons.usual_limit)
    elif not rule.whole_run and pantograph.name in reasons.of_pantograph:
        reason = reasons.of_pantograph[pantograph.name]
    else:
        passed = RELATIONS[rule.relation](value, limit, rule.tolerance)
        reason = reasons.of_verdict.get((pantograph.name, rule.name, passed))
        passed = None if reason is not None else passed
    return Criterion(
        name=rule.name,
        value=value,
        limit=limit,
        passed=passed,
        source=rule.source,
        mark=mark_of(rule, facts, pantograph),
        title=rule.title,
        relation=rule.relation,
        unit=rule.unit,
        pantograph=None if rule.whole_run else pantograph.name,
        note=note if reason is None else f"{NOT_JUDGED}: {reason}",
        reason=reason,
        tolerance=rule.tolerance,
    )


def _sure(rule: Rule, criterion: Criterion, draws: Draws | None) -> Criterion:
    """Take a verdict back that the next run, or the other family of elements, might turn."""
    judged = criterion.name, criterion.pantograph
    pair = criterion.value, criterion.limit
    known = None if draws is None else draws.of_criterion(judged, pair)
    if known is None or criterion.value is None or criterion.limit is None:
        return criterion
    sure = replace(criterion, certainty=asdict(known))
    if criterion.passed is None:
        return sure
    allowed = rule.tolerance if rule.relation == "<=" else -rule.tolerance
    distance, uncertainty = abs(criterion.value - criterion.limit - allowed), known.uncertainty
    if uncertainty is None or distance >= uncertainty:
        return sure
    parts = [
        f"{name} {_short(part)}"
        for name, part in (("spread", known.spread), ("discretisation", known.discretisation))
        if part is not None
    ]
    unit = "" if rule.unit == "1" else f" {rule.unit}"
    beyond = " with its tolerance" if rule.tolerance else ""
    reason = (
        f"{TOO_CLOSE}: {_short(distance)}{unit} from the limit{beyond}, and sure to"
        f" {_short(uncertainty)}{unit} only ({', '.join(parts)})"
    )
    return replace(sure, passed=None, reason=reason)


def _short(value: float) -> str:
    """Return a number to two digits, or to whole ones where it has more."""
    return f"{value:.0f}" if value >= 100.0 else f"{value:.2g}"  # noqa: PLR2004 - three digits


def _markdown_row(rule: Rule) -> str:
    supply = "any" if rule.supplies == ANY_SUPPLY else ", ".join(rule.supplies)
    above, up_to = rule.speeds_km_h
    parts = [f"> {above:g}"] * (above > 0.0) + [f"≤ {up_to:g}"] * (up_to < float("inf"))
    relation = RELATION_SIGNS[rule.relation]
    cells = (
        f"`{rule.name}`", supply, ", ".join(parts) or "any", rule.quantity, relation,
        str(rule.limit), rule.unit, rule.mark, rule.source,
    )  # fmt: skip
    return f"| {' | '.join(cells)} |"
