"""Tables of parts: rows, collected wire by wire or one by one, become the arrays of the core."""

from collections.abc import Callable, Mapping, Sequence
from math import cos, sin
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from arcless.mesh.tables.columns import COLUMNS, Table, Tables
from arcless.mesh.tables.mesh_types import Floats, Integers
from arcless.model.line.parts.components import DropperType, SteadyArmBar, TensionedWire


def each_of(
    sections: Sequence[TensionedWire], of: Callable[[TensionedWire], Mapping[str, float]]
) -> dict[str, Floats]:
    """Return numbers of the wire of each element by name; most elements share one wire."""
    keys = list(map(id, sections))
    kinds = dict(zip(keys, sections, strict=True))
    which = {key: number for number, key in enumerate(kinds)}
    rows = np.fromiter(map(which.__getitem__, keys), np.intp, len(keys))
    numbers = [of(section) for section in kinds.values()]
    return {name: np.array([one[name] for one in numbers])[rows] for name in numbers[0]}


def _chain_numbers(wire: TensionedWire) -> dict[str, float]:
    return {
        "axial_stiffness": wire.axial_stiffness,
        "mass": wire.mass,
        "alpha": wire.damping.alpha,
        "beta": wire.damping.beta,
        "design_tension": wire.tension,
    }


def _cubic_numbers(wire: TensionedWire) -> dict[str, float]:
    return {**_chain_numbers(wire), "bending_stiffness": wire.bending_stiffness}


def _bending_numbers(wire: TensionedWire) -> dict[str, float]:
    return {"bending_stiffness": wire.bending_stiffness, "beta": wire.damping.beta}


class Parts:
    """Collects the parts of a structure."""

    def __init__(self) -> None:
        self._rows: dict[str, list[Mapping[str, Any]]] = {kind: [] for kind in COLUMNS}
        # Of kinds that come by the thousand, wire by wire.
        self._blocks: dict[str, list[Mapping[str, NDArray[Any]]]] = {}

    def add(self, kind: str, **columns: Any) -> int:
        """Add a row, all of its columns by name, and return its number."""
        _check(kind, columns)
        self._rows[kind].append(columns)
        return len(self._rows[kind]) - 1

    def arrays(self) -> Tables:
        """Return the tables."""
        return cast("Tables", {kind: self._table(kind) for kind in COLUMNS})

    def _table(self, kind: str) -> Table:
        names, rows = COLUMNS[kind].names or (), self._rows[kind]
        if blocks := self._blocks.get(kind):
            # Column by column: NumPy is slow to put tables behind one another.
            columns = {name: np.concatenate([block[name] for block in blocks]) for name in names}
            return _filled(kind, len(columns[names[0]]), columns)
        return _filled(kind, len(rows), {name: [row[name] for row in rows] for name in names})

    def _add_block(self, kind: str, **columns: NDArray[Any]) -> list[int]:
        """Add many rows and return their numbers."""
        _check(kind, columns)
        blocks, (own, *_) = self._blocks.setdefault(kind, []), columns
        first = sum(len(block[own]) for block in blocks)
        blocks.append(columns)
        return list(range(first, first + len(columns[own])))

    def add_wires(
        self,
        sections: Sequence[TensionedWire],
        nodes: Integers,
        slope_nodes: Integers,
        rest_lengths: Floats,
    ) -> list[int]:
        """Add the cubic elements of a piece of wire; nodes are (n × 2). Returns their rows."""
        ends = {"nodes": nodes, "slope_nodes": slope_nodes, "rest_length": rest_lengths}
        return self._add_block("wires", **ends, **each_of(sections, _cubic_numbers))

    def add_segments(
        self, sections: Sequence[TensionedWire], nodes: Integers, rest_lengths: Floats
    ) -> list[int]:
        """Add the links of a chain of point masses; nodes are (n × 2). Returns their rows."""
        ends = {"nodes": nodes, "rest_length": rest_lengths}
        return self._add_block("segments", **ends, **each_of(sections, _chain_numbers))

    def add_bends(
        self, sections: Sequence[TensionedWire], rows: Sequence[int], hinges: Sequence[int]
    ) -> None:
        """Let a chain of segments resist bending at its inner nodes, except at the hinges.

        Half of the flexibility lies in either segment; where one of both has no stiffness there is
        none.
        """
        numbers = each_of(sections, _bending_numbers)
        stiff, damping = numbers["bending_stiffness"], numbers["beta"]
        one, other = stiff[:-1], stiff[1:]
        bends = np.minimum(one, other) > 0.0
        bends[[node - 1 for node in hinges if 0 < node <= len(bends)]] = False
        one, other, damping = one[bends], other[bends], damping[:-1][bends]
        both = np.where(one == other, one, 2.0 / (1.0 / one + 1.0 / other))
        pairs = np.column_stack([rows[:-1], rows[1:]])[bends]
        self._add_block("bends", segments=pairs, bending_stiffness=both, beta=damping)

    def add_dropper(
        self, kind: DropperType, upper: int, lower: int, distance: float, length: float | None
    ) -> int:
        """Add a dropper; without a length it is found by the design calculation."""
        return self.add(
            "links",
            nodes=(upper, lower),
            rest_length=distance if length is None else length,
            stiffness=kind.stiffness,
            viscosity=kind.damping,
            alpha=kind.rayleigh.alpha,
            beta=kind.rayleigh.beta,
            mass=kind.mass,
            unilateral=kind.slackens,
            adjust=length is None,
        )

    def add_mass(self, node: int, mass: float, alpha: float = 0.0) -> None:
        """Add a point mass in kg, with its α in 1/s, if there is any."""
        if mass > 0.0:
            self.add("masses", node=node, mass=mass, alpha=alpha)

    def add_spring(
        self,
        node: int,
        component: int,
        mode: int,
        *,
        stiffness: float,
        viscosity: float = 0.0,
        rest: float = 0.0,
    ) -> int:
        """Add a spring to the ground and return its row; see `COLUMNS`."""
        return self.add(
            "springs",
            node=node,
            component=component,
            mode=mode,
            stiffness=stiffness,
            viscosity=viscosity,
            rest=rest,
        )

    def fix(self, node: int, *components: int) -> None:
        """Let a node not move along the given components."""
        for component in components:
            self.add("fixed", node=node, component=component)

    def add_steady_arm(self, arm: SteadyArmBar, node: int, side: float) -> int:
        """Add a hinged steady arm whose hinge is on the given side (±1 across the track).

        A bar hinged at the ground moves like a third of its mass at the clamp, and half of its
        weight hangs there.
        """
        bar_mass = arm.mass * arm.length
        return self.add(
            "struts",
            node=node,
            direction=(0.0, side * cos(arm.slope), sin(arm.slope)),
            anchor=(0.0, 0.0, 0.0),
            rest_length=arm.length,
            stiffness=arm.axial_stiffness / arm.length,
            moving_mass=bar_mass / 3.0,
            hanging_mass=bar_mass / 2.0,
            adjust=True,
        )


def _check(kind: str, columns: Mapping[str, Any]) -> None:
    expected = COLUMNS[kind].names or ()
    if columns.keys() != set(expected):
        raise TypeError(f"{kind}: columns {', '.join(columns)}, expected {', '.join(expected)}")


def _filled(kind: str, count: int, columns: Mapping[str, Any]) -> Table:
    """Return a table of so many rows with the given columns."""
    table = np.zeros(count, COLUMNS[kind])
    for name, values in columns.items() if count else ():
        table[name] = values
    return table
