"""Figures as files: SVG, PDF and PNG with title and alternative text, always the same bytes."""

from io import BytesIO
from pathlib import Path
from xml.sax.saxutils import escape

from arcless.errors import FigureError
from arcless.figures.description import Figure
from arcless.figures.description.tokens import Scheme
from arcless.figures.paper.settings import settings
from arcless.figures.paper.sheet import new_sheet
from arcless.storage.whole_files import check_writable, write_bytes

# Dots of an inch in files of dots, enough for print.
_DPI = 300
# Keys of title and alternative text in the files, and those that would hold a date or a version.
_TOLD: dict[str, tuple[str, str, dict[str, None]]] = {
    "svg": ("Title", "Description", {"Date": None, "Creator": None}),
    "pdf": ("Title", "Subject", {"CreationDate": None, "Creator": None, "Producer": None}),
    "png": ("Title", "Description", {"Software": None}),
}


def write(figure: Figure, path: Path, scheme: Scheme, width_mm: float) -> None:
    """Draw a figure and write it; see `paper.save`."""
    form = path.suffix.lower().removeprefix(".")
    if form not in _TOLD:
        raise FigureError(
            "unknown kind of picture",
            where=str(path),
            got=f"`{path.suffix}`" if path.suffix else "no ending",
            expected="`.svg`, `.pdf` or `.png`",
        )
    check_writable(path)
    content = picture(figure, form, scheme, width_mm)
    words = figure.alt or figure.title
    write_bytes(path, _described(content, words) if form == "svg" else content)


def picture(figure: Figure, form: str, scheme: Scheme, width_mm: float) -> bytes:
    """Draw a figure and return the content of its file, of a form in `_TOLD`."""
    sheet = new_sheet(figure, scheme, width_mm)
    title, about, unsaid = _TOLD[form]
    written = BytesIO()
    told = {title: figure.title, about: figure.alt or figure.title, **unsaid}
    with settings():
        sheet.savefig(written, format=form, dpi=_DPI, metadata=told)
    return written.getvalue()


def _described(svg: bytes, words: str) -> bytes:
    """Return an SVG that tells screen readers what it shows.

    Matplotlib writes the title as an element, and other words as metadata, which are not read out.
    """
    head, end, rest = svg.decode("utf-8").partition("</title>")
    head = head.replace(
        "<svg ", '<svg role="img" aria-labelledby="title" aria-describedby="desc" ', 1
    )
    head = head.replace("<title>", '<title id="title">', 1)
    return f'{head}{end}\n <desc id="desc">{escape(words)}</desc>{rest}'.encode()
