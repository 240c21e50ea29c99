"""Contributions to σ on paper: sentences, parts, modes of the pantograph, worst places."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from arcless.report.paper.blocks import Block, Column, Heading, Paragraph, Table

_GROUPS = ("share of σ², %", "±, %", "root, N", "strongest at, Hz", "wavelength, m", "its share, %")
_MODES = ("Hz", "band, Hz", "damping ratio", "share that does not repeat, %", "all in the band, %")


def said(explained: Sequence[Mapping[str, Any]]) -> Iterator[Block]:
    """Yield the sentences on each pantograph, with its name where there are several."""
    for one in explained:
        start = f"{one['name']}: " if len(explained) > 1 else ""
        for place, text in enumerate(one["sentences"]):
            yield Paragraph(text if place else f"{start}{text}")


def explained_tables(explained: Sequence[Mapping[str, Any]], reads: str) -> Iterator[Block]:
    """Yield the tables on each pantograph, and how they are read."""
    for one in explained:
        of = f", {one['name']}" if len(explained) > 1 else ""
        yield Heading(f"Parts of the variance{of}")
        yield Table([Column("part", 1.6), *_numbers(_GROUPS)], one["groups"])
        if one["modes"]:
            yield Heading(f"Natural modes of the pantograph on the line{of}")
            yield Table([Column("mode", 0.4), *_numbers(_MODES)], one["modes"])
        yield Heading(f"Largest deviations from F_m{of}")
        yield _places(one["worst"], "from F_m")
        yield Heading(f"Largest deviations from what repeats{of}")
        yield _places(one["irregular"], "deviation")
    if explained:
        yield Paragraph(reads, soft=True)


def _numbers(titles: Sequence[str]) -> list[Column]:
    return [Column(title, 1.0, is_number=True) for title in titles]


def _places(rows: Sequence[Sequence[str]], deviation: str) -> Table:
    """Return a table of places; what is not as designed has a column where there is any."""
    columns = [
        *_numbers(("position, m", "span", "force, N", f"{deviation}, N")), Column("where", 2.4)
    ]  # fmt: skip
    changed = any(row[5] for row in rows)
    columns += [Column("not as designed", 1.6)] if changed else []
    return Table(columns, [row[: len(columns)] for row in rows])
