"""Mesh of a line: tables for the core, and the names behind their rows."""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from arcless.mesh.tables.columns import Table, Tables

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

PLANAR, SPATIAL = 2, 3


@dataclass(frozen=True)
class DropperPlace:
    """A dropper or hanger: its name, its span (from 1), where it hangs (m).

    `link` is its row among the links, `nodes` are its upper and its lower end, `wires` what these
    belong to.
    """

    name: str
    span: int
    x: float
    link: int
    nodes: tuple[int, int]
    wires: tuple[str, str]


@dataclass(frozen=True)
class SupportPlace:
    """A support of a contact wire: its name, where it stands (m), and what holds the wires there.

    `messenger_spring` (without a messenger wire what holds the contact wire or its bridle),
    `lateral_spring` at the same node and `steady_arm` are rows of the springs and struts tables,
    None where the wires are anchored (both ends of the line), the line is planar (the lateral one)
    or the arm is no bar.
    """

    name: str
    x: float
    contact_node: int
    messenger_spring: int | None
    steady_arm: int | None
    lateral_spring: int | None = None


@dataclass(frozen=True)
class StitchPlace:
    """A stitch wire or bridle: number of its support (from 1), nodes from clamp to clamp.

    `rows` are its elements in the table of wires or segments.
    """

    support: int
    nodes: list[int]
    rows: list[int]


@dataclass(frozen=True)
class EndPlace:
    """An end of a wire that something tensions: its row in the table of ends, and where it is.

    `wire` is the field of the line, `element` the row of the wire's last element (or segment), and
    `outward` the sign of the force along the track.
    """

    row: int
    wire: str
    node: int
    element: int
    outward: float


@dataclass(frozen=True)
class SystemNodes:
    """Nodes of the wires of one tension length, each wire from anchor to anchor.

    `label` is what names begin with where there are several, `contact` has one entry for each
    contact wire by its name, `stitches` and `bridles` one for each inner support. What a line does
    not have is empty.
    """

    label: str
    contact: dict[str, list[int]]
    messenger: list[int]
    auxiliary: list[int]
    stitches: list[StitchPlace]
    bridles: list[StitchPlace]


@dataclass(frozen=True)
class Mesh:
    """Arrays for the core. Nodes are ordered along the track; SI units.

    `parts` has a table for each kind of part, see `arcless.mesh.tables.columns`.

    A mesh has wires (wire model hermite), or segments and bends (lumped): then its slopes are zero
    and nothing reads them.
    `lanes` holds the rows, in the table of wires or segments, of the wires that a collector may run
    on: a list for each lane, in the order of the track; a lane is one wire or several one behind
    the other with gaps. `wire_rows` holds those of each wire by its field of the line. `ends` tells
    of each row of the table of that name which wire it belongs to.
    """

    dimension: int
    positions: Floats
    slopes: Floats
    parts: Tables
    gravity: float
    lanes: list[list[int]]
    droppers: list[DropperPlace]
    supports: list[SupportPlace]
    wire_rows: dict[str, list[int]]
    systems: list[SystemNodes]
    ends: list[EndPlace] = field(default_factory=list)

    @property
    def elements(self) -> Table:
        """Table of the elements of all wires: of cubic ones, or of the segments of chains."""
        return self.parts["wires"] if len(self.parts["wires"]) else self.parts["segments"]

    @property
    def contact_rows(self) -> list[int]:
        """Rows of all lanes in the table of wires or segments."""
        return [row for lane in self.lanes for row in lane]

    @property
    def contact_wires(self) -> list[list[int]]:
        """Nodes of each contact wire."""
        return [nodes for system in self.systems for nodes in system.contact.values()]

    @property
    def contact_nodes(self) -> list[int]:
        """Nodes of all contact wires, one after the other."""
        return [node for wire in self.contact_wires for node in wire]

    @property
    def messenger_nodes(self) -> list[int]:
        """Nodes of all messenger wires, one after the other."""
        return [node for system in self.systems for node in system.messenger]

    @property
    def auxiliary_nodes(self) -> list[int]:
        """Nodes of all auxiliary wires, one after the other."""
        return [node for system in self.systems for node in system.auxiliary]

    @property
    def bridles(self) -> list[StitchPlace]:
        """The bridles of all tension lengths."""
        return [bridle for system in self.systems for bridle in system.bridles]

    @property
    def stitches(self) -> list[StitchPlace]:
        """The stitch wires of all tension lengths."""
        return [stitch for system in self.systems for stitch in system.stitches]
