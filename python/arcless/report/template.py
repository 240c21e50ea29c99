"""Figures and texts → one HTML text that loads nothing."""

import html
import json
from collections.abc import Mapping
from functools import cache
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

from arcless.report.drawing.bokeh_objects import Model, document

if TYPE_CHECKING:
    from jinja2 import Environment

# Bokeh's script, and the further ones of tables.
_SCRIPTS, _TABLES = ("bokeh",), ("bokeh-widgets", "bokeh-tables")


def import_ahead() -> None:
    """Load the libraries of a run's page, which can be done during the run."""
    _templates().get_template("page.html")
    _library(_SCRIPTS)


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


@cache
def _library(names: tuple[str, ...]) -> str:
    """Return scripts of Bokeh, for the head of a page; Bokeh itself is not imported."""
    found = find_spec("bokeh")
    assert found is not None and found.origin is not None
    folder = Path(found.origin).parent / "server" / "static" / "js"
    texts = [(folder / f"{name}.min.js").read_text("utf-8") for name in names]
    texts.append('Bokeh.set_log_level("warn");')
    return "".join(f"<script>\n{text}\n</script>\n" for text in texts)


def render(
    template: str, figures: Mapping[str, Model | None], *, widgets: bool = False, **texts: Any
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
    from markupsafe import Markup

    drawn = {name: fig for name, fig in figures.items() if fig is not None}
    objects, roots = document(drawn.values())
    filled = _templates().get_template(template)
    return filled.render(
        library=Markup(_library((*_SCRIPTS, *_TABLES) if widgets else _SCRIPTS)),
        script=Markup(_script(objects, roots) if drawn else ""),
        figure={
            name: Markup(f'<div id="{_place(root)}" style="display: contents;"></div>')
            for name, root in zip(drawn, roots, strict=True)
        },
        **texts,
    )


def _place(root: str) -> str:
    return f"figure-{root}"


def _script(objects: list[Any], roots: list[str]) -> str:
    """Return the script that draws, at the end of a page.

    The objects are text between quotes, in which the script undoes what is escaped: no name in it
    ends the text or the page's own script.
    """
    page = {"page": {"version": version("bokeh"), "roots": objects}}
    text = html.escape(json.dumps(page, allow_nan=False, separators=(",", ":")), quote=False)
    text = text.replace("'", "&#x27;").replace("\\", "\\\\")
    places = {root: _place(root) for root in roots}
    items = [{"docid": "page", "roots": places, "root_ids": roots}]
    return f"""<script>
Bokeh.safely(() => {{
const docs_json = '{text}';
Bokeh.embed.embed_items(docs_json, {json.dumps(items)});
}});
</script>"""
