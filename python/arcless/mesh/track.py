"""Curves of the track → loads across the wires, see `arcless.model.track`."""

import numpy as np

from arcless.mesh.kit import Kit
from arcless.mesh.types import Floats, Integers, Mesh
from arcless.model.line import Line

# Columns of rest length and design tension.
COLUMNS = {"wires": (0, 6), "segments": (0, 5)}


def add_curves(kit: Kit, positions: Floats) -> None:
    """Add the load that curves put on every wire or segment; nothing on a straight track."""
    if not kit.line.track.curves:
        return
    parts = kit.parts.arrays()
    kind = "segments" if kit.lumped else "wires"
    nodes, floats = parts[kind]
    length, tension = floats[:, COLUMNS[kind]].T
    for load in _across(_turns(kit.line, positions, nodes), tension, length):
        kit.parts.add("wire_loads", (), tuple(load.tolist()))


def curve_loads(mesh: Mesh, line: Line, tension: Floats | None = None) -> Floats:
    """Return the load of curves on each wire or segment (n × 3) in N/m of rest length.

    With the tension of each in N in place of that of the design.
    """
    kind = "wires" if len(mesh.parts["wires"][0]) else "segments"
    nodes, floats = mesh.parts[kind]
    if not line.track.curves:
        return np.zeros((len(nodes), 3))
    length, drawn = floats[:, COLUMNS[kind]].T
    turns = _turns(line, mesh.positions, nodes)
    return _across(turns, drawn if tension is None else tension, length)


def _turns(line: Line, positions: Floats, nodes: Integers) -> Floats:
    """Return by how much the pantograph's axis turns along each element, in rad to the left."""
    height = line.geometry.contact_wire_height
    ends = positions[nodes[:, :2], 0]
    places, which = np.unique(ends, return_inverse=True)
    angles = np.array([line.track.direction(float(x), height) for x in places])
    return np.diff(angles[which.reshape(ends.shape)], axis=1)[:, 0]


def _across(turn: Floats, tension: Floats, rest_length: Floats) -> Floats:
    """Return the load per metre of rest length (n × 3) in N/m: its sum over an element is T Δθ."""
    load = np.zeros((len(turn), 3))
    load[:, 1] = tension * turn / rest_length
    return load
