"""Limits of outputs, from the rules of the assessment and the scene of each variant."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.assess import NOT_MET, NOT_MET_UNVERIFIED, decides
from arcless.assess.rules import ANY_SUPPLY, ASSUMED, RULES, Facts, Rule, mark_of
from arcless.study.definition.quantities import owner_of_key
from arcless.study.report.data.judged import CODES, Codes
from arcless.study.report.data.record import Column, RowColumns
from arcless.study.report.data.scenes import TARGET_MET_N, Scene

MEAN = "mean_force_N"
_UPLIFT = "max_uplift_at_support_mm"
# Space that an uplift asks for over the uplift itself, without and with a mechanical limit.
_SPACE = {False: 2.0, True: 1.5}


@dataclass(frozen=True)
class _Known:
    """The little of a pantograph's assessment that limits are computed from."""

    name: str
    mean_force_N: float | None  # noqa: N815 - a quantity of the assessment


def rule_of(name: str, facts: Facts) -> Rule | None:
    """Return the rule of a criterion at the speed and supply of a variant; None for none."""
    return next((rule for rule in RULES if rule.name == name and rule.applies(facts)), None)


def judges(rule: Rule, quantity: str) -> bool:
    """Return whether a rule is about a quantity, or about what follows from it alone."""
    return rule.quantity == quantity or (rule.name == "uplift_space" and quantity == _UPLIFT)


def known_of(record: RowColumns, place: int, mean_force: float | None = None) -> Any:
    """Return a pantograph of a study as the rules take it."""
    return _Known(record.study.base.pantographs[place].name, mean_force)


@dataclass(frozen=True)
class CriterionRules:
    """The rule of a criterion in each variant; one that holds in none is the first of the table.

    Attributes
    ----------
    first
        The rule of the first variant that has one.
    sure
        Whether it decides in a variant: the mark of every pantograph's limit does.
    marks, source
        Of all variants.
    owners
        All pantographs, from 0.
    """

    first: Rule
    sure: NDArray[np.bool_]
    marks: tuple[str, ...]
    source: str
    owners: tuple[int, ...]

    @classmethod
    def of(cls, record: RowColumns, name: str, scenes: Sequence[Scene | None]) -> "CriterionRules":
        """Return the rules of a criterion, by supply and speed of each variant."""
        owners = tuple(range(len(record.study.base.pantographs)))
        rules = [None if scene is None else rule_of(name, scene.facts) for scene in scenes]
        # Where speed or supply is not known, any rule of the name may be the one.
        any_of = {rule.mark if rule.supplies == ANY_SUPPLY else ASSUMED
                  for rule in RULES if rule.name == name}  # fmt: skip
        marks = [
            any_of if scene is None else set() if rule is None
            else {mark_of(rule, scene.facts, known_of(record, place)) for place in owners}
            for rule, scene in zip(rules, scenes, strict=True)
        ]  # fmt: skip
        found = [rule for rule in rules if rule is not None] or [
            next(rule for rule in RULES if rule.name == name)
        ]
        sure = np.array([bool(each) and all(map(decides, each)) for each in marks], dtype=bool)
        return cls(
            found[0], sure, tuple(sorted(set().union(*marks))),
            "; ".join(dict.fromkeys(rule.source for rule in found)), owners,
        )  # fmt: skip

    def codes(self, codes: Codes) -> Codes:
        """Return verdicts with those not met unverified where the limit does not decide."""
        unsure = ~self.sure & (codes == CODES[NOT_MET])
        return np.where(unsure, CODES[NOT_MET_UNVERIFIED], codes).astype(np.int8)


class Limits:
    """Limits of an output.

    Parameters
    ----------
    record
        The study.
    owners
        Pantographs that the output may be of, from 0.
    share
        True where the output is the quantity over what its limit is a part of.
    """

    def __init__(self, record: RowColumns, owners: tuple[int, ...], *, share: bool) -> None:
        self._record, self._owners, self._share = record, owners, share
        self._means = {
            place: column
            for column in record.outputs
            if (place := _mean_of(record, column)) is not None
        }

    def ends(self, rule: Rule, scene: Scene, row: int) -> list[float]:
        """Return the ends of the range in which the limit of a variant lies; none if unknown."""
        if self._share:
            return [rule.limit.factor]
        found: list[float] = []
        for place in self._owners:
            mean, slack = self._mean(scene, place, row)
            limit = rule.limit.value(scene.facts, known_of(self._record, place, mean))
            if limit is None:
                return []
            if rule.name == "uplift_space":
                limit /= _SPACE[scene.facts.uplift_limited]
            wide = rule.limit.factor * slack if rule.limit.of == MEAN else 0.0
            found += [limit - wide, limit + wide]
        return found

    def mark(self, rule: Rule, facts: Facts) -> str:
        """Return the mark of the limit of a variant."""
        return mark_of(rule, facts, known_of(self._record, self._owners[0]))

    def words(self, rule: Rule) -> str:
        """Return where a limit is from."""
        if rule.limit.of == MEAN and not self._share:
            measured = all(place in self._means for place in self._owners)
            whose = "of the variant" if measured else "that the scenario requires"
            return f"{rule.limit.factor:g} × the mean force {whose}"
        if rule.limit.per_speed_squared:
            return f"{rule.limit.per_speed_squared:g} v² + {rule.limit.constant:g}, v in km/h"
        from_rules = rule.limit.of is None or self._share
        return "limit from the rules" if from_rules else "limit from the scenario"

    def _mean(self, scene: Scene, place: int, row: int) -> tuple[float | None, float]:
        """Return the mean force of a pantograph in N, and how far it may be from that."""
        column = self._means.get(place)
        if column is not None and np.isfinite(column.values[row]):
            return float(column.values[row]), 0.0
        target = scene.targets[place] if place < len(scene.targets) else None
        return target, TARGET_MET_N


def _mean_of(record: RowColumns, column: Column) -> int | None:
    """Return the pantograph whose mean force an output is."""
    text = record.study.expressions[column.name].text.strip()
    if text.rpartition(".")[2] != MEAN:
        return None
    owner = owner_of_key(text, record.study.base)
    return owner if isinstance(owner, int) else None
