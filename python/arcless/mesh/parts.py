"""Tables of parts: rows are collected one by one and become the arrays of the core."""

from collections.abc import Sequence
from math import cos, sin

import numpy as np

from arcless.mesh.types import Floats, Integers, Part
from arcless.model.components import DropperType, SteadyArmBar, TensionedWire

# Number of integer and float columns of each kind, as documented in `arcless.mesh.types.Mesh`.
COLUMNS = {
    "wires": (4, 7),
    "segments": (2, 6),
    "bends": (2, 2),
    "links": (4, 6),
    "struts": (2, 10),
    "springs": (3, 3),
    "masses": (1, 2),
    "fixed": (2, 0),
    "ends": (2, 1),
    "loads": (2, 1),
    "wire_loads": (0, 3),
}

GIVEN, HELD, UNLOADED = 0, 1, 2


class Parts:
    """Collects the parts of a structure."""

    def __init__(self) -> None:
        self._rows: dict[str, list[tuple[tuple[int, ...], tuple[float, ...]]]] = {
            kind: [] for kind in COLUMNS
        }
        self._wires: list[Part] = []
        self._wire_count = 0

    def add(self, kind: str, integers: tuple[int, ...], floats: tuple[float, ...] = ()) -> int:
        """Add a row and return its number."""
        self._rows[kind].append((integers, floats))
        return len(self._rows[kind]) - 1

    def arrays(self) -> dict[str, Part]:
        """Return the tables."""
        tables = {}
        for kind, (integers, floats) in COLUMNS.items():
            rows = self._rows[kind]
            tables[kind] = (
                np.array([row[0] for row in rows], dtype=np.int64).reshape(len(rows), integers),
                np.array([row[1] for row in rows], dtype=np.float64).reshape(len(rows), floats),
            )
        if self._wires:
            numbers, values = zip(*self._wires, strict=True)
            tables["wires"] = np.concatenate(numbers), np.concatenate(values)
        return tables

    def add_wires(
        self,
        sections: Sequence[TensionedWire],
        nodes: Integers,
        slope_nodes: Integers,
        rest_lengths: Floats,
    ) -> list[int]:
        """Add the cubic elements of a piece of wire; nodes are (n × 2). Returns their rows."""
        kinds = {id(section): section for section in sections}
        own = {
            key: (
                *(wire.axial_stiffness, wire.bending_stiffness, wire.mass),
                *(wire.damping.alpha, wire.damping.beta, wire.tension),
            )
            for key, wire in kinds.items()
        }
        values = np.array([own[id(section)] for section in sections])
        table = np.column_stack([rest_lengths, values])
        self._wires.append((np.column_stack([nodes, slope_nodes]), table))
        first, self._wire_count = self._wire_count, self._wire_count + len(sections)
        return list(range(first, self._wire_count))

    def add_segment(self, wire: TensionedWire, nodes: tuple[int, int], rest_length: float) -> int:
        """Add a straight link of a chain of point masses."""
        damping = (wire.damping.alpha, wire.damping.beta)
        floats = (rest_length, wire.axial_stiffness, wire.mass, *damping, wire.tension)
        return self.add("segments", nodes, floats)

    def add_bend(self, one: TensionedWire, other: TensionedWire, before: int, behind: int) -> None:
        """Let a wire resist bending between two segments, if both do.

        Half of the flexibility lies in either segment.
        """
        stiff, soft = one.bending_stiffness, other.bending_stiffness
        if min(stiff, soft) > 0.0:
            both = stiff if stiff == soft else 2.0 / (1.0 / stiff + 1.0 / soft)
            self.add("bends", (before, behind), (both, one.damping.beta))

    def add_dropper(
        self, kind: DropperType, upper: int, lower: int, distance: float, length: float | None
    ) -> int:
        """Add a dropper; without a length it is found by the design calculation."""
        integers = (upper, lower, int(kind.slackens), int(length is None))
        rest = distance if length is None else length
        damping = (kind.damping, kind.rayleigh.alpha, kind.rayleigh.beta)
        return self.add("links", integers, (rest, kind.stiffness, *damping, kind.mass))

    def add_mass(self, node: int, mass: float, alpha: float) -> None:
        """Add a point mass, if there is any."""
        if mass > 0.0:
            self.add("masses", (node,), (mass, alpha))

    def add_steady_arm(self, arm: SteadyArmBar, node: int, side: float) -> int:
        """Add a hinged steady arm whose hinge is on the given side (±1 across the track).

        A bar hinged at the ground moves like a third of its mass at the clamp, and half of its
        weight hangs there.
        """
        bar_mass = arm.mass * arm.length
        direction = (0.0, side * cos(arm.slope), sin(arm.slope))
        elastic = (arm.length, arm.axial_stiffness / arm.length)
        masses = (bar_mass / 3.0, bar_mass / 2.0)
        return self.add("struts", (node, 1), (*direction, 0.0, 0.0, 0.0, *elastic, *masses))
