"""Figures that are asked for piece by piece, with the pyramids of their curves."""

from collections.abc import Mapping, Sequence
from threading import RLock
from typing import Any

from numpy.typing import NDArray

from arcless.errors import ModelError
from arcless.figures.description import Figure
from arcless.studio.charts.plain.pyramid import Pyramid
from arcless.units import show


class Charted:
    """Something with figures; threads may ask at the same time."""

    def __init__(self) -> None:
        self.lock = RLock()
        self._pyramids: dict[int, tuple[NDArray[Any], Pyramid]] = {}

    @property
    def figures(self) -> Mapping[str, Sequence[Figure]]:
        """Figures by their keys; made at the first question."""
        raise NotImplementedError

    def figure(self, key: str) -> Figure:
        """Return a figure by its own key, such as ``force-1``.

        Raises
        ------
        ModelError
            There is none.
        """
        with self.lock:
            every = [one for group in self.figures.values() for one in group]
        for one in every:
            if one.key == key:
                return one
        expected = f"one of {', '.join(one.key for one in every)}"
        raise ModelError("no such figure", got=show(key), expected=expected)

    def pyramid(self, values: NDArray[Any]) -> Pyramid:
        """Return the pyramid of an array of this thing, built at the first question."""
        with self.lock:
            known = self._pyramids.get(id(values))
            if known is None:
                # The array is kept with it, so that no other one has the same identity.
                known = self._pyramids[id(values)] = values, Pyramid.of(values)
            return known[1]

    @property
    def pyramid_bytes(self) -> int:
        """Memory of the pyramids in bytes."""
        return sum(pyramid.bytes for _, pyramid in list(self._pyramids.values()))
