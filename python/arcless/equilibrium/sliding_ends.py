"""Tensioning devices with friction: holding still, or moved since the installation.

A device of the efficiency η that was set to the tension T₀ holds the end of its wire as long as

    η T₀ ≤ T ≤ T₀/η

and else lets it move at the bound that is reached: outwards at the lower one (the wire has grown
longer and the weight has sunk), inwards at the upper one. T is horizontal, as the force of the
device. That is Coulomb's law for one change since the installation, in one direction; what came and
went between is not known.
"""

from typing import Any

import numpy as np

from arcless.errors import NotConvergedError
from arcless.mesh import EndPlace, Mesh
from arcless.model import Line

# Rounding of a tension, as a share: a device at its bound neither begins nor ends to slide by it.
ROUNDING = 1e-9
# A way of an end that is rounding, in m.
STANDSTILL = 1e-9


class SlidingEnds:
    """The devices with friction of a line, each of which holds still or slides at a tension."""

    def __init__(self, mesh: Mesh, line: Line) -> None:
        self._mesh, self._line = mesh, line
        self._ends = [end for end in mesh.ends if getattr(line, end.wire).has_friction]
        self.tensions: dict[int, float] = {}

    @property
    def are_there(self) -> bool:
        """True when a device has friction."""
        return bool(self._ends)

    def renew(self, arrays: dict[str, Any]) -> bool:
        """Decide again after an equilibrium; return True when another one is to be found."""
        points = arrays["positions"].reshape(-1, self._mesh.dimension)
        before = dict(self.tensions)
        for end in self._ends:
            bounds = getattr(self._line, end.wire).end_band
            if end.row in self.tensions:
                self._stop(end, points, bounds)
            else:
                self._start(end, points, float(arrays["wire_tension"][end.element]), bounds)
        return self.tensions != before

    def _start(self, end: EndPlace, points: Any, along: float, bounds: tuple[float, float]) -> None:
        """Let a device slide whose wire pulls outside of its band."""
        first, last = self._mesh.elements["nodes"][end.element]
        chord = points[last] - points[first]
        pull = along * float(chord[0] / np.linalg.norm(chord))
        low, high = bounds
        if pull < low * (1.0 - ROUNDING):
            self.tensions[end.row] = low
        elif pull > high * (1.0 + ROUNDING):
            self.tensions[end.row] = high

    def _stop(self, end: EndPlace, points: Any, bounds: tuple[float, float]) -> None:
        """Let a device hold that would slide against its own friction."""
        way = end.outward * float(points[end.node, 0] - self._mesh.positions[end.node, 0])
        against = -way if self.tensions[end.row] == bounds[0] else way
        if against > STANDSTILL:
            del self.tensions[end.row]


def undecided(rounds: int) -> NotConvergedError:
    """Return the error of devices that start and stop again and again."""
    return NotConvergedError(
        "tensioning devices with friction start and stop without end",
        got=f"{rounds} rounds",
        expected="a state in which each holds still or slides",
        hint="leave end_efficiency out, and friction is left out; please report the line",
    )
