"""What a mesh is: tables for the core, and the names behind their rows."""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
Part = tuple[Integers, Floats]

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

    `messenger_spring` (without a messenger wire what holds the contact wire or its bridle) and
    `steady_arm` are rows of the springs and struts tables, None where the wires are anchored (both
    ends of the line) or the arm is no bar.
    """

    name: str
    x: float
    contact_node: int
    messenger_spring: int | None
    steady_arm: int | None


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

    `parts` maps a kind to (integers, floats), one row per part:

    ======== ========================================== =========================================
    kind     integer columns                            float columns
    ======== ========================================== =========================================
    wires    nodes of both ends, nodes that hold the    rest length m, EA N, EI N·m², kg/m, α, β,
             slopes there (another one at a hinge)      horizontal tension in the design N
    segments nodes of both ends                         rest length m, EA N, kg/m, α 1/s, β s,
                                                        horizontal tension in the design N
    bends    segment before and segment behind a node   EI N·m², β s
    links    upper node, lower node, tension only,      rest length m, N/m, N·s/m, α 1/s, β s, kg/m
             length to be found
    struts   node, anchor to be found                   direction (3), anchor (3) m, rest length m,
                                                        N/m, moving kg, hanging kg
    springs  node, component, mode (0 rest coordinate   N/m, N·s/m, rest coordinate m
             given, 1 position held, 2 unloaded)
    masses   node                                       kg, α 1/s
    fixed    node, component                            (none)
    ends     node, free in service                      force along the track N
    loads    node, component                            force N
    w_loads  (none)                                     force per metre of rest length (3) N/m
    turns    (none)                                     angle of the track along it, to the left rad
    ======== ========================================== =========================================

    A mesh has wires (wire model hermite), or segments and bends (lumped): then its slopes are zero
    and nothing reads them. `wire_loads` (w_loads above) and `turns` have a row for each, or none.
    `lanes` holds the rows, in the table of wires or segments, of the wires that a collector may run
    on: a list for each lane, in the order of the track; a lane is one wire or several one behind
    the other with gaps. `wire_rows` holds those of each wire by its field of the line. `ends` tells
    of each row of the table of that name which wire it belongs to.
    """

    dimension: int
    positions: Floats
    slopes: Floats
    parts: dict[str, Part]
    gravity: float
    lanes: list[list[int]]
    droppers: list[DropperPlace]
    supports: list[SupportPlace]
    wire_rows: dict[str, list[int]]
    systems: list[SystemNodes]
    ends: list[EndPlace] = field(default_factory=list)

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
