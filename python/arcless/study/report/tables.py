"""Tables of a study's report: variables, outputs, failures, and the leading variants."""

import html
import json
from collections import defaultdict
from dataclasses import dataclass, replace
from math import floor, isfinite, log10
from typing import Any

import numpy as np

from arcless.report.drawing.bokeh_objects import Model
from arcless.study.definition.study import Study
from arcless.study.designs import Grid
from arcless.study.optimisation.optimise import Optimise
from arcless.study.report.commands import Commands
from arcless.study.report.figures import Drawing
from arcless.study.report.record import Column, Record
from arcless.study.variables.distributions import Choice
from arcless.study.variables.variables import Variable
from arcless.units import show

# Numbers of leading variants in a list, of outputs, and of reasons that are shown.
LEADING, LED_OUTPUTS, REASONS, STOPS = 3, 6, 20, 50
_DIGITS, _SMALLEST, _LARGEST = 5, 1e-6, 1e9
_NAMED = 12
_HEIGHT, _ROW = 420, 26
_LONGEST = 200


@dataclass(frozen=True)
class Leader:
    """A variant that has the lowest or the highest value of an output."""

    variant: int
    value: str
    values: str
    command: str


def number(value: float | None) -> str:
    """Return a number with six digits and a real minus sign; a dash for none."""
    if value is None or not isfinite(value):
        return "–"
    return f"{value:.6g}".replace("-", "−")


def variable_rows(study: Study) -> list[dict[str, str]]:
    """Return name, field, values and description of every variable, as the file gives them."""
    return [
        {
            "name": axis.name,
            "field": axis.field,
            "unit": axis.typed_unit,
            "values": _ways(study.variables[axis.name]),
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
            numbers = [float(known.mean()), spread, float(known.min()), middle, float(known.max())]
        cells = [number(value) for value in numbers]
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
            ends = (number(one["low"]), number(one["high"]))
            cells.append((number(one["value"]), " to ".join(ends)))
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
            so_far = ", ".join(f"{name} = {number(value)}" for name, value in known.items())
            place = f"{number(row.stopped_at_m)} m, {number(row.stopped_after_s)} s"
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


def leaders(record: Record) -> list[tuple[Column, list[tuple[str, list[Leader]]]]]:
    """Return the variants with the lowest and the highest value of each output."""
    commands = Commands(record.study)
    found = []
    for out in record.outputs[:LED_OUTPUTS]:
        known = np.flatnonzero(np.isfinite(out.values))
        if not out.varies:
            continue
        rising = known[np.argsort(out.values[known], kind="stable")]
        most = min(LEADING, rising.size // 2)
        ends = (("lowest", rising[:most]), ("highest", rising[::-1][:most]))
        found.append(
            (out, [(word, [_leader(record, out, i, commands) for i in end]) for word, end in ends])
        )
    return found


def best(record: Record) -> list[Leader] | None:
    """Return the best variants of an optimisation, of several objectives the front; else None."""
    design = record.study.design
    if not isinstance(design, Optimise):
        return None
    found = {row.variant for row in design.best(record.rows)}
    commands = Commands(record.study)
    aims = [out for out in record.outputs if out.name in design.objectives]
    leaders_ = []
    for place in np.flatnonzero([int(variant) in found for variant in record.variants]):
        each = [_leader(record, out, int(place), commands) for out in aims]
        reached = [f"{out.name} = {one.value}" for out, one in zip(aims, each, strict=True)]
        leaders_.append(replace(each[0], value=", ".join(reached)))
    return leaders_


def _leader(record: Record, out: Column, place: int, commands: Commands) -> Leader:
    variant = int(record.variants[place])
    values = []
    for column in record.variables:
        value = column.values[place]
        words = column.words
        text = words[int(value)] if words is not None else number(float(value))
        values.append(f"{column.name} = {text} {column.unit}".rstrip())
    value = f"{number(float(out.values[place]))} {out.unit}".rstrip()
    return Leader(variant, value, ", ".join(values), commands.again(variant))


def data_table(drawing: Drawing) -> Any:
    """Return the table of all variants that are drawn: a click on a title sorts it."""
    columns = [_column("variant", "variant", Model("NumberFormatter", format="0"), 70)]
    for column in (*drawing.record.variables, *drawing.outputs):
        key = drawing.key(column)
        if column.words is not None:
            columns.append(_column(f"{key} word", column.label, Model("StringFormatter")))
        else:
            columns.append(_column(key, column.label, _format(column)))
    return Model(
        "DataTable",
        source=drawing.source,
        columns=columns,
        index_position=None,
        sizing_mode="stretch_width",
        height=min(_HEIGHT, _ROW * (len(drawing.drawn) + 2)),
        row_height=_ROW,
        selectable=True,
        sortable=True,
        reorderable=False,
    )


def _column(field: str, title: str, formatter: Any, width: int = 120) -> Any:
    # The table takes titles as HTML.
    safe = html.escape(title)
    return Model("TableColumn", field=field, title=safe, formatter=formatter, width=width)


def _format(column: Column) -> Any:
    """Return a format with so many decimals that values are told apart."""
    known = np.abs(column.values[np.isfinite(column.values)])
    known = known[known > 0.0]
    largest, smallest = (float(known.max()), float(known.min())) if known.size else (1.0, 1.0)
    if largest >= _LARGEST or smallest < _SMALLEST:
        unknown = {"nan_format": "–", "null_format": "–"}
        return Model("ScientificFormatter", precision=_DIGITS - 1, **unknown)
    if np.all(column.values[np.isfinite(column.values)] % 1.0 == 0.0):
        decimals = 0
    else:
        decimals = max(0, _DIGITS - 1 - floor(log10(largest)))
    form = "0." + "0" * decimals if decimals else "0"
    style = {"text_align": "right", "nan_format": "–", "null_format": "–"}
    return Model("NumberFormatter", format=form, **style)


def _ways(variable: Variable) -> str:
    """Return the values or the distribution of a variable, in words."""
    if variable.values is not None:
        return _some([_amount(value) for value in variable.values])
    if variable.range is not None:
        low, high = (_amount(end) for end in variable.range)
        return f"{low} to {high}" + (f", {variable.count} values" if variable.count else "")
    if variable.random_field is not None:
        spread, length = variable.random_field.model_dump().values()
        return f"random field, standard deviation {spread:g} m, correlation length {length:g} m"
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
    """Return the design in words."""
    design = study.design
    fields = design.model_dump()
    if isinstance(design, Optimise):
        aims = ", ".join(f"{aim} {name}" for name, aim in design.objectives.items())
        rule = "" if design.pruning is None else f", pruning {design.pruning.kind}"
        return f"optimise: {aims}; {design.trials} variants, seed {study.seed}{rule}"
    words = [str(fields.pop("kind"))]
    words += [f"{n.replace('_', ' ')} {str(v).lower()}" for n, v in fields.items()]
    words += [] if isinstance(design, Grid) or design.kind == "list" else [f"seed {study.seed}"]
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
