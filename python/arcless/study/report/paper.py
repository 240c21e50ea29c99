"""Study → its report on paper: the content of the page, as a document."""

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from arcless.assess import MET, NOT_JUDGED, NOT_MET
from arcless.report.paper import typeset
from arcless.report.paper.blocks import (
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
    Section,
    Table,
    Tone,
)
from arcless.report.paper.run_paper import tone_of
from arcless.study.definition.study import Study
from arcless.study.report import variants
from arcless.study.report.content import StudyContent, study_content
from arcless.study.report.data.record import Record

# Columns of variants that an upright page has room for, and one on its side.
UPRIGHT, ON_SIDE = 8, 14
PERCENTILES = ("1 %", "5 %", "median", "95 %", "99 %")


def write(
    study: Study,
    path: str | Path,
    folder: Path | None = None,
    *,
    fields: Mapping[str, str] | None = None,
) -> None:
    """Write the report of a study as a PDF file, of as many rows as there are.

    Parameters
    ----------
    study
        From `arcless.study.load`.
    path
        The file to write, which ends with ``.pdf``.
    folder
        Its folder; ``runs/studies/NAME`` without.
    fields
        Fields of the cover; see `Result.write_pdf`.

    Raises
    ------
    StudyError
        No study was begun there, or another one; a package is missing.
    OutputError
        As in `Result.write_pdf`.
    """
    target = Path(path)
    typeset.check_target(target)
    typeset.write(document(Record(study, folder)), target, fields or {})


def document(record: Record) -> Document:
    """Return the report of a study as a document, dated by its beginning."""
    content = study_content(record)
    texts = content.texts
    named = [(title, list(made)) for title, made in _sections(content)]
    return Document(
        kind="Study of pantograph and overhead line",
        title=record.study.name,
        description=record.study.description,
        identity=texts["identity"],
        verdict=texts["verdict"],
        date=str(record.state.get("begun", "")),
        version=", ".join(record.status.versions) or texts["version"],
        sections=[Section(title, blocks) for title, blocks in named if blocks],
        appendices=_appendices(content),
    )


def _sections(content: StudyContent) -> Iterator[tuple[str, Iterator[Block]]]:
    """Yield title and content of each section; those without content are left out."""
    texts = content.texts
    done = content.canvas is not None
    yield "Summary", _summary(content)
    if done:
        yield "Criteria", _criteria(texts)
        yield "Outputs", _outputs(texts)
    for section in texts["rows"]:
        yield section.title, _pictures(section, content)
    yield "Spacing of pantographs", map(Paragraph, texts["spacing"])
    yield "Resonance speeds", _speeds(texts)
    yield "Sensitivity", _sensitivity(content)
    yield "Best variants", _best(texts)
    yield "Stopped early", _stops(texts)
    yield "Variants without a value", _reasons(texts)
    yield "What was varied", _varied(texts)
    yield "Run it again", _again(texts)


def _summary(content: StudyContent) -> Iterator[Block]:
    yield Judgement(content.texts["verdict"])
    if content.texts["ranges"]:
        columns = [
            Column("output", 2.0), Column("range", 1.3, is_number=True), Column("unit"),
            Column("limit", 1.3), Column("verdict", 1.1), Column("at", 3.0),
        ]  # fmt: skip
        rows = [
            [
                Cell(one.title, one.about), one.value, one.unit, one.limit,
                Cell(one.verdict, tone=tone_of(_STATES[one.state])), "; ".join(one.ends),
            ]
            for one in content.texts["ranges"]
        ]  # fmt: skip
        yield Table(columns, rows)


# State of an output's range → that of a verdict.
_STATES = {"met": "met", "not-met": "missed", "open": "open", "plain": ""}


def _criteria(texts: Mapping[str, Any]) -> Iterator[Block]:
    if texts["criteria"]:
        columns = [
            Column("criterion", 1.8), Column("values", 1.2, is_number=True),
            Column("limit", 1.4, is_number=True), Column("met", 0.6, is_number=True),
            Column("not met", 0.6, is_number=True), Column("unverified", 1.15, is_number=True),
            Column("too close", 0.75, is_number=True), Column("no value", 0.75, is_number=True),
            Column("mark", 0.8), Column("source", 1.9),
        ]  # fmt: skip
        rows = [
            [
                row["title"], row["value"], Cell(row["limit"], row["how"]), row["met"],
                Cell(row["missed"], tone=tone_of(row["state"]) if row["missed"] != "0" else ""),
                Cell(row["unsure"], tone="open" if row["unsure"] != "0" else ""),
                row["close"], row["none"], Cell(row["mark"], row["decides"]), row["source"],
            ]
            for row in texts["criteria"]
        ]  # fmt: skip
        yield Table(columns, rows)
    if texts["words"]["not_judged"]:
        yield Paragraph(texts["words"]["not_judged"], coded=True)
    yield Paragraph(texts["words"]["judged"], soft=True)


def _outputs(texts: Mapping[str, Any]) -> Iterator[Block]:
    titles = ("values", "minimum", "median", "mean", "maximum", "standard deviation")
    columns = [
        Column("output", 2.6), *(Column(title, 1.0, is_number=True) for title in titles),
        Column("unit"),
    ]  # fmt: skip
    rows = [
        [
            Cell(of.heading, "" if of.about in (of.name, of.title) else of.about),
            str(row["count"]), *row["cells"], of.unit,
        ]
        for row in texts["outputs"]
        for of in [row["column"]]
    ]  # fmt: skip
    yield Table(columns, rows)
    yield Paragraph(texts["words"]["outputs"], soft=True)
    if texts["percentiles"]:
        yield Heading("Percentiles")
        yield Table(
            [Column("output", 1.6), *(Column(p, 1.0, is_number=True) for p in PERCENTILES),
             Column("unit")],
            [
                [of.heading, *(Cell(value, interval) for value, interval in cells), of.unit]
                for of, cells in texts["percentiles"]
            ],
        )  # fmt: skip
        yield Paragraph(texts["words"]["percentiles"], soft=True)


def _pictures(section: Any, content: StudyContent) -> Iterator[Block]:
    if section.text:
        yield Paragraph(section.text, soft=True)
    beside = 2 if section.key == "fronts" else 1
    for _, name in section.groups:
        figures = content.figures[name]
        for begin in range(0, len(figures), beside):
            yield Pictures(figures[begin : begin + beside])


def _speeds(texts: Mapping[str, Any]) -> Iterator[Block]:
    if not (texts["speeds"] or texts["speed_notes"]):
        return
    yield Paragraph(texts["words"]["speeds"], soft=True)
    if texts["speeds"]:
        unit = texts["speed_unit"]
        columns = [
            Column("", is_number=True), Column("kind", 1.3), Column("which", 1.4),
            Column("speed", is_number=True, below=unit), Column("band", 1.0, True, below=unit),
            Column("formula", 1.1), Column("f", is_number=True, below="Hz"),
            Column("remark", 1.5), Column("source", 2.2),
        ]  # fmt: skip
        rows = [
            [
                str(row["number"]), row["kind"], row["name"], row["speed"], row["band"],
                row["formula"], row["frequency"], row["about"], row["source"],
            ]
            for row in texts["speeds"]
        ]  # fmt: skip
        yield Table(columns, rows)
    if texts["speed_notes"]:
        yield Paragraph(f"{'; '.join(texts['speed_notes'])}.", soft=True)


def _sensitivity(content: StudyContent) -> Iterator[Block]:
    parts = content.texts["sensitivity"]
    if parts:
        yield Paragraph(content.texts["words"]["indices"], soft=True)
    for place, part in enumerate(parts):
        yield Heading(part["output"])
        yield Paragraph(part["blocks"], soft=True)
        if part["lines"]:
            columns = [
                Column("variable", 1.4),
                *(Column(title, 1.0, is_number=True) for title in part["titles"]),
            ]
            yield Table(columns, [[name, *cells] for name, cells in part["lines"]])
        figure = content.figures[f"sensitivity {place}"]
        if figure is not None:
            yield Pictures([figure])


def _best(texts: Mapping[str, Any]) -> Iterator[Block]:
    if texts["best"] is None:
        return
    if not texts["best"]:
        yield Paragraph(texts["words"]["no_best"])
        return
    yield Paragraph(f"{texts['words']['best']} The command computes the variant again.", soft=True)
    rows = [[str(one.variant), one.reached, one.values, one.command] for one in texts["best"]]
    yield _commands("objectives", rows)


def _commands(what: str, rows: Sequence[Sequence[str]]) -> Table:
    """Return a table of variants, the command of each below it over the whole width."""
    columns = [
        Column("variant", is_number=True), Column(what, 1.0),
        Column("values of the variables", 1.6, below="and the command"),
    ]  # fmt: skip
    made: list[Sequence[Cell | str]] = []
    for *told, command in rows:
        made.append(told)
        made += [[Cell(command, wide=len(columns), command=True)]] if command else []
    return Table(columns, made)


def _stops(texts: Mapping[str, Any]) -> Iterator[Block]:
    if not texts["stops"]:
        return
    columns = [
        Column("variant", is_number=True), Column("stopped at", 1.0), Column("so far", 1.6),
        Column("reason", 2.0),
    ]  # fmt: skip
    rows = [[str(one.variant), one.place, one.so_far, one.why] for one in texts["stops"]]
    yield Table(columns, rows)
    if texts["more_stops"] > 0:
        yield Paragraph(f"{texts['more_stops']} more are in the table of the study.", soft=True)
    yield Paragraph(texts["words"]["stops"], soft=True)


def _reasons(texts: Mapping[str, Any]) -> Iterator[Block]:
    if not texts["reasons"]:
        return
    columns = [
        Column("status"), Column("variants", is_number=True), Column("reason", 3.0),
        Column("numbers", 1.0),
    ]  # fmt: skip
    rows = [
        [
            Cell(row["status"], tone="not_met" if row["status"] == "failed" else "open"),
            str(row["count"]), row["error"], row["numbers"],
        ]
        for row in texts["reasons"]
    ]  # fmt: skip
    yield Table(columns, rows)
    if texts["more_reasons"] > 0:
        more = f"{texts['more_reasons']} more reasons are in the table of the study."
        yield Paragraph(more, soft=True)
    yield Paragraph(texts["words"]["reasons"], soft=True, coded=True)


def _varied(texts: Mapping[str, Any]) -> Iterator[Block]:
    columns = [
        Column("variable", 1.4), Column("field", 1.6, is_code=True), Column("values", 2.6),
        Column("unit"),
    ]  # fmt: skip
    yield Table(columns, [
        [Cell(row["name"], row["about"]), row["field"], row["values"], row["unit"]]
        for row in texts["variables"]
    ])  # fmt: skip
    if texts["changes"]:
        yield Heading("The same in all variants, other than in the scenario")
        columns = [Column("field", 1.6, is_code=True), Column("value", 2.6)]
        yield Table(columns, [list(one) for one in texts["changes"]])


def _again(texts: Mapping[str, Any]) -> Iterator[Block]:
    yield Pairs(texts["facts"])
    if texts["again"]:
        yield Code(texts["again"])


def _appendices(content: StudyContent) -> list[Section]:
    if content.canvas is None:
        return []
    columns = variants.columns(content.canvas)
    on_side = len(columns) > UPRIGHT
    shown = list(_variants(content, columns, ON_SIDE if on_side else UPRIGHT))
    marked = list(_marked(content))
    return [
        Section("Variants", shown, on_side),
        *([Section("Lowest and highest", marked)] if marked else []),
    ]


def _variants(
    content: StudyContent, columns: Sequence[variants.VariantColumn], most: int
) -> Iterator[Block]:
    """Yield all variants as a table, or as several with the most columns that a page holds."""
    first, *others = columns
    count, done = len(first.entries), content.texts["status"].done
    shown = min(count, variants.PRINTED)
    some = "" if shown == done else f"{shown} of {done} variants; all are in table.parquet. "
    yield Paragraph(
        f"{some}Variables have the units of the study file; table.parquet has SI.", soft=True
    )
    for begin in range(0, len(others), most - 1):
        chosen = [first, *others[begin : begin + most - 1]]
        cells = [[_cell(entry) for entry in column.entries[:shown]] for column in chosen]
        rows = list(zip(*cells, strict=True))
        yield Table([_head(column) for column in chosen], rows)


def _marked(content: StudyContent) -> Iterator[Block]:
    assert content.canvas is not None, "there is no appendix without variants"
    marked = variants.marked(content.canvas)
    if marked:
        yield Paragraph(f"{content.texts['words']['lowest']} Each command computes a variant again,"
                        " with report and full result.", soft=True)  # fmt: skip
        rows = [[str(one.variant), one.why, one.values, one.command] for one in marked]
        yield _commands("why", rows)


def _head(column: variants.VariantColumn) -> Column:
    share = 1.0 if column.name != "variant" else 0.0
    return Column(column.name, share, column.kind == "number", below=column.below)


def _cell(entry: variants.Entry) -> Cell:
    tones: dict[str, Tone] = {MET: "met", NOT_MET: "not_met", NOT_JUDGED: ""}
    return Cell(f"{entry.sign} {entry.text}".strip(), entry.end, tones.get(entry.verdict, "open"))
