"""Comparison → its report on paper: the content of the page, as a document."""

from collections.abc import Mapping, Sequence
from importlib.metadata import version
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
    runs = content["runs"]
    lines = dict.fromkeys(run["line"] for run in runs if run["line"] != NONE)
    versions = dict.fromkeys(run["version"] for run in runs if run["version"] != NONE)
    dates = [str(one.result.metadata["created"] or "") for one in compared.sides if one.result]
    return Document(
        kind="Comparison of runs",
        title=content["title"],
        description=content["differences_read"],
        identity=[
            *((f"Run {n}", _identified(run, f"run {n}")) for n, run in enumerate(runs, start=1)),
            *([("Line" if len(lines) == 1 else "Lines", "; ".join(lines))] if lines else []),
            ("Arcless", ", ".join(versions) or version("arcless")),
        ],
        verdict=None,
        date=max(dates, default=""),
        version=", ".join(versions) or version("arcless"),
        sections=[Section(title, blocks) for title, blocks in _parts(content, figures) if blocks],
    )


def _identified(run: Mapping[str, str], label: str) -> str:
    """Return what a signature on the cover is for: the whole name, the file and its digest.

    A name that the label or the file says is left out.
    """
    digest = "" if run["digest"] == NONE else f"SHA-256 {run['digest']}"
    said = run["name"] == label or run["name"] in run["file"]
    whole = run["full_name"] or ("" if said else run["name"])
    return "; ".join(filter(None, (whole, run["file"], digest)))


def _parts(
    content: Mapping[str, Any], figures: Mapping[str, Sequence[Figure]]
) -> list[tuple[str, list[Block]]]:
    """Return title and content of each section; some have none."""
    drawn: list[tuple[str, list[Block]]] = [
        (title, [Pictures([one]) for name in keys for one in figures[name]])
        for _, title, keys, _ in content["sections"]
    ]
    numbers = _numbers(content["numbers"], content)
    return [
        ("Summary", _summary(content)),
        *drawn,
        ("Bands", _bands(content)),
        ("Simulation against line test", _acceptance(content)),
        ("Numbers", [Paragraph(content["numbers_read"], soft=True), numbers]),
        ("Criteria", [Paragraph("Value and limit of each run.", soft=True), _criteria(content)]),
        ("Changed fields", _changes(content)),
    ]


def _summary(content: Mapping[str, Any]) -> list[Block]:
    blocks: list[Block] = [_runs(content)]
    if content["warnings"]:
        blocks.append(Points(content["warnings"], "To keep in mind"))
    if content["placement"]:
        blocks += [
            Heading(f"Positions of the measurements{_on(content)}"),
            _placement(content),
            Paragraph(content["placement_reads"], soft=True),
        ]
    return [*blocks, *_what_differs(content), Heading("Main differences"),
            _numbers(content["main"], content)]  # fmt: skip


def _what_differs(content: Mapping[str, Any]) -> list[Block]:
    if content["simulated"] < 2:  # noqa: PLR2004 - one run differs from none
        return []
    blocks: list[Block] = [Heading("What differs")]
    if content["few"]:
        blocks.append(_fields(content["few"], content))
        more = content["count"] - len(content["few"])
        if more:
            blocks.append(Paragraph(f"{more} more: see Changed fields.", soft=True))
    else:
        blocks.append(Paragraph(content["same"]))
    return blocks


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


def _on(content: Mapping[str, Any]) -> str:
    return "" if content["placed_on"] is None else f", on the line of {content['placed_on']}"


def _placement(content: Mapping[str, Any]) -> Table:
    of = [Column("of", 0.8)] if content["several"] else []
    columns = [
        Column("measurement", 1.4), *of, Column("placed by", 1.6),
        *(Column(title, 1.0, is_number=True) for title in ("offset", "drift", "correlation")),
        Column("next best", 1.2, is_number=True),
    ]  # fmt: skip
    cells = [
        [content["names"][row["run"]], *([row["pantograph"]] if of else []), *row["cells"]]
        for row in content["placement"]
    ]
    return Table(columns, cells)


def _bands(content: Mapping[str, Any]) -> list[Block]:
    if not content["bands"]:
        return []
    of = [Column("of", 0.8)] if content["several"] else []
    cells = [
        [
            row["label"] if row["kind"] == "filtered" else f"third octave about {row['label']}",
            *([row["pantograph"]] if of else []),
            *(
                Cell(value, ", ".join(filter(None, (difference, alike))) if difference else "")
                for value, difference, alike in row["cells"]
            ),
        ]
        for row in content["bands"]
    ]
    return [
        Paragraph(content["bands_read"], soft=True),
        Table(_heads(content, Column("band", 1.8), *of), cells),
    ]


def _acceptance(content: Mapping[str, Any]) -> list[Block]:
    if not content["acceptance"]:
        return []
    of = [Column("of", 0.8)] if content["several"] else []
    columns = [
        Column("quantity", 2.2), *of, Column("simulated", is_number=True),
        Column("measured", is_number=True), Column("difference", 1.2, is_number=True),
        Column("unit"), Column("tolerance", 1.2, is_number=True), Column("within"),
    ]  # fmt: skip
    blocks: list[Block] = [Paragraph(content["acceptance_reads"], soft=True)]
    for one in content["acceptance"]:
        cells = [
            [
                row["label"], *([row["pantograph"]] if of else []), *row["cells"][:3], row["unit"],
                Cell(row["cells"][3], row["source"]), row["cells"][4],
            ]
            for row in one["rows"]
        ]  # fmt: skip
        blocks += [Heading(f"{one['run']} against {one['measurement']}"), Table(columns, cells)]
    return blocks


def _changes(content: Mapping[str, Any]) -> list[Block]:
    if content["simulated"] < 2:  # noqa: PLR2004 - one run differs from none
        return []
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
