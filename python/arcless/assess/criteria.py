"""Judging a run by the table of rules."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from arcless.assess.rules import ANY_SUPPLY, RULES, Facts, Rule, quantity_of
from arcless.assess.statistics import PantographAssessment


@dataclass(frozen=True)
class Criterion:
    """One criterion with its verdict; ``passed`` is None when it could not be judged."""

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


RELATIONS: dict[str, Callable[[float, float, float], bool]] = {
    "<=": lambda value, limit, tolerance: value <= limit + tolerance,
    ">=": lambda value, limit, tolerance: value >= limit - tolerance,
    ">": lambda value, limit, tolerance: value > limit - tolerance,
}


def evaluate(facts: Facts, pantographs: list[PantographAssessment]) -> list[Criterion]:
    """Judge every rule that applies, for every pantograph where it is the pantograph's.

    Parameters
    ----------
    facts
        Supply, speed, and what belongs to the line.
    pantographs
        Their indicators; at least one.
    """
    return [
        _judge(rule, facts, pantograph)
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


def _judge(rule: Rule, facts: Facts, pantograph: PantographAssessment) -> Criterion:
    value = quantity_of(rule.quantity, facts, pantograph)
    limit = rule.limit.value(facts, pantograph)
    passed, note = None, rule.note
    if value is None:
        note = "not judged: the value is not in the record"
    elif limit is None:
        note = "not judged: the line's design data give no limit"
    else:
        passed = RELATIONS[rule.relation](value, limit, rule.tolerance)
    return Criterion(
        name=rule.name,
        value=value,
        limit=limit,
        passed=passed,
        source=rule.source,
        mark=rule.mark,
        title=rule.title,
        relation=rule.relation,
        unit=rule.unit,
        pantograph=None if rule.whole_run else pantograph.name,
        note=note,
    )


def _markdown_row(rule: Rule) -> str:
    supply = "any" if rule.supplies == ANY_SUPPLY else ", ".join(rule.supplies)
    above, up_to = rule.speeds_km_h
    parts = [f"> {above:g}"] * (above > 0.0) + [f"≤ {up_to:g}"] * (up_to < float("inf"))
    relation = {"<=": "≤", ">=": "≥", ">": ">"}[rule.relation]
    cells = (
        f"`{rule.name}`", supply, ", ".join(parts) or "any", rule.quantity, relation,
        str(rule.limit), rule.unit, rule.mark, rule.source,
    )  # fmt: skip
    return f"| {' | '.join(cells)} |"
