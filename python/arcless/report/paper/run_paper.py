"""A run → its report on paper: the content of the page, as a document."""

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from arcless.assess import Assessment
from arcless.figures.description import Figure
from arcless.figures.run import figures
from arcless.figures.run.run_data import RunData
from arcless.report.model_data import Group, Row
from arcless.report.paper import typeset
from arcless.report.paper.blocks import (
    Bars,
    Block,
    Cell,
    Code,
    Column,
    Document,
    Heading,
    Judgement,
    Pairs,
    Paragraph,
    Pictures,
    Points,
    Section,
    Table,
    Tone,
)
from arcless.report.paper.explained import explained_tables, said
from arcless.report.run_content import ReportedRun, Rows, run_content
from arcless.report.tables import TIMES

UNSURE = "Uncertainty was not computed; `arcless run --certainty` computes it."
SURE = (
    "± is the uncertainty of the difference between value and limit: spread over starts plus error"
    " of discretisation, see Certainty of the numbers."
)
# Verdict on a criterion, or place in a published range → meaning of its colour.
_TONES: dict[str, Tone] = {
    "met": "met", "inside": "met", "missed": "not_met", "outside": "not_met", "absent": ""
}  # fmt: skip


def write(
    result: ReportedRun,
    path: str | Path,
    *,
    fields: Mapping[str, str] | None = None,
    assessment: Assessment | None = None,
    reference_rows: Rows = (),
) -> None:
    """Write the report of a run as a PDF file; see `Result.write_pdf`."""
    target = Path(path)
    typeset.check_target(target)
    made = document(result, assessment=assessment, reference_rows=reference_rows)
    typeset.write(made, target, fields or {})


def document(
    result: ReportedRun, *, assessment: Assessment | None = None, reference_rows: Rows = ()
) -> Document:
    """Return the report of a run as a document."""
    run = RunData(result.latest, assessment or result.assessment)
    drawn = figures(run)
    content = run_content(result, run, drawn, reference_rows)
    facts = content["facts"]
    sections = [
        Section("Summary", _summary(content, drawn)),
        Section(f"Criteria, {run.assessment.supply}", _criteria(content)),
        Section("Numbers", _numbers(content)),
        *(
            Section(title, list(_section(key, names, content, drawn)))
            for key, title, names in content["sections"]
        ),
    ]
    if content["certainty"]:
        sections.append(Section("Certainty of the numbers", _certainty(content)))
    sections += [
        Section("Model data", list(_model(content))),
        Section("Computation", _computation(content, drawn)),
        Section("Sources", _sources(content)),
    ]
    defaults = list(_defaults(content))
    return Document(
        kind="Simulation of pantograph and overhead line",
        title=str(facts["scenario_name"]),
        description=content["description"],
        identity=content["identity"],
        verdict=content["verdict"],
        date=str(facts["created"] or ""),
        version=str(facts["arcless_version"] or "–"),
        sections=sections,
        appendices=[Section("Defaults of Arcless", defaults)] if defaults else [],
    )


def tone_of(state: str) -> Tone:
    """Return the meaning of the colour of a verdict, as tables of pages have it."""
    return _TONES.get(state, "open" if state else "")


def _summary(content: Mapping[str, Any], drawn: Mapping[str, Sequence[Figure]]) -> list[Block]:
    sure = Paragraph(SURE) if content["certainty"] else Paragraph(UNSURE, coded=True)
    texts = [Paragraph(f"{content['judged_on']} Worst place: {content['worst']}"), sure]
    blocks: list[Block] = [Judgement(content["verdict"], texts)]
    if content["warnings"]:
        blocks.append(Points(content["warnings"], "Warnings"))
    return [*blocks, Bars(content["bullets"]), *(Pictures([one]) for one in drawn["lead"])]


def _criteria(content: Mapping[str, Any]) -> list[Block]:
    several = len(content["assessment"].pantographs) > 1
    columns = [
        Column("criterion", 2.4),
        *([Column("of")] if several else []),
        Column("value", is_number=True), Column("limit", is_number=True),
        Column("margin", is_number=True), Column("unit"), Column("verdict", 1.1),
        Column("mark"), Column("source", 2.4),
    ]  # fmt: skip
    rows = [
        [
            Cell(row["title"], row["note"]), *([row["pantograph"]] if several else []),
            row["value"], row["limit"], row["margin"], row["unit"],
            Cell(row["verdict"], row["reason"], tone_of(row["state"])), row["mark"], row["source"],
        ]
        for row in content["criteria"]
    ]  # fmt: skip
    notes = content["assessment"].notes
    blocks: list[Block] = [
        Table(columns, rows),
        Paragraph(
            "Margin: distance to the limit with its tolerance, negative beyond it.", soft=True
        ),
    ]
    if notes:
        blocks.append(Points(notes, "Notes", coded=True))
    return [*blocks, Paragraph(content["marks_mean"], soft=True), _pairs(content["marks"])]


def _numbers(content: Mapping[str, Any]) -> list[Block]:
    names = [one.name for one in content["assessment"].pantographs]
    columns = [
        Column("quantity", 1.0),
        *(Column(name, 0.35, is_number=True) for name in names),
        Column("unit"),
    ]
    rows = [
        [label, *(Cell(value, wide=len(names) // len(values)) for value in values), unit]
        for part in content["numbers"]
        for label, unit, values in part
    ]
    blocks: list[Block] = [Paragraph(content["numbers_of"], soft=True), Table(columns, rows)]
    if content["reference_rows"]:
        blocks += [Heading("Published ranges"), _published(content["reference_rows"])]
    return blocks


def _published(rows: Sequence[Mapping[str, str]]) -> Table:
    columns = [
        Column("quantity", 2.0), Column("this run", is_number=True), Column("from", is_number=True),
        Column("to", is_number=True), Column("verdict", 1.0), Column("mark"), Column("source", 2.0),
    ]  # fmt: skip
    cells: list[list[Cell | str]] = [
        [
            row["quantity"], row["value"], row["low"], row["high"],
            Cell(row["verdict"], tone=tone_of(row["verdict"])), row["mark"], row["source"],
        ]
        for row in rows
    ]  # fmt: skip
    return Table(columns, cells)


def _section(
    key: str,
    names: Sequence[str | Sequence[str]],
    content: Mapping[str, Any],
    drawn: Mapping[str, Sequence[Figure]],
) -> Iterator[Block]:
    """Yield the figures of a section; those on σ have sentences before and tables after them."""
    explained = content["explained"] if key == "contributions" else []
    yield from said(explained)
    yield from _pictures(names, drawn)
    yield from explained_tables(explained, content["explained_reads"])


def _pictures(
    names: Sequence[str | Sequence[str]], drawn: Mapping[str, Sequence[Figure]]
) -> Iterator[Pictures]:
    """Yield the figures of a section; those of an inner list stand next to each other."""
    for name in names:
        if isinstance(name, str):
            yield from (Pictures([one]) for one in drawn[name])
        else:
            yield Pictures([one for each in name for one in drawn[each]])


def _certainty(content: Mapping[str, Any]) -> list[Block]:
    columns = [
        Column("quantity", 1.0), Column("of"), Column("spread", is_number=True),
        Column("discretisation", is_number=True), Column("unit"),
    ]  # fmt: skip
    rows = [
        [row["label"], row["pantograph"], row["spread"], row["discretisation"], row["unit"]]
        for row in content["certainty"]
    ]
    return [
        *(Paragraph(text) for text in content["certainty_words"]),
        Paragraph(content["certainty_reads"], soft=True),
        Table(columns, rows),
    ]


def _model(content: Mapping[str, Any]) -> Iterator[Block]:
    yield Paragraph(
        "Values as given in the files, and in SI units below where these are others. Marks are"
        " explained under Criteria, sources at the end.", soft=True,
    )  # fmt: skip
    for group in content["groups"]:
        yield Heading(group.title)
        if group.description:
            yield Paragraph(group.description, soft=True)
        if group.given:
            yield _values(group.given)
        if group.left_out:
            yield Paragraph(f"{group.left_out} more values are in the result file.", soft=True)


def _defaults(content: Mapping[str, Any]) -> Iterator[Block]:
    groups: list[Group] = content["groups"]
    for group in groups:
        if group.defaults:
            yield from (Heading(group.title), _values(group.defaults))


def _values(rows: Sequence[Row]) -> Table:
    columns = [
        Column("field", 2.6, is_code=True), Column("value", 2.0), Column("mark"),
        Column("source", 1.1), Column("note", 2.0),
    ]  # fmt: skip
    cells: list[list[Cell | str]] = [
        [row.path, Cell(row.value, row.si), row.mark, row.source, row.note] for row in rows
    ]
    used = [
        place for place, column in enumerate(columns)
        if column.title in ("field", "value") or any(row[place] for row in cells)
    ]  # fmt: skip
    return Table([columns[k] for k in used], [[row[k] for k in used] for row in cells])


def _computation(content: Mapping[str, Any], drawn: Mapping[str, Sequence[Figure]]) -> list[Block]:
    told = [(label, text) for label, text in content["computation"] if label not in TIMES]
    blocks: list[Block] = [Pairs(told)]
    if content["facts"]["command"]:
        blocks += [
            Paragraph("The command that computes this run:"), Code(content["facts"]["command"])
        ]  # fmt: skip
    if content["energies"]:
        columns = [
            Column("term", 1.0),
            Column("meaning", 2.0),
            Column("at the end, J", is_number=True),
        ]
        blocks += [
            *(Pictures([one]) for one in drawn["energy"]),
            Table(columns, [list(row) for row in content["energies"]]),
        ]
    return blocks


def _sources(content: Mapping[str, Any]) -> list[Block]:
    """Return what limits, published ranges and values of the model are from, each source once."""
    said = [row["source"] for row in (*content["criteria"], *content["reference_rows"])]
    blocks: list[Block] = [
        Points(list(dict.fromkeys(text for text in said if text)), "Criteria and ranges")
    ]
    for group in content["groups"]:
        if group.sources:
            blocks += [Heading(group.title), _pairs(group.sources)]
    return blocks


def _pairs(found: Mapping[str, str]) -> Pairs:
    return Pairs(list(found.items()))
