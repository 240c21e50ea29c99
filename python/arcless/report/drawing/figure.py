"""A figure of a page, to be drawn by Bokeh's script: axes, what is drawn, legend and tools."""

from collections.abc import Mapping
from typing import Any

from arcless.report.drawing.bokeh_objects import Field, Model, columns

# Kind of drawing → its places, each a column, and what takes its colour and opacity.
_PLACES = {
    "Line": ("x", "y"),
    "MultiLine": ("xs", "ys"),
    "Segment": ("x0", "y0", "x1", "y1"),
    "VSpan": ("x",),
    "Scatter": ("x", "y"),
    "Quad": ("left", "right", "top", "bottom"),
    "Text": ("x", "y", "text"),
}
_PARTS = {"Scatter": ("line", "fill"), "Quad": ("line", "fill"), "Text": ("text",)}


class Figure(Model):
    """An empty figure: two axes with a grid, and tools.

    Parameters
    ----------
    x_axis, y_axis
        Objects of the script.
    tools
        Objects of the script, in the order of the toolbar; the first one is what a drag does.
    **attributes
        Others of the script's `Plot`.
    """

    __slots__ = ()

    def __init__(self, x_axis: Model, y_axis: Model, tools: list[Model], **attributes: Any) -> None:
        super().__init__("Plot", **attributes)
        self.renderers: list[Model] = []
        self.below, self.left = [x_axis], [y_axis]
        self.above: list[Model] = []
        self.right: list[Model] = []
        self.center = [Model("Grid", axis=x_axis), Model("Grid", axis=y_axis, dimension=1)]
        self.toolbar = Model(
            "Toolbar", tools=tools, active_drag=tools[0], active_scroll=None, logo=None
        )

    @property
    def xaxis(self) -> Model:
        """The horizontal axis."""
        return self.below[0]

    @property
    def yaxis(self) -> Model:
        """The axis upwards."""
        return self.left[0]

    def draw(
        self,
        kind: str,
        data: Model | Mapping[str, Any],
        *places: str,
        name: str | None = None,
        level: str | None = None,
        unselected: float | None = None,
        **look: Any,
    ) -> Model:
        """Draw columns; return the object that a legend or the pointer refers to.

        Parameters
        ----------
        kind
            The script's name of what is drawn.
        data
            Columns, or a source that several drawings share.
        *places
            Names of the columns, in the order of `_PLACES`; without, columns are named as there.
        name
            What the pointer shows as ``$name``.
        level
            ``"underlay"`` puts it below the others.
        unselected
            Opacity of what is not selected while something is.
        **look
            Attributes; `color` and `alpha` are those of all parts of the kind.
        """
        glyph = Model(kind, **_look(kind, look))
        for place, column in zip(_PLACES[kind], places or _PLACES[kind], strict=True):
            setattr(glyph, place, Field(column))
        source = data if isinstance(data, Model) else columns(data)
        drawn = Model("GlyphRenderer", data_source=source, glyph=glyph, name=name)
        if level is not None:
            drawn.level = level
        if unselected is not None:
            faded = _look(kind, {"alpha": unselected})
            drawn.nonselection_glyph = Model(kind, **{**vars(glyph), **faded})
        self.renderers.append(drawn)
        return drawn


def _look(kind: str, look: dict[str, Any]) -> dict[str, Any]:
    """Return attributes, those without a part as those of all parts."""
    of_all = {key: look[key] for key in ("color", "alpha") if key in look}
    spread = {f"{part}_{key}": value for part in _PARTS.get(kind, ("line",))
              for key, value in of_all.items()}  # fmt: skip
    return spread | {key: value for key, value in look.items() if key not in of_all}
