"""Figures and texts → one HTML text that loads nothing."""

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from jinja2 import Environment

# What figures need.
_NEEDED = ("bokeh.embed", "bokeh.models", "bokeh.plotting")


def get_ready() -> None:
    """Import what figures and pages need: it takes as long as a short run, and can go beside it."""
    for name in _NEEDED:
        import_module(name)
    _templates().get_template("page.html")


@cache
def _templates() -> "Environment":
    """Return the templates of this folder; one that was compiled is kept."""
    from jinja2 import Environment, FileSystemLoader

    return Environment(
        autoescape=True,
        trim_blocks=True,
        lstrip_blocks=True,
        loader=FileSystemLoader(Path(__file__).parent),
    )


@contextmanager
def _unchecked() -> Iterator[None]:
    """Leave out Bokeh's look for mistakes in figures, a sixth of a page's time: tests do it."""
    from bokeh.settings import settings

    settings.perform_document_validation.set_value(False)
    try:
        yield
    finally:
        settings.perform_document_validation.unset_value()


def render(
    template: str, figures: Mapping[str, Any], *, widgets: bool = False, **texts: Any
) -> str:
    """Fill a template of this folder.

    Parameters
    ----------
    template
        File name of the template; it finds the figures in `figure`.
    figures
        Figures by their place on the page; None where there is none.
    widgets
        Whether there are tables among the figures.
    **texts
        What else the template shows; escaped there.
    """
    from bokeh.document import Document
    from bokeh.embed import components
    from bokeh.resources import Resources
    from markupsafe import Markup

    drawn = {name: fig for name, fig in figures.items() if fig is not None}
    page = Document()
    with page.models.freeze():  # else every figure that shares data is looked through again
        for fig in drawn.values():
            page.add_root(fig)
    with _unchecked():
        script, places = components(drawn) if drawn else ("", {})
    parts: list[Any] = ["bokeh", "bokeh-widgets", "bokeh-tables"] if widgets else ["bokeh"]
    library = Resources(mode="inline", components=parts, log_level="warn").render()
    filled = _templates().get_template(template)
    return filled.render(
        library=Markup(library),
        script=Markup(script),
        figure={name: Markup(place) for name, place in places.items()},
        **texts,
    )
