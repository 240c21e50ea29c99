"""Axis, supports and tooltips of the figures along the track."""

from typing import Any

from arcless.report.drawing.bokeh_objects import Model, columns
from arcless.report.drawing.figure import Figure
from arcless.report.drawing.style import HEIGHT, LIGHT, add_hover, add_section, figure, single
from arcless.report.drawing.thinning import envelope, every
from arcless.report.figures.run_data import RunData

X_LABEL = "position along the track, m"
# Points in the file, shared by the pantographs: bounds the size whatever the run's length.
RAW_POINTS, SMOOTH_POINTS = 6000, 3000
# Most supports or droppers that are marked.
MARKS = 1000


def track_figure(scene: RunData, title: str, y_label: str, *, height: int = HEIGHT) -> Figure:
    """Return an empty figure over the track with the analysis section shaded."""
    fig = figure(title, X_LABEL, y_label, height=height, x_range=scene.track)
    add_section(fig, *scene.assessment.section_m)
    return fig


def series(scene: RunData, pantograph: int, values: Any, points: int) -> Model:
    """Return a channel over the position of its pantograph, thinned out."""
    kept = envelope(values, max(200, points // len(scene.pantographs)))
    position = scene.dataset["position"].values[:, pantograph]
    return columns(
        {
            "x": single(position[kept]),
            "y": single(values[kept]),
            "t": single(scene.values("time")[kept]),
        }
    )


def support_entry(scene: RunData, fig: Figure) -> list[tuple[str, list[Model]]]:
    """Mark the supports; return the entry of the legend."""
    x = scene.values("support_x")
    if not x.size:
        return []
    places = {"x": single(x[every(x.size, MARKS)])}
    lines = fig.draw("VSpan", places, level="underlay", color=LIGHT, line_dash="dashed")
    return [("support", [lines])]


def hover(fig: Figure, renderers: list[Model], word: str, form: str) -> None:
    """Show name, value (`form`: a format and its unit), position and time under the pointer."""
    value, unit = form.split(" ")
    tips = [("", "$name"), (word, f"@y{{{value}}} {unit}")]
    tips += [("position", "@x{0.0} m"), ("time", "@t{0.000} s")]
    mode = "vline" if len(renderers) == 1 else "mouse"
    add_hover(fig, renderers, tips, mode=mode, line_policy="nearest")
