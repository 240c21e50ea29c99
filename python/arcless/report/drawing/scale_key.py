"""Scale of colours of a figure as its page shows it: a strip of the colours, with numbers below."""

from dataclasses import dataclass

import numpy as np

from arcless.display.numbers import number
from arcless.figures.description import Scale
from arcless.figures.description.tokens import tokens

# Most intervals between numbers below the strip, and the lengths that they may have.
_MOST, _STEPS = 5, (1.0, 2.0, 2.5, 5.0, 10.0)


@dataclass(frozen=True)
class ScaleKey:
    """Strip of colours with numbers, as a page shows a scale.

    Attributes
    ----------
    title
        Quantity and unit.
    gradient
        Its colours from left to right, as a background of CSS.
    ticks
        Place from the left in %, and number.
    under, under_label
        Token and meaning of the colour below the scale; empty for none.
    words
        The same for those who do not see it.
    """

    title: str
    gradient: str
    ticks: list[tuple[float, str]]
    under: str
    under_label: str
    words: str


def scale_key(scale: Scale) -> ScaleKey:
    """Return what a page shows of a scale."""
    colours = ", ".join(tokens()["orders"][scale.colours])
    ticks = _ticks(scale.low, scale.high)
    words = f"Colours of {scale.label}: from {scale.low:.3g} to {scale.high:.3g} {scale.unit}"
    return ScaleKey(
        scale.title, f"linear-gradient(to right, {colours})", ticks, scale.under,
        scale.under_label, words.rstrip(),
    )  # fmt: skip


def _ticks(low: float, high: float) -> list[tuple[float, str]]:
    """Return round numbers between two ends, and their places; the one end where both are equal."""
    extent = high - low
    if not extent > 0.0:
        return [(0.0, f"{low:.4g}")]
    power = 10.0 ** np.floor(np.log10(extent / _MOST))
    step = next(one * power for one in _STEPS if extent / (one * power) <= _MOST)
    numbers = step * np.arange(np.ceil(low / step - 1e-3), np.floor(high / step + 1e-3) + 1.0)
    decimals = max(0, int(np.ceil(-np.log10(step) + (step / power == 2.5))))  # noqa: PLR2004
    return [
        (round(100.0 * (one - low) / extent, 2), number(one, decimals)) for one in numbers.tolist()
    ]
