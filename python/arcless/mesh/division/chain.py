"""The nodes of a wire, and the wires of a system."""

from bisect import bisect_left
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from arcless.mesh.division import wires
from arcless.mesh.division.masses_and_inserts import inserted
from arcless.mesh.division.wire_names import BRIDLE, MESSENGER, STITCH
from arcless.mesh.tables.mesh_types import Floats
from arcless.model.line.parts.components import TensionedWire
from arcless.model.line.parts.masses_and_inserts import Insert


@dataclass
class Chain:
    """Nodes of one wire: positions (n × 3) and their numbers in the mesh.

    Attributes
    ----------
    wire : what it is made of
    relieved : the same with the tension that stitch wires (bridles) leave it, between their clamps
    inserts : pieces that are made of something else
    hinges : rows of the nodes at which the wire turns freely
    leaving, arriving : rows of nodes whose slope is held by another node, for the element behind
        and for the one before, and that node's number
    """

    points: Floats
    wire: TensionedWire
    relieved: TensionedWire | None = None
    clamps: list[tuple[float, float]] = field(default_factory=list)
    inserts: list[Insert] = field(default_factory=list)
    hinges: list[int] = field(default_factory=list)
    nodes: list[int] = field(default_factory=list)
    leaving: dict[int, int] = field(default_factory=dict)
    arriving: dict[int, int] = field(default_factory=dict)

    def row(self, x: float) -> int:
        """Row of the node that stands at a station."""
        return bisect_left(self._along, x - wires.SAME_PLACE)

    @cached_property
    def _along(self) -> list[float]:
        along: list[float] = self.points[:, 0].tolist()
        return along

    def at(self, x: float) -> int:
        """Return the number of the node that stands at a station."""
        return self.nodes[self.row(x)]

    def sections(self) -> list[TensionedWire]:
        """Return the wire of each element, with its tension."""
        middles = 0.5 * (self.points[1:, 0] + self.points[:-1, 0])
        found = self._tensioned(middles)
        for insert in self.inserts:
            first, last = insert.ends
            for row in np.flatnonzero((first < middles) & (middles < last)):
                found[row] = inserted(found[row], insert)
        return found

    def _tensioned(self, middles: Floats) -> list[TensionedWire]:
        if self.relieved is None:
            return [self.wire] * len(middles)
        left, right = np.asarray(self.clamps).T
        which = np.clip(np.searchsorted(left, middles) - 1, 0, len(left) - 1)
        between = (left[which] < middles) & (middles < right[which])
        return [self.relieved if inside else self.wire for inside in between]


@dataclass
class Chains:
    """All wires of a system; contact wires side by side are several chains."""

    contacts: dict[str, Chain]
    messenger: Chain | None
    auxiliary: Chain | None
    stitches: list[Chain]
    bridles: list[Chain]

    def of(self, wire: str, x: float) -> Chain:
        """Return the chain of a wire; of stitch wires, the one at a place."""
        if wire in self.contacts:
            return self.contacts[wire]
        if wire in {STITCH, BRIDLE}:
            pieces = self.stitches if wire == STITCH else self.bridles
            return pieces[bisect_left(pieces, x, key=lambda piece: piece.points[0, 0]) - 1]
        chain = self.messenger if wire == MESSENGER else self.auxiliary
        assert chain is not None
        return chain

    def all(self) -> list[Chain]:
        """Return all chains."""
        return [
            *filter(None, (self.messenger, self.auxiliary)),
            *self.contacts.values(),
            *self.stitches,
            *self.bridles,
        ]
