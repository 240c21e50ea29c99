"""The contact wire of a line in Exudyn at rest: which cable is above a place, how far it yields."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import exudyn as exu
import exudyn.itemInterface as items  # noqa: N813
import numpy as np

from tests.support.exudyn_line import Coordinates, Line, settings

# Up and down, so that even terms cancel: 20 N and 5 N give the same elasticity to 6e-6. In N.
PROBE = 10.0


@dataclass
class ContactWire:
    """The contact wire at rest: ends of its cables (place, slope), their lengths in m."""

    left: Any
    right: Any
    length: Any

    @classmethod
    def of(cls, line: Line, rest: Coordinates) -> "ContactWire":
        """Read it from a line that has settled."""
        mesh = line.built.mesh
        rows = mesh.wire_rows["contact_wire"]
        wires = mesh.parts["wires"][rows]
        ends = [(*a.tolist(), *b.tolist()) for a, b in wires[["nodes", "slope_nodes"]]]
        left = np.array([rest[a, slope] for a, _, slope, _ in ends])
        right = np.array([rest[b, slope] for _, b, _, slope in ends])
        return cls(left, right, line.built.wire_length[rows])

    def locate(self, x: float) -> tuple[int, float]:
        """Cable above x and its own coordinate there; it is straight to 1e-5 of its length."""
        row = int(np.searchsorted(self.left[:, 0], x, side="right")) - 1
        row = min(max(row, 0), len(self.length) - 1)
        share = (x - self.left[row, 0]) / (self.right[row, 0] - self.left[row, 0])
        return row, float(share * self.length[row])

    def height(self, x: float, up: int) -> float:
        """Height at x, m: of the chord of a cable, which sags by less than 0.2 mm of 1.5 m."""
        row, place = self.locate(x)
        share = place / self.length[row]
        return float((1.0 - share) * self.left[row, up] + share * self.right[row, up])


def elasticity(line: Line, rest: Coordinates, places: Sequence[float]) -> Any:
    """Return how far a wire that has settled rises by 1 N at each place, m/N: up less down."""
    wire, loads, points = ContactWire.of(line, rest), [], []
    kind = exu.OutputVariableType.Position
    for x in places:
        row, place = wire.locate(x)
        points.append((line.cables["contact_wire"][row], [place, 0.0, 0.0]))
        cable, local = points[-1]
        marker = items.MarkerBodyPosition(bodyNumber=cable, localPosition=local)
        load = items.LoadForceVector(markerNumber=line.system.AddMarker(marker))
        loads.append(line.system.AddLoad(load))
    line.system.Assemble()
    found = []
    for load, (cable, local) in zip(loads, points, strict=True):
        heights = []
        for force in (PROBE, -PROBE):
            line.system.SetLoadParameter(load, "loadVector", line.upward(force))
            line.system.SolveStatic(settings())
            here = line.system.GetObjectOutputBody(cable, kind, localPosition=local)
            heights.append(here[line.up])
        line.system.SetLoadParameter(load, "loadVector", line.upward(0.0))
        found.append((heights[0] - heights[1]) / (2.0 * PROBE))
    return np.array(found)
