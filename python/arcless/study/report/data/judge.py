"""Outputs of a study against the limits of the assessment, variant by variant.

A row holds outputs and values, not criteria. What is judged here is what follows from them: an
output that is an assessed quantity, by a limit from the rules and the variant's own scenario; a
criterion that is an output; and the speed over the wave speed, which the scenario alone has.
"""

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from arcless.assess import MET, NOT_JUDGED, NOT_MET, RULES, TOO_CLOSE, decides
from arcless.assess.criteria import RELATIONS
from arcless.assess.rules import Rule, mark_of
from arcless.study.definition.quantities import (
    CRITERIA,
    MARGIN,
    WORST,
    criterion_of,
    owner_of_key,
)
from arcless.study.report.data.judged import CODES, Codes, Judged, Verdicts, code_of
from arcless.study.report.data.limits import MEAN, CriterionRules, Limits, judges, known_of, rule_of
from arcless.study.report.data.record import Column, Floats, RowColumns
from arcless.study.report.data.scenes import TARGET_MET_N, Scene, Scenes

_WAVE = "wave_speed_use"
_RULES: Mapping[str, Rule] = {rule.name: rule for rule in reversed(RULES)}


def judge(record: RowColumns) -> Verdicts:
    """Return what rows of a study tell about the criteria, each row by itself."""
    scenes, speeds = Scenes(record.study), _column_of(record, "speed_m_s")
    found = [
        scenes.of(row, None if speeds is None else float(speeds.values[place]))
        for place, row in enumerate(record.done)
    ]
    items = [*_outputs(record, found), *_wave_speed(found)]
    items += _asked_forces(record, found, items)
    passed = _column_of(record, "passed")
    if passed is not None:
        codes = _codes_of(passed, record)
        return Verdicts(tuple(items), codes, whole=True)
    return Verdicts(
        tuple(items), _overall(items, len(found)), False, _unknown(items, found, record)
    )


def _outputs(record: RowColumns, scenes: Sequence[Scene | None]) -> Iterable[Judged]:
    for output in record.outputs:
        expression = record.study.expressions[output.name]
        text = "".join(expression.text.split())
        criterion = criterion_of(text)
        if criterion is not None and criterion[1] in ("", MARGIN):
            name, number = criterion
            judged = _margin if number else _told
            yield judged(record, output, name, scenes)
        if text.startswith(CRITERIA):
            continue
        prefix, quantity = _split(text)
        if expression.names == {text}:
            names = {rule.name for rule in RULES if judges(rule, quantity)}
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


def _limited(
    record: RowColumns, output: Column, name: str, text: str, scenes: Sequence[Scene | None]
) -> list[Judged]:
    """Return an output against the limits of one criterion; nothing where it has no limit."""
    count, share = len(record.study.base.pantographs), "/" in text
    owner = owner_of_key(text.partition("/")[0], record.study.base)
    owners = tuple(range(count)) if owner == WORST else (int(owner or 0),)
    given = Limits(record, owners, share=share)
    limits, codes = np.full(len(scenes), np.nan), np.zeros(len(scenes), dtype=np.int8)
    sure = np.zeros(len(scenes), dtype=bool)
    rules: dict[str, Rule] = {}
    marks: dict[str, None] = {}
    for row, scene in enumerate(scenes):
        rule = None if scene is None else rule_of(name, scene.facts)
        if rule is None or scene is None or not (ends := given.ends(rule, scene, row)):
            continue
        mark = given.mark(rule, scene.facts)
        limits[row], sure[row] = 0.5 * (min(ends) + max(ends)), decides(mark)
        codes[row] = code_of(float(output.values[row]), ends, rule, mark)
        rules[given.words(rule)], marks[mark] = rule, None
    if not rules:
        return []
    rule = next(iter(rules.values()))
    sources = "; ".join(dict.fromkeys(one.source for one in rules.values()))
    unit = output.unit or ("" if share else rule.unit)
    return [
        Judged(name, rule.title, output, rule.relation, output.values, limits, codes, unit, sure,
               tuple(marks), sources, "; ".join(rules), owners, rule.tolerance)
    ]  # fmt: skip


def _margin(
    record: RowColumns, output: Column, name: str, scenes: Sequence[Scene | None]
) -> Judged:
    """Return a criterion whose margin is an output: it has the tolerance of the limit in it."""
    rules = CriterionRules.of(record, name, scenes)
    relation = rules.first.relation.replace("<", ">")
    met = [RELATIONS[relation](margin, 0.0, 0.0) for margin in output.values.tolist()]
    codes = np.where(met, CODES[MET], CODES[NOT_MET])
    codes[~np.isfinite(output.values)] = CODES[NOT_JUDGED]
    return Judged(name, rules.first.title, output, relation, output.values, np.zeros(len(codes)),
                  rules.codes(codes.astype(np.int8)), output.unit, rules.sure, rules.marks,
                  rules.source, "the margin is an output", rules.owners)  # fmt: skip


def _told(record: RowColumns, output: Column, name: str, scenes: Sequence[Scene | None]) -> Judged:
    """Return a criterion whose verdict is an output."""
    rules, codes = CriterionRules.of(record, name, scenes), _codes_of(output, record)
    return Judged(name, rules.first.title, output, "", output.values, np.full(len(codes), np.nan),
                  rules.codes(codes), "", rules.sure, rules.marks, rules.source,
                  "the verdict is an output", rules.owners)  # fmt: skip


def _codes_of(output: Column, record: RowColumns) -> Codes:
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
        [code_of(v, [rule.limit.constant], rule, rule.mark) for v in values], dtype=np.int8
    )
    return [
        Judged(rule.name, rule.title, None, rule.relation, values, limits, codes, "",
               np.full(values.shape, decides(rule.mark)), (rule.mark,), rule.source,
               "value and limit from the scenario", ())
    ]  # fmt: skip


def _asked_forces(
    record: RowColumns, scenes: Sequence[Scene | None], items: Sequence[Judged]
) -> list[Judged]:
    """Return the mean forces that scenarios ask for, which runs meet, where no output has them."""
    found = []
    told = {(one.name, place) for one in items for place in one.owners}
    for name in (rule for rule, about in _RULES.items() if judges(about, MEAN)):
        targets: dict[bytes, tuple[Floats, list[int]]] = {}
        for place in range(len(record.study.base.pantographs)):
            values = np.array([_target(scene, place) for scene in scenes], dtype=float)
            if (name, place) not in told and np.isfinite(values).any():
                targets.setdefault(values.tobytes(), (values, []))[1].append(place)
        for values, places in targets.values():
            found += _asked_force(record, name, values, tuple(places), scenes)
    return found


def _target(scene: Scene | None, place: int) -> float:
    target = None if scene is None or place >= len(scene.targets) else scene.targets[place]
    return float("nan") if target is None else target


def _asked_force(
    record: RowColumns,
    name: str,
    values: Floats,
    places: tuple[int, ...],
    scenes: Sequence[Scene | None],
) -> list[Judged]:
    """Return the mean force asked for, of some pantographs, against one criterion."""
    limits, codes = np.full(len(scenes), np.nan), np.zeros(len(scenes), dtype=np.int8)
    sure, rules = np.zeros(len(scenes), dtype=bool), dict[str, Rule]()
    for row, scene in enumerate(scenes):
        rule = None if scene is None else rule_of(name, scene.facts)
        if rule is None or scene is None or not np.isfinite(values[row]):
            continue
        known = known_of(record, places[0], float(values[row]))
        mark, limit = mark_of(rule, scene.facts, known), rule.limit.value(scene.facts, known)
        if limit is None:
            continue
        limits[row], sure[row], rules[mark] = limit, decides(mark), rule
        ends = [limit - TARGET_MET_N, limit + TARGET_MET_N]
        codes[row] = code_of(float(values[row]), ends, rule, mark)
    if not rules:
        return []
    rule = next(iter(rules.values()))
    return [
        Judged(name, rule.title, None, rule.relation, values, limits, codes, rule.unit, sure,
               tuple(rules), rule.source, "the mean force that the scenario requires", places,
               rule.tolerance)
    ]  # fmt: skip


def _overall(items: Sequence[Judged], count: int) -> Codes:
    """Return the verdict on each variant: one that is not met decides, then one too close."""
    codes = np.full(count, CODES[NOT_JUDGED], dtype=np.int8)
    for verdict in (MET, TOO_CLOSE, NOT_MET):
        for one in items:
            codes[one.sure & (one.codes == CODES[verdict])] = CODES[verdict]
    return codes


def _unknown(
    items: Sequence[Judged], scenes: Sequence[Scene | None], record: RowColumns
) -> tuple[str, ...]:
    """Return the criteria that decide, and that no output tells, in words."""
    names = [placed.name for placed in record.study.base.pantographs]
    told = {(one.name, place) for one in items for place in one.owners or (0,)}
    found: dict[str, list[str]] = {}
    facts = {id(scene.facts): scene.facts for scene in scenes if scene is not None}
    for one in facts.values():
        for rule in {rule.name: rule for rule in reversed(RULES) if rule.applies(one)}.values():
            for place in (0,) if rule.whole_run else range(len(names)):
                known = known_of(record, place, 1.0)
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


def _column_of(record: RowColumns, key: str) -> Column | None:
    for output in record.outputs:
        if record.study.expressions[output.name].text.strip() == key:
            return output
    return None
