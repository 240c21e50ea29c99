"""Document → PDF by typst: PDF/UA-1 and PDF/A-2a, the same bytes on every machine.

All texts go to the template `document.typ` as data, none as markup. PDF/UA-1 (ISO 14289-1) and
PDF/A-2a (ISO 19005-2) want tags, embedded fonts, and words for each figure: typst refuses a
document that lacks them. Fonts of the system are not looked at, the date is that of what is
reported.
"""

import json
import warnings
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import fields as parts_of
from datetime import UTC, datetime
from functools import singledispatch
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

from arcless.errors import OutputError
from arcless.figures import paper
from arcless.figures.description import Figure, Map, Texts
from arcless.figures.description.tokens import tokens
from arcless.report.paper import blocks, letters
from arcless.report.paper import fields as cover
from arcless.storage.endings import check_ending
from arcless.storage.whole_files import check_writable, write_bytes

if TYPE_CHECKING:
    from typst import PDFStandard

SUFFIX = ".pdf"
STANDARDS: "list[PDFStandard]" = ["a-2a", "ua-1"]
# Width of the text, and of figures of which so many stand next to each other, in mm.
WIDTH_MM, GAP_MM = 170.0, 6.0
# Height of figures over that on a page of the screen: alone, where three have room on a page of
# paper under a heading, and next to others.
HEIGHT, PAIRED_HEIGHT = 0.64, 0.56
# Letters that are missing are named up to this number.
_MOST_NAMED = 10
_TEMPLATE = Path(__file__).with_name("document.typ")
_NEEDED = ("typst", "matplotlib")


def check_target(path: Path) -> None:
    """Refuse, before anything is read or drawn, a document that could not be written.

    Raises
    ------
    OutputError
        Its name does not end in ``.pdf``, a package is missing, or the place is none.
    """
    check_ending(path, (SUFFIX,), "not a .pdf file")
    for package in _NEEDED:
        if find_spec(package) is None:
            raise OutputError(
                f"a .pdf file needs the package {package}, which is not installed",
                where=str(path),
                hint="pip install 'arcless[pdf]'",
            )
    check_writable(path)


def write(document: blocks.Document, path: Path, fields: Mapping[str, str]) -> None:
    """Write a document; see `check_target` and `pdf`."""
    check_target(path)
    write_bytes(path, pdf(document, fields))


def pdf(document: blocks.Document, fields: Mapping[str, str]) -> bytes:
    """Return a document as the bytes of a PDF file.

    Parameters
    ----------
    document
        What it says.
    fields
        Fields of the cover by their names: ``author`` also stands in the properties of the file,
        ``document`` in the head of each page, ``prepared``, ``checked`` and ``approved`` at the
        lines for signatures; all others are listed as they are.

    Raises
    ------
    OutputError
        A field is empty or too long, or typst refuses the document.
    """
    import typst

    given = inputs(document, fields)
    try:
        made = typst.compile(
            _TEMPLATE,
            root=_TEMPLATE.parent,
            format="pdf",
            sys_inputs=given,
            font_paths=[letters.fonts()],
            ignore_system_fonts=True,
            pdf_standards=STANDARDS,
            timestamp=_seconds(document.date),
        )
    except typst.TypstError as error:
        raise OutputError(
            "the document cannot be typeset",
            got=f"`{error}` of typst",
            hint="the HTML page has the same content; report this as a defect",
        ) from error
    assert isinstance(made, bytes), "typst gives a document of one file"
    return made


def inputs(document: blocks.Document, fields: Mapping[str, str]) -> dict[str, str]:
    """Return what the template reads: all texts and drawings, as JSON.

    Raises
    ------
    OutputError
        A field is empty or too long.
    """
    cover.check_fields(fields)
    data = _data(document, fields)
    missing = letters.lacking(letters.texts_of(data))
    if missing:
        named = " ".join(missing[:_MOST_NAMED]) + (" …" if missing[_MOST_NAMED:] else "")
        warnings.warn(
            f"letters that the typeface of the document lacks are shown as {letters.INSTEAD}:"
            f" {named}",
            letters.MissingLettersWarning,
            stacklevel=2,
        )
    return {"data": json.dumps(letters.settable(data), ensure_ascii=False)}


def _seconds(date: str) -> int:
    """Return a date of ISO 8601 in seconds of Unix, at 0 for none; without a zone it is UTC."""
    try:
        found = datetime.fromisoformat(date)
    except ValueError:
        return 0
    return round((found if found.tzinfo else found.replace(tzinfo=UTC)).timestamp())


def _data(document: blocks.Document, fields: Mapping[str, str]) -> dict[str, Any]:
    """Return what the template reads."""
    made: dict[str, Any] = _plain(document)
    return {
        **made,
        "fields": cover.shown(fields),
        "signatures": cover.signatures(fields),
        "author": cover.of(fields, "author"),
        "document": cover.of(fields, "document"),
        "when": document.date[:16].replace("T", " "),
        "colours": tokens()["light"],
    }


@singledispatch
def _plain(part: Any) -> Any:
    """Return a part of a document as plain data, a block with the name of its kind."""
    if isinstance(part, Mapping):
        return {key: _plain(value) for key, value in part.items()}
    if isinstance(part, Sequence) and not isinstance(part, str):
        return [_plain(value) for value in part]
    if hasattr(part, "__dataclass_fields__"):
        named = {one.name: _plain(getattr(part, one.name)) for one in parts_of(part)}
        return {"block": type(part).__name__.lower(), **named}
    return part


@_plain.register
def _(part: blocks.Pictures) -> dict[str, Any]:
    return {"block": "pictures", "figures": list(_drawn(part.figures))}


def _drawn(figures: Sequence[Figure]) -> Iterator[dict[str, Any]]:
    """Draw figures that stand next to each other."""
    count = len(figures)
    width = (WIDTH_MM - (count - 1) * GAP_MM) / count
    for figure in figures:
        height = PAIRED_HEIGHT if count > 1 else 1.0 if _is_lettered_map(figure) else HEIGHT
        with warnings.catch_warnings():
            # Letters that are missing are told once for the whole document.
            warnings.filterwarnings("ignore", message="Glyph .* missing from", category=UserWarning)
            drawn = paper.svg(figure, width_mm=width, factor=height)
        yield {
            "svg": drawn,
            "width": width,
            "title": figure.title,
            "caption": figure.caption,
            "alt": figure.alt or figure.title,
        }


def _is_lettered_map(figure: Figure) -> bool:
    """Return whether a figure has texts in cells of a map, which need their room."""
    kinds = {type(layer) for layer in figure.layers}
    return {Map, Texts} <= kinds
