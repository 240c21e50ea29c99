"""Tables of parts that the core takes: one structured array for each kind, one row for each part.

The core reads every column by its name, and refuses a table that lacks one or has other numbers in
it. Units are SI; α in 1/s and β in s are those of Rayleigh damping.
"""

from typing import Any, TypeAlias, TypedDict

import numpy as np
from numpy.typing import NDArray

Table: TypeAlias = NDArray[Any]

# Rest of a spring: at the coordinate given, where its node is held in the design, or unloaded.
GIVEN, HELD, UNLOADED = 0, 1, 2


class Tables(TypedDict):
    """The tables of a structure by kind; their columns are in `COLUMNS`."""

    wires: Table
    segments: Table
    bends: Table
    links: Table
    struts: Table
    springs: Table
    masses: Table
    fixed: Table
    ends: Table
    loads: Table
    wire_loads: Table
    turns: Table


_NUMBER, _INDEX, _FLAG = np.float64, np.int64, np.bool_


def _table(*columns: Any) -> np.dtype[Any]:
    return np.dtype(list(columns), align=True)


# Kind → columns of its table.
COLUMNS: dict[str, np.dtype[Any]] = {
    # Cubic elements. The nodes that hold the slopes at both ends are other ones at a hinge.
    "wires": _table(
        ("nodes", _INDEX, (2,)),
        ("slope_nodes", _INDEX, (2,)),
        ("rest_length", _NUMBER),  # m
        ("axial_stiffness", _NUMBER),  # EA, N
        ("bending_stiffness", _NUMBER),  # EI, N·m²
        ("mass", _NUMBER),  # kg/m
        ("alpha", _NUMBER),
        ("beta", _NUMBER),
        ("design_tension", _NUMBER),  # horizontal, N
    ),
    # Pieces of a chain of point masses.
    "segments": _table(
        ("nodes", _INDEX, (2,)),
        ("rest_length", _NUMBER),  # m
        ("axial_stiffness", _NUMBER),  # EA, N
        ("mass", _NUMBER),  # kg/m
        ("alpha", _NUMBER),
        ("beta", _NUMBER),
        ("design_tension", _NUMBER),  # horizontal, N
    ),
    # Bending at a node between the segment before and the one behind it.
    "bends": _table(
        ("segments", _INDEX, (2,)),
        ("bending_stiffness", _NUMBER),  # EI, N·m²
        ("beta", _NUMBER),
    ),
    # Droppers and hangers, from the upper node to the lower one. Other rows may stand among them:
    # droppers are found by `DropperPlace.link`, never by the order of rows.
    "links": _table(
        ("nodes", _INDEX, (2,)),
        ("rest_length", _NUMBER),  # m; a first guess where it is adjusted
        ("stiffness", _NUMBER),  # N/m
        ("viscosity", _NUMBER),  # N·s/m
        ("alpha", _NUMBER),
        ("beta", _NUMBER),
        ("mass", _NUMBER),  # kg/m
        ("unilateral", _FLAG),  # carries tension only
        ("adjust", _FLAG),  # the design finds its length
    ),
    # Steady arms: hinged bars from a node to the ground.
    "struts": _table(
        ("node", _INDEX),
        ("direction", _NUMBER, (3,)),  # from the node to the ground, of length 1
        ("anchor", _NUMBER, (3,)),  # m
        ("rest_length", _NUMBER),  # m
        ("stiffness", _NUMBER),  # N/m
        ("moving_mass", _NUMBER),  # kg
        ("hanging_mass", _NUMBER),  # kg
        ("adjust", _FLAG),  # the design finds its anchor
    ),
    # Springs to the ground along one component.
    "springs": _table(
        ("node", _INDEX),
        ("component", _INDEX),
        ("mode", _INDEX),  # GIVEN, HELD or UNLOADED
        ("stiffness", _NUMBER),  # N/m
        ("viscosity", _NUMBER),  # N·s/m
        ("rest", _NUMBER),  # coordinate where it is given, m
    ),
    "masses": _table(
        ("node", _INDEX),
        ("mass", _NUMBER),  # kg
        ("alpha", _NUMBER),
    ),
    "fixed": _table(
        ("node", _INDEX),
        ("component", _INDEX),
    ),
    # Ends of wires that something tensions.
    "ends": _table(
        ("node", _INDEX),
        ("force", _NUMBER),  # along the track, N
        ("released", _FLAG),  # free in service under the force
    ),
    "loads": _table(
        ("node", _INDEX),
        ("component", _INDEX),
        ("force", _NUMBER),  # N
    ),
    # Of each wire or segment in this order, or none.
    "wire_loads": _table(
        ("force", _NUMBER, (3,)),  # per metre of rest length, N/m
    ),
    # Of each wire or segment in this order, or none.
    "turns": _table(
        ("angle", _NUMBER),  # of the track along it, to the left, rad
    ),
}
