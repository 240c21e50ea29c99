"""A comparison as columns for data frames, and as a card for notebooks."""

from collections.abc import Sequence
from typing import Any

from arcless.assess.tables import badge_of, headline
from arcless.comparison import cells
from arcless.comparison.compared import Compared
from arcless.comparison.indicators import Judged
from arcless.display import cards
from arcless.storage.csv_files import Column


def number_columns(compared: Compared) -> list[Column]:
    """Return the numbers, one in a row: values of the runs, differences to the first in it."""
    found = compared.indicators
    columns = [
        Column("key", "", [one.key for one in found]),
        Column("quantity", "", [one.label for one in found]),
        Column("unit", "", [one.unit for one in found]),
        Column("pantograph", "", [one.pantograph or "" for one in found]),
    ]
    for run, name in enumerate(compared.names):
        columns.append(Column(name, "", [one.values[run] for one in found]))
        if run:
            less = [one.differences[run] for one in found]
            share = [one.percents[run] for one in found]
            columns.append(Column(f"{name}: difference", "", less))
            columns.append(Column(f"{name}: difference", "%", share))
            sure = [one.difference_uncertainties[run] for one in found]
            if any(one is not None for one in sure):
                columns.append(Column(f"{name}: ± of the difference", "", sure))
    return columns


def criterion_columns(compared: Compared) -> list[Column]:
    """Return the criteria, one in a row: value, limit and verdict in each run."""
    found = compared.criteria
    columns = [
        Column("name", "", [one.name for one in found]),
        Column("criterion", "", [one.title for one in found]),
        Column("unit", "", [one.unit for one in found]),
        Column("pantograph", "", [one.pantograph or "" for one in found]),
    ]
    for run, name in enumerate(compared.names):
        columns.append(Column(f"{name}: value", "", [one.values[run] for one in found]))
        columns.append(Column(f"{name}: limit", "", [one.limits[run] for one in found]))
        columns.append(Column(f"{name}: verdict", "", [one.verdicts[run] for one in found]))
    return columns


def field_columns(compared: Compared) -> list[Column]:
    """Return the fields in which the scenarios differ, one in a row: its value in each run."""
    paths = Column("field", "", [one.path for one in compared.fields])
    return [paths, *(Column(name, "", [one.values[run] for one in compared.fields])
                     for run, name in enumerate(compared.names))]  # fmt: skip


def card(compared: Compared) -> str:
    """Return the comparison as HTML: changed fields, main numbers, verdicts, all numbers."""
    names = list(compared.names)
    fields = [[one.path, *(cells.NONE if value is None else value for value in one.values)]
              for one in compared.fields]  # fmt: skip
    overall = [headline(one.assessment.criteria) for one in compared.sides]
    over_all: list[cards.Cell] = [cards.Badge(one.state, one.text) for one in overall]
    verdicts = [["all criteria", *over_all], *map(_verdicts, compared.criteria)]
    main = [one for one in compared.indicators if one.key in cells.MAIN]
    parts = [
        cards.table(("changed field", *names), fields),
        cards.table(("criterion", *names), verdicts),
        _numbers(compared, main),
        cards.folded("All numbers", _numbers(compared, compared.indicators)),
    ]
    if compared.warnings:
        parts.append(cards.listed(compared.warnings))
    return cards.card(f"Comparison of {len(names)} runs", *parts)


def _verdicts(one: Judged) -> list[cards.Cell]:
    of = "" if one.pantograph is None else f", {one.pantograph}"
    return [
        f"{one.title}{of}",
        *(cells.NONE if word is None else badge_of(word) for word in one.verdicts),
    ]


def _numbers(compared: Compared, chosen: Sequence[Any]) -> str:
    titles = [compared.names[0]]
    for name in compared.names[1:]:
        titles += [name, f"{name} less {compared.names[0]}"]
    rows = []
    for one in chosen:
        of = "" if one.pantograph is None else f", {one.pantograph}"
        row = [f"{one.label}{of}", one.unit, cells.value(one, 0)]
        for run in range(1, len(compared.names)):
            row += [cells.value(one, run), cells.difference(one, run)]
        rows.append(row)
    return cards.table(("quantity", "unit", *titles), rows, numbers=titles)
