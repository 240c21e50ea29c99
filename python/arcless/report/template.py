"""Figures and texts → one HTML text that loads nothing."""

import json
from base64 import b64encode
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from hashlib import sha256
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

from arcless.figures.description import Figure
from arcless.figures.description.tokens import css, tokens
from arcless.report.drawing.animation import Animation
from arcless.report.drawing.bokeh_figure import Drawing, Drawn, Entry
from arcless.report.drawing.bokeh_objects import Document, document
from arcless.report.drawing.scale_key import ScaleKey, scale_key

if TYPE_CHECKING:
    from jinja2 import Environment

# Bokeh's script.
_SCRIPTS = ("bokeh",)
_HERE = Path(__file__).parent / "pages"


def import_ahead() -> None:
    """Load the libraries of a run's page, which can be done during the run."""
    _templates().get_template("run.html")
    _library(_SCRIPTS)


@cache
def _templates() -> "Environment":
    """Return the templates; one that was compiled is kept."""
    from jinja2 import Environment, FileSystemLoader
    from markupsafe import Markup

    made = Environment(
        autoescape=True,
        trim_blocks=True,
        lstrip_blocks=True,
        loader=FileSystemLoader(_HERE),
    )
    made.globals["tokens_css"] = lambda: Markup(css())
    return made


@dataclass(frozen=True)
class Script:
    """A script of a page, and the hash by which the page's policy of content allows it."""

    text: str
    hash: str


@cache
def _library(names: tuple[str, ...]) -> tuple[Script, ...]:
    """Return the scripts of a page: Bokeh's, which is not imported, then the page's own."""
    found = find_spec("bokeh")
    assert found is not None and found.origin is not None
    folder = Path(found.origin).parent / "server" / "static" / "js"
    texts = [(folder / f"{name}.min.js").read_text("utf-8") for name in names]
    texts.append((_HERE / "page.js").read_text("utf-8"))
    return tuple(_script(f"\n{text}\n") for text in texts)


def _script(text: str) -> Script:
    return Script(text, b64encode(sha256(text.encode()).digest()).decode("ascii"))


@dataclass(frozen=True)
class Shown:
    """A figure as a template shows it.

    Attributes
    ----------
    figure
        Its description: title, caption, alternative text.
    place
        Name of the element that the script draws in.
    legend
        Entries, each with the names of what it shows and hides.
    scale
        Scale of colours; None for a figure without one.
    caption
        Caption; empty where the figure before it, of the same list, has the same.
    """

    figure: Figure
    place: str
    legend: list[tuple[Entry, str]]
    scale: ScaleKey | None
    caption: str


Figures = Mapping[str, "Figure | Sequence[Figure] | None"]


def render(
    template: str,
    figures: Figures,
    *,
    drawing: Drawing | None = None,
    track: Mapping[str, Any] | None = None,
    animation: Animation | None = None,
    **texts: Any,
) -> str:
    """Fill a template of the folder `pages`.

    Parameters
    ----------
    template
        File name of the template; it finds the figures in `figure`, each as a list of `Shown`.
    figures
        Figures by their place on the page, one or several; None where there is none.
    drawing
        Columns that figures and a table share; new ones without. The template finds the name of
        the columns of each selection in `selection`.
    track
        Names of places along the axis of group ``track``, told where the cross hair stands.
    animation
        What the template finds in `animation`; its script comes last.
    **texts
        What else the template shows; escaped there.
    """
    from markupsafe import Markup

    drawing = drawing or Drawing()
    wanted = {name: _listed(found) for name, found in figures.items()}
    drawn = {name: [drawing.draw(one) for one in found] for name, found in wanted.items()}
    plots = [one.plot for found in drawn.values() for one in found]
    written = document(plots)
    data = _data(written, drawing, track or {})
    scripts = _library(_SCRIPTS)
    if animation is not None:
        scripts = (*scripts, _script(f"\n{animation.script}\n"))
        texts["animation"] = {
            "style": Markup(animation.style),
            "data": Markup(animation.data),
            "caption": animation.caption,
        }
    filled = _templates().get_template(template)
    return filled.render(
        scripts=[Markup(f"<script>{script.text}</script>") for script in scripts],
        policy=" ".join(f"'sha256-{script.hash}'" for script in scripts),
        data=Markup(data),
        figure={name: shown_figures(found, written) for name, found in drawn.items() if found},
        selection={
            name: written.name_of(made)
            for name, made in drawing.selections().items()
            if written.has(made)
        },
        **texts,
    )


def _listed(found: "Figure | Sequence[Figure] | None") -> list[Figure]:
    if found is None:
        return []
    return [found] if isinstance(found, Figure) else list(found)


def shown_figures(drawn: Sequence[Drawn], written: Document) -> list[Shown]:
    """Return figures of one list as a template shows them."""
    found = []
    said = ""
    for one in drawn:
        legend = [
            (entry, " ".join(written.name_of(made) for made in entry.drawn)) for entry in one.legend
        ]
        figure = one.figure
        scale = None if figure.scale is None else scale_key(figure.scale)
        caption = "" if figure.caption == said else figure.caption
        said = figure.caption
        found.append(Shown(figure, _place(written.name_of(one.plot)), legend, scale, caption))
    return found


def _place(root: str) -> str:
    return f"plot-{root}"


def _data(written: Document, drawing: Drawing, track: Mapping[str, Any]) -> str:
    """Return what the page's script reads, as JSON in which nothing ends an element of HTML."""
    groups = {
        group: {name: written.name_of(made) for name, made in parts.items()}
        for group, parts in drawing.groups().items()
    }
    page = {
        "objects": {"version": version("bokeh"), "roots": written.roots},
        "places": {name: _place(name) for name in written.names},
        "colours": written.colours,
        "schemes": {scheme: tokens()[scheme] for scheme in ("light", "dark")},
        "groups": groups,
        "track": track,
    }
    text = json.dumps(page, allow_nan=False, separators=(",", ":"), ensure_ascii=False)
    return text.replace("<", "\\u003c").replace("\u2028", "\\u2028").replace("\u2029", "\\u2029")
