"""What the figures along the track have in common."""

from typing import Any

from arcless.report.reduce import envelope, every
from arcless.report.scene import Scene
from arcless.report.style import LIGHT, SECTION_FILL, add_hover, figure, models, single

X_LABEL = "position along the track, m"
# Points in the file, shared by the pantographs: bounds the size whatever the run's length.
RAW_POINTS, SMOOTH_POINTS = 6000, 3000
# Most supports or droppers that are marked.
MARKS = 1000


def track_figure(scene: Scene, title: str, y_label: str, *, height: int = 290) -> Any:
    """Return an empty figure over the track with the analysis section shaded."""
    fig = figure(title, X_LABEL, y_label, height=height, x_range=scene.track)
    begin, end = scene.assessment.section_m
    fig.add_layout(
        models().BoxAnnotation(
            left=begin, right=end, fill_color=SECTION_FILL, fill_alpha=0.05, level="image"
        )
    )
    return fig


def series(scene: Scene, pantograph: int, values: Any, points: int) -> Any:
    """Return a channel over the position of its pantograph, thinned out."""
    kept = envelope(values, max(200, points // len(scene.pantographs)))
    position = scene.dataset["position"].values[:, pantograph]
    return source(
        {
            "x": single(position[kept]),
            "y": single(values[kept]),
            "t": single(scene.values("time")[kept]),
        }
    )


def support_entry(scene: Scene, fig: Any) -> list[tuple[str, list[Any]]]:
    """Mark the supports; return the entry of the legend."""
    x = scene.values("support_x")
    if not x.size:
        return []
    lines = fig.vspan(
        x=single(x[every(x.size, MARKS)]), line_color=LIGHT, line_dash="dashed", line_width=1
    )
    lines.level = "underlay"
    return [("support", [lines])]


def hover(fig: Any, renderers: list[Any], word: str, form: str) -> None:
    """Show name, value (`form`: a format and its unit), position and time under the pointer."""
    value, unit = form.split(" ")
    tips = [("", "$name"), (word, f"@y{{{value}}} {unit}")]
    tips += [("position", "@x{0.0} m"), ("time", "@t{0.000} s")]
    mode = "vline" if len(renderers) == 1 else "mouse"
    add_hover(fig, renderers, tips, mode=mode, line_policy="nearest")


def source(columns: dict[str, Any]) -> Any:
    """Return columns as Bokeh takes them."""
    return models().ColumnDataSource(columns)
