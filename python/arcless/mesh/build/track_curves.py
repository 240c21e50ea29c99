"""Curves of the track → by what it turns along every wire element.

See `arcless.model.line.parts.track`.

The core counts strains from the turned track, so the load T θ′ of a curve follows from the tension.
"""

import numpy as np

from arcless.mesh.tables.context import Kit
from arcless.mesh.tables.mesh_types import Floats


def add_curves(kit: Kit, positions: Floats) -> None:
    """Add the turn along every wire or segment in rad; nothing on a straight track."""
    if not kit.line.track.curves:
        return
    elements = kit.parts.arrays()["segments" if kit.lumped else "wires"]
    height = kit.line.geometry.contact_wire_height
    ends = positions[elements["nodes"], 0]
    places, which = np.unique(ends, return_inverse=True)
    angles = np.array([kit.line.track.direction(float(x), height) for x in places])
    turns = np.diff(angles[which.reshape(ends.shape)], axis=1)[:, 0]
    for turn in turns.tolist():
        kit.parts.add("turns", angle=turn)
