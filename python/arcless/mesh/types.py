"""What a mesh is: tables for the core, and the names behind their rows."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
Part = tuple[Integers, Floats]


@dataclass(frozen=True)
class DropperPlace:
    """A dropper: its name, its span (from 1), where it hangs (m), its row among the links."""

    name: str
    span: int
    x: float
    link: int


@dataclass(frozen=True)
class SupportPlace:
    """A support: its name, where it stands (m), and what holds the wires there.

    `messenger_spring` and `steady_arm` are rows of the springs and struts tables, None where the
    wires are anchored (both ends of the line) or the arm is no bar.
    """

    name: str
    x: float
    contact_node: int
    messenger_spring: int | None
    steady_arm: int | None


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
    ======== ========================================== =========================================

    A mesh has wires (wire model hermite), or segments and bends (lumped): then its slopes are zero
    and nothing reads them. `path` holds the rows of the contact wire in the table of wires or
    segments, from left to right.
    """

    dimension: int
    positions: Floats
    slopes: Floats
    parts: dict[str, Part]
    gravity: float
    path: list[int]
    contact_nodes: list[int]
    messenger_nodes: list[int]
    droppers: list[DropperPlace]
    supports: list[SupportPlace]
