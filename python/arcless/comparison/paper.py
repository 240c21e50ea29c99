"""Comparison → its report on paper: the content of the page, as a document."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from arcless.comparison.cells import NONE
from arcless.comparison.compared import Compared
from arcless.comparison.content import comparison_content
from arcless.comparison.fields import Field
from arcless.figures.description import Figure
from arcless.report.paper import typeset
from arcless.report.paper.blocks import (
    Block,
    Cell,
    Column,
    Document,
    Heading,
    Paragraph,
    Pictures,
    Points,
    Section,
    Table,
)
from arcless.report.paper.run_paper import tone_of

# Facts in the table of runs, by key and label.
_OF_RUNS = {
    "scenario": "scenario", "line": "line", "pantographs": "pantographs", "speed": "speed",
    "section": "section", "computed": "computed", "version": "Arcless",
}  # fmt: skip


def write(
    compared: Compared,
    figures: Mapping[str, Sequence[Figure]],
    path: str | Path,
    fields: Mapping[str, str] | None = None,
) -> None:
    """Write a comparison as a PDF file; see `Comparison.write_pdf`."""
    target = Path(path)
    typeset.check_target(target)
    typeset.write(document(compared, figures), target, fields or {})


def document(compared: Compared, figures: Mapping[str, Sequence[Figure]]) -> Document:
    """Return the report of a comparison as a document, dated by its latest run."""
    content = comparison_content(compared, figures)
    facts = [one.metadata for one in compared.results]
    lines = dict.fromkeys(run["line"] for run in content["runs"])
    versions = dict.fromkeys(run["version"] for run in content["runs"])
    return Document(
        kind="Comparison of simulations",
        title=content["title"],
        description=f"Differences are to the first run, {compared.names[0]}.",
        identity=[
            *((f"Run {place}", name) for place, name in enumerate(compared.names, start=1)),
            ("Line" if len(lines) == 1 else "Lines", "; ".join(lines)),
            ("Arcless", ", ".join(versions)),
        ],
        verdict=None,
        date=max(str(one["created"] or "") for one in facts),
        version=", ".join(versions),
        sections=[
            Section("Summary", _summary(content)),
            *(
                Section(title, [one for name in keys for one in _pictures(figures[name])])
                for _, title, keys, _ in content["sections"]
            ),
            Section("Numbers", [
                Paragraph(content["numbers_read"], soft=True),
                _numbers(content["numbers"], content),
            ]),
            Section("Criteria", [
                Paragraph("Value and limit of each run.", soft=True), _criteria(content)
            ]),
            Section("Changed fields", _changes(content)),
        ],
    )  # fmt: skip


def _summary(content: Mapping[str, Any]) -> list[Block]:
    blocks: list[Block] = [_runs(content)]
    if content["warnings"]:
        blocks.append(Points(content["warnings"], "To keep in mind"))
    blocks.append(Heading("What differs"))
    if content["few"]:
        blocks.append(_fields(content["few"], content))
        more = content["count"] - len(content["few"])
        if more:
            blocks.append(Paragraph(f"{more} more: see Changed fields.", soft=True))
    else:
        blocks.append(Paragraph(content["same"]))
    return [*blocks, Heading("Main differences"), _numbers(content["main"], content)]


def _heads(content: Mapping[str, Any], *first: Column, is_number: bool = True) -> list[Column]:
    return [*first, *(Column(name, 1.2, is_number) for name in content["names"])]


def _runs(content: Mapping[str, Any]) -> Table:
    runs = content["runs"]
    rows: list[list[Cell | str]] = [
        [label, *(run[key] for run in runs)] for key, label in _OF_RUNS.items()
    ]
    judged = [Cell(run["verdict"], tone=tone_of(run["state"])) for run in runs]
    return Table(
        _heads(content, Column("run", 1.0), is_number=False),
        [*rows, ["limits that decide", *judged]],
    )


def _numbers(rows: Sequence[Mapping[str, Any]], content: Mapping[str, Any]) -> Table:
    of = [Column("of", 0.8)] if content["several"] else []
    cells = [
        [
            row["label"], *([row["pantograph"]] if of else []),
            *(Cell(value, difference) for value, difference in row["cells"]), row["unit"],
        ]
        for row in rows
    ]  # fmt: skip
    return Table([*_heads(content, Column("quantity", 1.8), *of), Column("unit")], cells)


def _criteria(content: Mapping[str, Any]) -> Table:
    of = [Column("of", 0.8)] if content["several"] else []
    cells = [
        [
            row["title"], *([row["pantograph"]] if of else []),
            *(Cell(limit, word, tone_of(state)) for word, state, limit in row["cells"]),
            row["unit"],
        ]
        for row in content["verdicts"]
    ]  # fmt: skip
    return Table([*_heads(content, Column("criterion", 1.8), *of), Column("unit")], cells)


def _changes(content: Mapping[str, Any]) -> list[Block]:
    blocks: list[Block] = [
        Paragraph(
            f"{content['left_out']} Values are as given in the files, and in SI units below where"
            " these are others.", soft=True,
        )
    ]  # fmt: skip
    if not content["fields"]:
        return [*blocks, Paragraph(content["same"])]
    blocks.append(_fields(content["fields"], content))
    more = content["count"] - len(content["fields"])
    if more:
        blocks.append(
            Paragraph(f"{more} more are in the output of `arcless compare --json`.", coded=True)
        )
    return blocks


def _fields(rows: Sequence[Field], content: Mapping[str, Any]) -> Table:
    cells: list[list[Cell | str]] = [
        [one.path, *(_value(one, run) for run in range(len(content["names"])))] for one in rows
    ]
    return Table(_heads(content, Column("field", 1.8, is_code=True), is_number=False), cells)


def _value(field: Field, run: int) -> Cell:
    value = field.values[run]
    if value is None:
        return Cell(NONE)
    return Cell(value, "default" if field.is_default[run] else field.si[run])


def _pictures(figures: Sequence[Figure]) -> list[Pictures]:
    return [Pictures([one]) for one in figures]
