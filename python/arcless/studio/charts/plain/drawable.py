"""Descriptions of figures → plain data for the page, long curves thinned for what is shown.

Numbers of layers travel as singles in base64, little-endian, NaN where there is none: a tenth of
the time that texts of numbers take to write and to read. A single has 24 bits: at 50 km a place is
known to 4 mm, a twentieth of what a train runs in a millisecond.
"""

import math
from base64 import b64encode
from collections.abc import Callable, Iterable, Mapping
from dataclasses import asdict, dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.figures.description import Curve, Figure, Layer, Map, Scale
from arcless.figures.description.tokens import tokens
from arcless.studio.charts.plain.pyramid import Pyramid

# Samples of a curve where nobody says how many: two on each pixel of a wide chart.
USUAL_POINTS = 4000
# Fewest and most that may be asked for: one bucket; more than any screen shows.
LEAST_POINTS, MOST_POINTS = 16, 40_000

Pyramids = Callable[[NDArray[Any]], Pyramid]


@dataclass(frozen=True)
class Shown:
    """Range and resolution that a figure is asked for.

    Attributes
    ----------
    low, high
        Ends along the first axis; infinite for all of it. A sample beyond each end is told as well.
    points
        Most samples of each curve.
    """

    low: float = -math.inf
    high: float = math.inf
    points: int = USUAL_POINTS


def head(figure: Figure) -> dict[str, Any]:
    """Return what stands around a figure: title, axes, caption, alternative text; no layers."""
    return {
        "key": figure.key,
        "title": figure.title,
        "caption": figure.caption,
        "alt": figure.alt,
        "height": figure.height,
        "x": asdict(figure.x) | {"title": figure.x.title},
        "y": asdict(figure.y) | {"title": figure.y.title},
        "scale": None if figure.scale is None else _scale(figure.scale),
    }


def heads(figures: Mapping[str, Iterable[Figure]]) -> dict[str, list[dict[str, Any]]]:
    """Return the heads of figures by their keys."""
    return {key: [head(one) for one in group] for key, group in figures.items()}


def drawable(figure: Figure, shown: Shown, pyramids: Pyramids) -> dict[str, Any]:
    """Return a figure with its layers, ready for JSON.

    Parameters
    ----------
    figure
        The figure.
    shown
        What of it is looked at; curves whose places do not rise are told as a whole.
    pyramids
        Array → its pyramid, as the run keeps it.
    """
    return head(figure) | {"layers": [_layer(one, shown, pyramids) for one in figure.layers]}


def packed(values: Any) -> str:
    """Return numbers as little-endian singles in base64."""
    return b64encode(np.asarray(values, dtype="<f4").tobytes()).decode("ascii")


def _scale(scale: Scale) -> dict[str, Any]:
    return asdict(scale) | {"title": scale.title, "order": tokens()["orders"][scale.colours]}


def _layer(layer: Layer, shown: Shown, pyramids: Pyramids) -> dict[str, Any]:
    found: dict[str, Any] = {"kind": type(layer).__name__.lower()}
    kept, count = None, 0
    if isinstance(layer, Curve):
        kept, count = _kept(layer, shown, pyramids), layer.x.size
        found |= {"samples": count}
    for field in fields(layer):
        value = getattr(layer, field.name)
        if field.name == "tips":
            value = [_tip(one, kept, count) for one in value]
        elif isinstance(value, np.ndarray):
            value = packed(value if kept is None else value[kept])
        found[field.name] = value
    if isinstance(layer, Map):
        found["shape"] = list(layer.values.shape)
    return found


def _tip(tip: Any, kept: NDArray[Any] | None, count: int) -> dict[str, Any]:
    """Return a line under the pointer; of a thinned curve with values of the samples kept."""
    values = tip.values
    if not isinstance(values, str):
        texts = isinstance(values, list | tuple) and bool(values) and isinstance(values[0], str)
        many = values if texts else np.asarray(values)
        if kept is not None and len(many) == count:
            many = [many[row] for row in kept] if texts else many[kept]
        values = {"texts": list(many)} if texts else {"numbers": packed(many)}
    return {"label": tip.label, "unit": tip.unit, "form": tip.form, "values": values}


def _kept(curve: Curve, shown: Shown, pyramids: Pyramids) -> NDArray[np.int32]:
    """Return the samples of a curve to draw."""
    begin, end = 0, curve.x.size
    if end == 0:
        return np.empty(0, dtype=np.int32)
    if bool(np.all(curve.x[1:] >= curve.x[:-1])):
        begin, end = span(curve.x, shown.low, shown.high)
    if end - begin <= shown.points:
        return np.arange(begin, end, dtype=np.int32)
    return pyramids(curve.y).samples(begin, end, shown.points)


def span(x: NDArray[Any], low: float, high: float) -> tuple[int, int]:
    """Return the samples between two places that rise, and one beyond each end.

    Parameters
    ----------
    x
        Places that do not fall.
    low, high
        Ends of the range.

    Returns
    -------
    tuple of int
        The first sample, and the one after the last.
    """
    begin = max(0, int(np.searchsorted(x, low, side="left")) - 1)
    end = min(x.size, int(np.searchsorted(x, high, side="right")) + 1)
    return begin, max(begin, end)
