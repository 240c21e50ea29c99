"""Tables of a study's report: variables, outputs, percentiles, failures, the best variants."""

import json
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from arcless.study.definition.study import Study
from arcless.study.designs import Grid
from arcless.study.optimisation.optimise import Optimise
from arcless.study.report.commands import Commands
from arcless.study.report.data.numbers import digits
from arcless.study.report.data.record import Column, Record, words_of
from arcless.study.variables.distributions import Choice
from arcless.study.variables.variables import Variable
from arcless.units import show

# Numbers of reasons and of stops that are shown.
REASONS, STOPS = 20, 50
_NAMED = 12
_LONGEST = 200


@dataclass(frozen=True)
class Best:
    """A best variant of an optimisation: what it reaches, at which values, by which command."""

    variant: int
    reached: str
    values: str
    command: str


def variable_rows(study: Study) -> list[dict[str, str]]:
    """Return name, field, values and description of every variable, as the file gives them."""
    return [
        {
            "name": axis.name,
            "field": axis.field,
            "unit": axis.typed_unit,
            "values": _ways(study.variables[axis.name], words_of(axis.name, axis.levels or ())),
            "about": study.variables[axis.name].description,
        }
        for axis in study.axes
    ]


def output_rows(record: Record) -> list[dict[str, Any]]:
    """Return the statistics of every output over the rows that are done."""
    rows = []
    for out in record.outputs:
        known = out.values[np.isfinite(out.values)]
        numbers = [float("nan")] * 5
        if known.size:
            spread = float(known.std(ddof=1)) if known.size > 1 else float("nan")
            middle = float(np.median(known))
            low, high = float(known.min()), float(known.max())
            numbers = [low, middle, float(known.mean()), high, spread]
        cells = [digits(value) for value in numbers]
        rows.append({"column": out, "count": known.size, "cells": cells})
    return rows


def percentile_rows(record: Record) -> list[tuple[Column, list[tuple[str, str]]]]:
    """Return the percentiles of every output with their intervals; nothing unless of a sample."""
    found = record.findings["percentiles"]
    if found is None:
        return []
    rows = []
    for out in record.outputs:
        cells = []
        for one in found["outputs"][out.name]["percentiles"]:
            ends = (digits(one["low"]), digits(one["high"]))
            cells.append((digits(one["value"]), " to ".join(ends)))
        rows.append((out, cells))
    return rows


@dataclass(frozen=True)
class Stop:
    """A variant that was stopped while it ran: where, what it was so far, and why."""

    variant: int
    place: str
    so_far: str
    why: str


def stops(record: Record) -> list[Stop]:
    """Return the variants that were pruned."""
    found = []
    for row in record.rows:
        if row.status == "pruned":
            known = {name: values[-1] for name, values in row.so_far.items() if values}
            so_far = ", ".join(f"{name} = {digits(value)}" for name, value in known.items())
            place = f"{digits(row.stopped_at_m)} m, {digits(row.stopped_after_s)} s"
            found.append(Stop(row.variant, place, so_far, row.error))
    return found


def failures(record: Record) -> list[dict[str, Any]]:
    """Return why rows have no values: the reason, how many have it, and some of their numbers."""
    found = defaultdict(list)
    for row in record.rows:
        if row.error and row.status != "pruned":
            found[(row.status, row.error)].append(row.variant)
    ordered = sorted(found.items(), key=lambda item: -len(item[1]))
    return [
        {
            "status": {"done": "no value"}.get(status, status),
            "error": error,
            "count": len(numbers),
            "numbers": ", ".join(map(str, numbers[:_NAMED])) + (" …" if numbers[_NAMED:] else ""),
        }
        for (status, error), numbers in ordered
    ]


def best(record: Record) -> list[Best] | None:
    """Return the best variants of an optimisation, of several objectives the front; else None."""
    design = record.study.design
    if not isinstance(design, Optimise):
        return None
    found = {row.variant for row in design.best(record.rows)}
    commands = Commands(record.study)
    aims = [out for out in record.outputs if out.name in design.objectives]
    chosen = []
    for place in np.flatnonzero([int(variant) in found for variant in record.variants]):
        variant = int(record.variants[place])
        reached = [f"{out.heading} = {_amount_of(out, place)}" for out in aims]
        command = commands.again(variant)
        chosen.append(Best(variant, ", ".join(reached), values_of(record, int(place)), command))
    return chosen


def values_of(record: Record, place: int) -> str:
    """Return the values of the variables of a row that is done, in words."""
    return ", ".join(f"{one.name} {_amount_of(one, place)}" for one in record.variables)


def _amount_of(column: Column, place: int | np.intp) -> str:
    value = column.values[place]
    if column.words is not None:
        return column.words[int(value)]
    return f"{digits(float(value))} {column.unit}".rstrip()


def _ways(variable: Variable, names: Sequence[str]) -> str:
    """Return the values or the distribution of a variable, in words."""
    if variable.values is not None:
        texts = [_amount(value) for value in variable.values]
        if any(isinstance(value, dict | list | tuple) for value in variable.values):
            texts = [f"{name}: {text}" for name, text in zip(names, texts, strict=False)]
        return _some(texts)
    if variable.range is not None:
        low, high = (_amount(end) for end in variable.range)
        return f"{low} to {high}" + (f", {variable.count} values" if variable.count else "")
    if variable.random_field is not None:
        field = variable.random_field
        size = (
            f"standard deviation {field.standard_deviation:g} m"
            if field.bound is None
            else f"equally likely within ±{field.bound:g} m"
        )
        return f"random field, {size}, correlation length {field.correlation_length:g} m"
    given = variable.distribution
    assert given is not None
    if isinstance(given, Choice):
        weights = "" if given.weights is None else f", weights {_some(map(str, given.weights))}"
        return f"one of {_some([_amount(value) for value in given.values])}{weights}"
    parts = [
        f"{name.replace('_', ' ')} {_amount(value)}"
        for name, value in given.model_dump().items()
        if name != "kind"
    ]
    return f"{given.kind}: {', '.join(parts)}"


def design_text(study: Study) -> str:
    """Return the design in words; of a grid how many values each variable has."""
    design = study.design
    fields = design.model_dump()
    if isinstance(design, Optimise):
        aims = ", ".join(f"{aim} {name}" for name, aim in design.objectives.items())
        rule = "" if design.pruning is None else f", pruning {design.pruning.kind}"
        return f"optimise: {aims}; {design.trials} variants, seed {study.seed}{rule}"
    if isinstance(design, Grid):
        counts = [str(len(axis.levels or ())) for axis in study.axes]
        return f"grid, {' × '.join(counts)}" if len(counts) > 1 else "grid"
    words = [str(fields.pop("kind"))]
    words += [f"{n.replace('_', ' ')} {str(v).lower()}" for n, v in fields.items()]
    words += [] if design.kind == "list" else [f"seed {study.seed}"]
    return ", ".join(words)


def written(value: Any) -> str:
    """Return a value on one line, cut where it is long."""
    text = value if isinstance(value, str) else json.dumps(value, ensure_ascii=False)
    return text if len(text) <= _LONGEST else f"{text[:_LONGEST]} …"


def _amount(value: Any) -> str:
    return value if isinstance(value, str) else show(value)


def _some(texts: Any) -> str:
    given = list(texts)
    return ", ".join(given[:_NAMED]) + (f", … ({len(given)})" if given[_NAMED:] else "")
