"""Outputs of a study against the limits of the assessment, variant by variant.

A row holds outputs and values, not criteria. What is judged here is what follows from them: an
output that is an assessed quantity, by a limit from the rules and the variant's own scenario; a
criterion that is an output; and the speed over the wave speed, which the scenario alone has.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.assess import MET, NOT_JUDGED, NOT_MET, NOT_MET_UNVERIFIED, TOO_CLOSE, RULES, decides
from arcless.assess.criteria import RELATIONS
from arcless.assess.rules import Facts, Rule, mark_of
from arcless.study.definition.quantities import WORST, owner_of_key
from arcless.study.report.data.record import Column, Floats, Record
from arcless.study.report.data.scenes import TARGET_MET_N, Scene, Scenes

VERDICTS = (NOT_JUDGED, MET, NOT_MET, NOT_MET_UNVERIFIED, TOO_CLOSE)
CODES = {verdict: code for code, verdict in enumerate(VERDICTS)}
Codes = NDArray[np.int8]
_UPLIFT, _WAVE, _MEAN = "max_uplift_at_support_mm", "wave_speed_use", "mean_force_N"
_RULES: Mapping[str, Rule] = {rule.name: rule for rule in reversed(RULES)}


@dataclass(frozen=True, eq=False)
class Judged:
    """One criterion over the rows that are done.

    Attributes
    ----------
    name, title
        Of the criterion.
    output
        Output whose values are judged; None for a number that the scenario alone has.
    relation
        ``"<="``, ``">="`` or ``">"``; empty where the output is the verdict itself.
    values, limits
        In the unit of the output; NaN for one that is not known.
    codes
        Places in `VERDICTS`.
    unit
        Of value and limit.
    sure
        Whether the limit of a variant decides.
    marks, source
        Of the limits.
    how
        Where the limit is from, in words.
    owners
        Pantographs that it tells about, from 0.
    """

    name: str
    title: str
    output: Column | None
    relation: str
    values: Floats
    limits: Floats
    codes: Codes
    unit: str
    sure: NDArray[np.bool_]
    marks: tuple[str, ...]
    source: str
    how: str
    owners: tuple[int, ...]

    @property
    def decides(self) -> bool:
        """True where the limit of any variant decides."""
        return bool(self.sure.any())

    @property
    def heading(self) -> str:
        """Title of the criterion, and the pantograph."""
        of = self.output.of if self.output is not None and self.relation else ""
        return f"{self.title}, {of}" if of else self.title

    def count(self, *verdicts: str) -> int:
        """Return how many variants have one of these verdicts."""
        return int(np.isin(self.codes, [CODES[one] for one in verdicts]).sum())


@dataclass(frozen=True, eq=False)
class Verdicts:
    """All that could be judged.

    Attributes
    ----------
    items
        By output and criterion.
    codes
        Verdict on each variant, over what decides.
    whole
        True where an output says whether all criteria are met.
    unknown
        Criteria that decide and that no output tells, in words.
    """

    items: tuple[Judged, ...]
    codes: Codes
    whole: bool
    unknown: tuple[str, ...] = field(default=())

    def of(self, output: Column) -> list[Judged]:
        """Return the criteria of an output that have limits, those that decide first."""
        found = [one for one in self.items if one.output is output and one.relation]
        return sorted(found, key=lambda one: not one.decides)


def judge(record: Record) -> Verdicts:
    """Return what the rows of a study tell about the criteria."""
    scenes, speeds = Scenes(record.study), _column_of(record, "speed_m_s")
    found = [
        scenes.of(row, None if speeds is None else float(speeds.values[place]))
        for place, row in enumerate(record.done)
    ]
    items = [*_outputs(record, found), *_wave_speed(found)]
    passed = _column_of(record, "passed")
    if passed is not None:
        codes = _codes_of(passed, record, "passed")
        return Verdicts(tuple(items), codes, whole=True)
    return Verdicts(tuple(items), _overall(items, len(found)), False, _unknown(items, found, record))


def _outputs(record: Record, scenes: Sequence[Scene | None]) -> Iterable[Judged]:
    for output in record.outputs:
        expression = record.study.expressions[output.name]
        text = "".join(expression.text.split())
        if text.startswith("criteria."):
            yield _told(record, output, text.partition(".")[2], scenes)
            continue
        prefix, quantity = _split(text)
        if expression.names == {text}:
            names = {rule.name for rule in RULES if _judges(rule, quantity)}
            for name in sorted(names, key=list(_RULES)[::-1].index):
                yield from _limited(record, output, name, text, scenes)
        for rule in RULES:
            if rule.limit.of and text == f"{prefix}{rule.quantity}/{prefix}{rule.limit.of}":
                yield from _limited(record, output, rule.name, text, scenes)


def _split(text: str) -> tuple[str, str]:
    """Return the pantograph of a key with its dot, and the quantity, of the first key of a text."""
    first = text.partition("/")[0]
    prefix, dot, quantity = first.rpartition(".")
    return prefix + dot, quantity


def _judges(rule: Rule, quantity: str) -> bool:
    return rule.quantity == quantity or (rule.name == "uplift_space" and quantity == _UPLIFT)


def _limited(
    record: Record, output: Column, name: str, text: str, scenes: Sequence[Scene | None]
) -> list[Judged]:
    """Return an output against the limits of one criterion; nothing where it has no limit."""
    count = len(record.study.base.pantographs)
    owner = owner_of_key(text.partition("/")[0], record.study.base)
    owners = tuple(range(count)) if owner == WORST else (int(owner or 0),)
    means = {
        place: column
        for column in record.outputs
        if (place := _mean_of(record, column)) is not None
    }
    limits, codes = np.full(len(scenes), np.nan), np.zeros(len(scenes), dtype=np.int8)
    sure = np.zeros(len(scenes), dtype=bool)
    rules: dict[str, Rule] = {}
    marks: dict[str, None] = {}
    for row, scene in enumerate(scenes):
        rule = None if scene is None else _rule(name, scene.facts)
        if rule is None or scene is None:
            continue
        ends = []
        for place in owners:
            known, slack = _mean(scene, means.get(place), place, row)
            ends += _limit(rule, scene.facts, record, place, known, slack, "/" in text)
        if ends:
            mark = mark_of(rule, scene.facts, _known(record, owners[0], None))
            limits[row] = 0.5 * (min(ends) + max(ends))
            codes[row] = _code(float(output.values[row]), ends, rule, mark)
            sure[row] = decides(mark)
            share, measured = "/" in text, all(place in means for place in owners)
            rules[_how(rule, share=share, measured=measured)], marks[mark] = rule, None
    if not rules:
        return []
    rule = next(iter(rules.values()))
    sources = "; ".join(dict.fromkeys(one.source for one in rules.values()))
    unit = output.unit or ("" if "/" in text else rule.unit)
    return [
        Judged(name, rule.title, output, rule.relation, output.values, limits, codes, unit, sure,
               tuple(marks), sources, "; ".join(rules), owners)
    ]  # fmt: skip


def _limit(
    rule: Rule, facts: Facts, record: Record, place: int, mean: float | None, slack: float,
    share: bool,  # noqa: FBT001 - as the caller found it
) -> list[float]:
    """Return the ends of the range in which the limit for a pantograph lies; none if unknown."""
    if share:
        return [rule.limit.factor]
    found = rule.limit.value(facts, _known(record, place, mean))
    if found is None:
        return []
    if rule.name == "uplift_space":
        found /= 1.5 if facts.uplift_limited else 2.0
    wide = rule.limit.factor * slack if rule.limit.of == _MEAN else 0.0
    return [found - wide, found + wide]


@dataclass(frozen=True)
class _Known:
    """The little of a pantograph's assessment that limits are computed from."""

    name: str
    mean_force_N: float | None  # noqa: N815 - a quantity of the assessment


def _known(record: Record, place: int, mean: float | None) -> Any:
    return _Known(record.study.base.pantographs[place].name, mean)


def _mean(scene: Scene, column: Column | None, place: int, row: int) -> tuple[float | None, float]:
    """Return the mean force of a pantograph in N, and how far it may be from that."""
    if column is not None and np.isfinite(column.values[row]):
        return float(column.values[row]), 0.0
    target = scene.targets[place] if place < len(scene.targets) else None
    return target, TARGET_MET_N


def _code(value: float, ends: Sequence[float], rule: Rule, mark: str) -> int:
    """Return the verdict on a value by a limit that lies between two ends."""
    if not np.isfinite(value):
        return CODES[NOT_JUDGED]
    passed = {RELATIONS[rule.relation](value, end, rule.tolerance) for end in ends}
    if len(passed) > 1:
        return CODES[TOO_CLOSE]
    return CODES[MET if passed.pop() else NOT_MET if decides(mark) else NOT_MET_UNVERIFIED]


def _told(record: Record, output: Column, name: str, scenes: Sequence[Scene | None]) -> Judged:
    """Return a criterion whose verdict is an output."""
    rule = _RULES[name]
    owners = tuple(range(len(record.study.base.pantographs)))
    marks = {
        mark_of(found, scene.facts, _known(record, place, None))
        for scene in scenes
        for place in owners
        if scene is not None and (found := _rule(name, scene.facts)) is not None
    }
    unsure = any(not decides(mark) for mark in marks)
    codes = _codes_of(output, record, output.name)
    if unsure:
        codes = np.where(codes == CODES[NOT_MET], CODES[NOT_MET_UNVERIFIED], codes).astype(np.int8)
    return Judged(name, rule.title, output, "", output.values, np.full(len(codes), np.nan), codes,
                  "", np.full(len(codes), not unsure), tuple(sorted(marks)), rule.source,
                  "the verdict is an output", owners)  # fmt: skip


def _codes_of(output: Column, record: Record, name: str) -> Codes:
    """Return the verdicts that an output of 1, 0 or nothing stands for."""
    codes = np.full(len(output.values), CODES[NOT_JUDGED], dtype=np.int8)
    codes[output.values == 1.0] = CODES[MET]
    codes[output.values == 0.0] = CODES[NOT_MET]
    for place in np.flatnonzero(~np.isfinite(output.values)):
        if TOO_CLOSE in record.done[int(place)].error:
            codes[place] = CODES[TOO_CLOSE]
    return codes


def _wave_speed(scenes: Sequence[Scene | None]) -> list[Judged]:
    """Return the speed over the wave speed, which needs no run."""
    rule = _RULES[_WAVE]
    values = np.array(
        [np.nan if s is None or s.facts.wave_speed_use is None else s.facts.wave_speed_use
         for s in scenes], dtype=float,
    )  # fmt: skip
    if not np.isfinite(values).any():
        return []
    limits = np.full(values.shape, rule.limit.constant)
    codes = np.array(
        [_code(v, [rule.limit.constant], rule, rule.mark) for v in values], dtype=np.int8
    )
    return [
        Judged(rule.name, rule.title, None, rule.relation, values, limits, codes, "",
               np.full(values.shape, decides(rule.mark)), (rule.mark,), rule.source,
               "value and limit from the scenario", ())
    ]  # fmt: skip


def _overall(items: Sequence[Judged], count: int) -> Codes:
    """Return the verdict on each variant: one that is not met decides, then one too close."""
    codes = np.full(count, CODES[NOT_JUDGED], dtype=np.int8)
    for verdict in (MET, TOO_CLOSE, NOT_MET):
        for one in items:
            codes[one.sure & (one.codes == CODES[verdict])] = CODES[verdict]
    return codes


def _unknown(
    items: Sequence[Judged], scenes: Sequence[Scene | None], record: Record
) -> tuple[str, ...]:
    """Return the criteria that decide, and that no output tells, in words."""
    names = [placed.name for placed in record.study.base.pantographs]
    told = {(one.name, place) for one in items for place in one.owners or (0,)}
    found: dict[str, list[str]] = {}
    facts = {id(scene.facts): scene.facts for scene in scenes if scene is not None}
    for one in facts.values():
        for rule in {rule.name: rule for rule in reversed(RULES) if rule.applies(one)}.values():
            for place in (0,) if rule.whole_run else range(len(names)):
                known = _known(record, place, 1.0)
                if (rule.name, place) in told or not decides(mark_of(rule, one, known)):
                    continue
                if rule.limit.value(one, known) is None:
                    continue  # without a limit no run is judged by it
                of = "" if rule.whole_run or len(names) == 1 else names[place]
                places = found.setdefault(rule.title, [])
                places += [of] if of not in places else []
    return tuple(
        title if not any(places) or len(places) == len(names) else f"{title} ({', '.join(places)})"
        for title, places in found.items()
    )


def _rule(name: str, facts: Facts) -> Rule | None:
    return next((rule for rule in RULES if rule.name == name and rule.applies(facts)), None)


def _column_of(record: Record, key: str) -> Column | None:
    for output in record.outputs:
        if record.study.expressions[output.name].text.strip() == key:
            return output
    return None


def _mean_of(record: Record, column: Column) -> int | None:
    """Return the pantograph whose mean force an output is."""
    text = record.study.expressions[column.name].text.strip()
    if text.rpartition(".")[2] != _MEAN:
        return None
    owner = owner_of_key(text, record.study.base)
    return owner if isinstance(owner, int) else None


def _how(rule: Rule, *, share: bool, measured: bool) -> str:
    """Return where a limit is from, in words."""
    if share:
        return "limit from the rules"
    if rule.limit.of == _MEAN:
        mean = "mean force of the variant" if measured else "mean force that the scenario asks for"
        return f"{rule.limit.factor:g} × the {mean}"
    if rule.limit.per_speed_squared:
        return f"{rule.limit.per_speed_squared:g} v² + {rule.limit.constant:g}, v in km/h"
    if rule.limit.of is not None:
        return "limit from the scenario"
    return "limit from the rules"
