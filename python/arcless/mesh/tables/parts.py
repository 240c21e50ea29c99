"""Tables of parts: rows, collected wire by wire or one by one, become the arrays of the core."""

from collections.abc import Callable, Sequence
from math import cos, sin

import numpy as np

from arcless.mesh.tables.mesh_types import Floats, Integers, Part
from arcless.model.line.parts.components import DropperType, SteadyArmBar, TensionedWire

# Number of integer and float columns of each kind, see `arcless.mesh.tables.mesh_types.Mesh`.
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
    "turns": (0, 1),
}

GIVEN, HELD, UNLOADED = 0, 1, 2


def each_of(
    sections: Sequence[TensionedWire], of: Callable[[TensionedWire], tuple[float, ...]]
) -> Floats:
    """Return numbers of the wire of each element, row by row; most elements share one."""
    kinds = {id(section): section for section in sections}
    which = {key: number for number, key in enumerate(kinds)}
    table = np.array([of(section) for section in kinds.values()])
    return table[[which[id(section)] for section in sections]]


class Parts:
    """Collects the parts of a structure."""

    def __init__(self) -> None:
        self._rows: dict[str, list[tuple[tuple[int, ...], tuple[float, ...]]]] = {
            kind: [] for kind in COLUMNS
        }
        # Of kinds that come by the thousand, wire by wire.
        self._blocks: dict[str, list[Part]] = {"wires": [], "segments": [], "bends": []}

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
        for kind, blocks in self._blocks.items():
            if blocks:
                numbers, values = zip(*blocks, strict=True)
                tables[kind] = np.concatenate(numbers), np.concatenate(values)
        return tables

    def _add_block(self, kind: str, integers: Integers, floats: Floats) -> list[int]:
        """Add many rows and return their numbers."""
        blocks = self._blocks[kind]
        first = sum(len(numbers) for numbers, _ in blocks)
        blocks.append((integers, floats))
        return list(range(first, first + len(integers)))

    def add_wires(
        self,
        sections: Sequence[TensionedWire],
        nodes: Integers,
        slope_nodes: Integers,
        rest_lengths: Floats,
    ) -> list[int]:
        """Add the cubic elements of a piece of wire; nodes are (n × 2). Returns their rows."""
        values = each_of(sections, lambda wire: (
            wire.axial_stiffness, wire.bending_stiffness, wire.mass,
            wire.damping.alpha, wire.damping.beta, wire.tension,
        ))  # fmt: skip
        table = np.column_stack([rest_lengths, values])
        return self._add_block("wires", np.column_stack([nodes, slope_nodes]), table)

    def add_segments(
        self, sections: Sequence[TensionedWire], nodes: Integers, rest_lengths: Floats
    ) -> list[int]:
        """Add the links of a chain of point masses; nodes are (n × 2). Returns their rows."""
        values = each_of(sections, lambda wire: (
            wire.axial_stiffness, wire.mass,
            wire.damping.alpha, wire.damping.beta, wire.tension,
        ))  # fmt: skip
        return self._add_block("segments", nodes, np.column_stack([rest_lengths, values]))

    def add_bends(
        self, sections: Sequence[TensionedWire], rows: Sequence[int], hinges: Sequence[int]
    ) -> None:
        """Let a chain of segments resist bending at its inner nodes, but for the hinges.

        Half of the flexibility lies in either segment; where one of both has no stiffness there is
        none.
        """
        stiff, damping = each_of(sections, lambda w: (w.bending_stiffness, w.damping.beta)).T
        one, other = stiff[:-1], stiff[1:]
        bends = np.minimum(one, other) > 0.0
        bends[[node - 1 for node in hinges if 0 < node <= len(bends)]] = False
        one, other, damping = one[bends], other[bends], damping[:-1][bends]
        both = np.where(one == other, one, 2.0 / (1.0 / one + 1.0 / other))
        pairs = np.column_stack([rows[:-1], rows[1:]])[bends]
        self._add_block("bends", pairs, np.column_stack([both, damping]))

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
