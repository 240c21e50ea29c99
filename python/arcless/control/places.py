"""Places along a line counted in spans: 3.25 is a quarter of a span behind the fourth support."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from arcless.errors import ModelError
from arcless.model import Scenario

Floats = NDArray[np.float64]


class Spans:
    """Spans of a line, over which places are counted.

    Parameters
    ----------
    supports_m
        Positions of the supports in m, ascending.
    """

    def __init__(self, supports_m: Sequence[float]) -> None:
        self._supports = np.array(supports_m, dtype=np.float64)
        self._numbers = np.arange(len(self._supports), dtype=np.float64)

    def count_at(self, place_m: float) -> float:
        """Return a place in m counted in spans."""
        return float(np.interp(place_m, self._supports, self._numbers))

    def place_at(self, count: float) -> float:
        """Return the place in m at a count of spans."""
        return float(np.interp(count, self._numbers, self._supports))

    def within(self, places_m: Floats) -> Floats:
        """Return places in m as the part of their span that is behind them, from 0 to 1."""
        counted = np.interp(places_m, self._supports, self._numbers)
        return np.asarray(counted - np.floor(counted))


def starts(
    scenario: Scenario,
    spans: Spans,
    lengths: tuple[float, float],
    stretch_m: tuple[float, float] | None,
    margin_m: float,
) -> tuple[float, float]:
    """Return first and last place where episodes may begin, counted in spans.

    Parameters
    ----------
    scenario, spans
        The scenario, and the spans of its line.
    lengths
        Spans before the part that is scored, and of that part.
    stretch_m
        Part of the line that is scored, from and to in m; the whole travel without.
    margin_m
        Way in m that is kept from the end, for an episode that is a part of a sample too long.

    Raises
    ------
    ModelError
        There is no room for an episode.
    """
    lead_in, scored = lengths
    first, last = scenario.travel_range()
    low = spans.count_at(first)
    high = spans.count_at(last - margin_m) - lead_in - scored
    if stretch_m is not None:
        begin, end = stretch_m
        low = max(low, spans.count_at(begin) - lead_in)
        high = min(high, spans.count_at(end - margin_m) - lead_in - scored)
    if high < low:
        got = f"{first:g} to {last:g} m"
        got += "" if stretch_m is None else f", of which {stretch_m[0]:g} to {stretch_m[1]:g} m"
        raise ModelError(
            "no room for an episode",
            where="spans" if stretch_m is None else "stretch_m",
            got=got,
            expected=f"room for {lead_in:g} spans before the scored part, and {scored:g} of it",
            hint="fewer spans or lead_in_spans, or a longer travel or stretch_m",
        )
    return low, high
