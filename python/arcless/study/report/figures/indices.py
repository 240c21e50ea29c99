"""Figures of sensitivity: shares of the variance, and Morris' elementary effects."""

from typing import Any

import numpy as np

from arcless.figures.description import Axis, Figure, Layer, Points, Segments, Texts, Tip
from arcless.figures.description.tokens import of_series

# Column of the table → key of its value, and of the half width of its interval.
SOBOL = {"first order": ("first", "first_interval"), "total": ("total", "total_interval")}
# Distance of the marks of one variable.
_APART = 0.24


def shares(key: str, output: str, values: dict[str, Any]) -> Figure:
    """Return the Sobol indices of an output, a row for each variable."""
    names = list(values)
    rows = np.arange(len(names))[::-1].astype(float)
    layers: list[Layer] = []
    for place, (title, (index, interval)) in enumerate(SOBOL.items()):
        middle = np.array([one[index] for one in values.values()], dtype=float)
        half = np.array([one[interval] or 0.0 for one in values.values()], dtype=float)
        y = rows + _APART * (0.5 - place)
        look: dict[str, Any] = {"colour": of_series(place), "name": f"{title}, with 95 % interval"}
        tips = (
            Tip("", names, form=""), Tip(title, middle, form="0.000"),
            Tip("from", middle - half, form="0.000"), Tip("to", middle + half, form="0.000"),
        )  # fmt: skip
        layers += [
            Segments(middle - half, y, middle + half, y, width=2.0, **look),
            Points(middle, y, size=8.0, tips=tips, **look),
        ]
    first = max(values, key=lambda name: values[name]["total"] or 0.0)
    return Figure(
        f"{key}-indices", f"Share of the variance of {output}",
        Axis("Sobol index"),
        Axis("", "", -0.6, len(names) - 0.4, categories=tuple(names[::-1])), layers,
        alt=f"Sobol indices of {output}; the largest total index is that of {first},"
        f" {values[first]['total']:.3g}.",
        height=90 + 40 * len(names),
    )  # fmt: skip


def effects(key: str, output: str, values: dict[str, Any]) -> Figure:
    """Return Morris' effects on an output: their size against their deviation."""
    names = list(values)
    x = np.array([one["mu_star"] for one in values.values()], dtype=float)
    y = np.array([one["sigma"] for one in values.values()], dtype=float)
    tips = (Tip("", names, form=""), Tip("μ*", "x", form="0.000"), Tip("σ", "y", form="0.000"))
    first = names[int(np.nanargmax(x))]
    high = 1.25 * float(np.nanmax(x)) or 1.0
    top = 1.15 * float(np.nanmax(y)) or 1.0
    return Figure(
        f"{key}-effects", f"Effects on {output}",
        Axis("mean size of the effects μ*", "", 0.0, high),
        Axis("deviation σ of the effects", "", 0.0, top),
        [
            Points(x, y, colour="series_1", size=9.0, tips=tips),
            Texts(x + 0.012 * high, y, names, align="left", size=12.0),
        ],
        alt=f"Elementary effects on {output}; the largest mean size is that of {first}.",
    )  # fmt: skip
