"""First screen of a study's page: what was studied, its state, the verdict, the main outputs."""

from collections import Counter
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from arcless.assess import (
    MET,
    NOT_JUDGED,
    NOT_MET,
    NOT_MET_UNVERIFIED,
    RELATION_SIGNS,
    TOO_CLOSE,
    decides,
)
from arcless.report.summary import LENGTH, Verdict
from arcless.study.report import tables
from arcless.study.report.data.judged import VERDICTS, Judged, Verdicts
from arcless.study.report.data.record import Column, Record
from arcless.study.report.figures.canvas import Canvas, extremes, limits_of, span_of

# Outputs on the first screen; the others are in their table.
MOST_OUTPUTS = 6
# Part of a range behind its ends, and the least that is drawn of one, of `LENGTH`.
_BEHIND, _LEAST = 0.08, 6.0


@dataclass(frozen=True)
class Range:
    """An output with its range, and its limit where it has one, as text and as a bar."""

    title: str
    about: str
    value: str
    unit: str
    limit: str
    verdict: str
    state: str
    ends: list[str]
    bar: tuple[float, float, float | None]

    @property
    def words(self) -> str:
        """The range and the verdict in a sentence, for those who do not see the bar."""
        return ", ".join(
            part for part in (f"{self.value} {self.unit}", self.limit, self.verdict) if part
        )


def variants_of(count: int) -> str:
    """Return a number of variants in words: ``1 variant``, ``1 200 variants``."""
    return f"{count:,} variant{'' if count == 1 else 's'}".replace(",", " ")


def identity(record: Record) -> list[tuple[str, str]]:
    """Return what was studied, as label and text."""
    study, base = record.study, record.study.base
    names = [placed.model.name for placed in base.pantographs]
    gaps = [f"{b.distance - a.distance:g}" for a, b in pairwise(base.pantographs)]
    heads = ", ".join(dict.fromkeys(names))
    if len(names) > 1:
        varied = any(axis.field.endswith(".distance") for axis in study.axes)
        heads = f"{len(names)} × {heads}"
        heads += ", distance varied" if varied else f", {', '.join(gaps)} m apart"
    design = tables.design_text(study)
    if " variants" not in design:  # an optimisation says how many
        design += f"; {variants_of(record.status.total)}"
    begun = str(record.state.get("begun", "–")).replace("T", " ")[:16]
    return [
        ("Scenario", study.scenario.name),
        ("Line", base.line.name),
        ("Pantograph" if len(names) == 1 else "Pantographs", heads),
        ("Varied", ", ".join(axis.name for axis in study.axes)),
        ("Design", design),
        ("Begun", begun),
        ("Arcless", ", ".join(record.status.versions) or "–"),
    ]


def state(record: Record) -> tuple[bool, str]:
    """Return whether all is computed, and how far the study is, in words."""
    found = record.status
    parts = [f"{found.done} of {variants_of(found.total)} computed"]
    parts += [f"{found.pruned} pruned"] if found.pruned else []
    parts += [f"{found.invalid} invalid"] if found.invalid else []
    parts += [f"{found.failed} failed"] if found.failed else []
    if found.missing:
        parts.append(f"{found.missing} missing")
        how = "it is being computed now" if found.running else "it is not being computed"
        return False, f"Incomplete: {', '.join(parts)}; {how}"
    if not found.done:
        return False, f"No variant has a value: {', '.join(parts[1:])}"
    return True, f"Complete: {', '.join(parts)}"


def headline(record: Record, verdicts: Verdicts) -> Verdict:
    """Return the verdict over all variants, with the state of the study below it."""
    whole, words = state(record)
    judged = [one for one in verdicts.items if one.decides]
    if not record.done:
        return Verdict("open" if record.status.missing else "missed", "≈", words, "", [])
    if not judged and not verdicts.whole:
        text = "No verdict: no output is judged by a limit that decides"
        hint = "The output `passed` says which variants meet all criteria that decide."
        return Verdict("open", "≈", text, "", [f"{words}.", hint])
    count = Counter(VERDICTS[int(code)] for code in verdicts.codes)
    met, done = count[MET], len(record.done)
    some, none = "" if done == record.status.total else " with values", count[NOT_JUDGED]
    those = f"{variants_of(done - none)}{some}{' that could be judged' if none else ''}"
    every = f"All {those} meet" if done - none > 1 else f"The {those.removeprefix('1 ')} meets"
    who = every if met == done - none else f"{met} of {those} {_meet(met)}"
    who = f"{who} {_criteria(judged, verdicts)}"
    unsure = [f"{count[TOO_CLOSE]} too close to tell"] if count[TOO_CLOSE] else []
    if none == done:
        who = f"None of {done} variants{some} could be judged"
    elif none:
        unsure.append(f"{none} of {done} could not be judged")
    items = [*_worst(judged, done), f"{words}."]
    if verdicts.unknown:
        items.append(f"Not judged, as no output has them: {'; '.join(verdicts.unknown)}.")
    kind = "met" if met == done and whole else "missed" if count[NOT_MET] == done else "open"
    sign = {"met": "✔", "missed": "✘"}.get(kind, "≈")
    return Verdict(kind, sign, who, "; ".join(unsure), items)


def _meet(count: int) -> str:
    return "meets" if count == 1 else "meet"


def _criteria(judged: list[Judged], verdicts: Verdicts) -> str:
    if verdicts.whole or not verdicts.unknown:
        return "all criteria that decide"
    shown, others = len({one.name for one in judged}), len(verdicts.unknown)
    which = "the one criterion that is" if shown == 1 else f"the {shown} criteria that are"
    return f"{which} judged; {others} other {'criterion is' if others == 1 else 'criteria are'} not"


def _worst(judged: list[Judged], done: int) -> list[str]:
    """Return the limit that is most often not met, in a sentence."""
    missed = Counter[str]()
    for one in judged:
        missed[one.heading] = max(missed[one.heading], one.count(NOT_MET))
    (name, count), *_ = missed.most_common(1) or [("", 0)]
    return [f"Most often not met: {name}, {count} of {variants_of(done)}."] if count else []


def ranges(canvas: Canvas) -> list[Range]:
    """Return the main outputs with their ranges."""
    told = [one.output for one in canvas.verdicts.items if not one.relation]
    shown = [out for out in canvas.outputs if out not in told and out.name != "passed"]
    return [_range(canvas, output) for output in shown[:MOST_OUTPUTS]]


def _range(canvas: Canvas, output: Column) -> Range:
    record, judged = canvas.record, canvas.main(output)
    ends = [
        f"{word} at {tables.values_of(record, place)} (variant {record.variants[place]})"
        for word, place in zip(("lowest", "highest"), extremes(output), strict=True)
        if place is not None
    ]
    known = output.values[np.isfinite(output.values)]
    low, high = float(known.min()), float(known.max())
    limit, verdict, kind, bound = "", "", "plain", None
    if judged is not None:
        limits = judged.limits[np.isfinite(judged.limits)]
        limit = f"limit {RELATION_SIGNS[judged.relation]} {limits_of(judged)}"
        met = judged.count(MET)
        kind = "met" if met == len(known) else "not-met" if judged.count(NOT_MET) else "open"
        verdict = _counts(judged, len(known))
        bound = float(limits.min() if judged.relation == "<=" else limits.max())
    points = [low, high, *([] if bound is None else [bound])]
    begin = min(0.0, *points) if min(points) > -max(map(abs, points)) * 0.5 else min(points)
    size = (max(points) - begin) * (1.0 + _BEHIND) or 1.0
    places = [round(LENGTH * (point - begin) / size, 1) for point in points]
    about = "" if output.about in (output.title, output.name) else output.about
    return Range(
        output.heading, about, span_of(known, ""), output.unit, limit, verdict, kind, ends,
        (places[0], max(round(places[1] - places[0], 1), _LEAST), dict(enumerate(places)).get(2)),
    )  # fmt: skip


def _counts(judged: Judged, count: int) -> str:
    """Return of how many variants a limit is not met, and is so unverified; else met, in words."""
    told = [(NOT_MET, "not met"), (NOT_MET_UNVERIFIED, "unverified")]
    missed = [f"{word}: {found}" for verdict, word in told if (found := judged.count(verdict))]
    if missed:
        return f"{', '.join(missed)} of {count}"
    return f"met: {judged.count(MET)} of {count}{'' if judged.decides else ' (unverified)'}"


def criterion_rows(verdicts: Verdicts) -> list[dict[str, str]]:
    """Return the criteria that the rows tell about, as text."""
    rows = []
    for one in verdicts.items:
        limit = f"{RELATION_SIGNS[one.relation]} {limits_of(one)}" if one.relation else ""
        missed, unsure = one.count(NOT_MET), one.count(NOT_MET_UNVERIFIED)
        counts = {
            "met": one.count(MET), "close": one.count(TOO_CLOSE), "none": one.count(NOT_JUDGED)
        }  # fmt: skip
        rows.append(
            {
                "title": one.heading,
                "output": "–" if one.output is None else one.output.name,
                "value": span_of(one.values, one.unit) if one.relation else "",
                "limit": limit,
                "how": one.how,
                "missed": str(missed),
                "unsure": str(unsure),
                **{name: str(count) for name, count in counts.items()},
                "state": "missed" if missed else "open",
                "mark": ", ".join(one.marks),
                "source": one.source,
                "decides": _decides(one),
            }
        )
    return rows


def _decides(one: Judged) -> str:
    """Return which marks of a criterion decide nothing, in words; empty where all do."""
    if not one.decides:
        return "does not count"
    unsure = [mark for mark in one.marks if not decides(mark)]
    return f"{', '.join(unsure)} does not count" if unsure else ""
