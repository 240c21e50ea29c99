"""The geometry of a line at rest, from its equilibrium."""

from collections.abc import Iterator

import numpy as np

from arcless.equilibrium.equilibrium import Equilibrium
from arcless.mesh import PLANAR, Mesh
from arcless.model import Line
from arcless.studio.at_rest.plain_geometry import (
    ArmData,
    DropperData,
    Floats,
    Geometry,
    SupportData,
    Wires,
    rounded,
    spans_between,
)

ACROSS = 1
# Where a node is: number of its wire, and its place in it.
Places = dict[int, tuple[int, int]]


def geometry_at_rest(found: Equilibrium, line: Line) -> Geometry:
    """Return the geometry of a line at rest.

    Parameters
    ----------
    found
        The line at rest.
    line
        The line that it is of.
    """
    wires, places = _wires(found)
    return {
        "name": line.name,
        "spatial": found.mesh.dimension != PLANAR,
        "height_m": line.geometry.contact_wire_height,
        "spans": spans_between(found.support_places()),
        "wires": wires.plain,
        "droppers": list(_droppers(found, places)),
        "supports": list(_supports(found, places)),
    }


def nodes_of(mesh: Mesh) -> Iterator[tuple[str, list[list[int]], list[int] | None]]:
    """Yield kind, nodes of each wire, and the supports of those that belong to one."""
    yield "contact", mesh.contact_wires, None
    yield "messenger", [system.messenger for system in mesh.systems], None
    yield "auxiliary", [system.auxiliary for system in mesh.systems], None
    for kind, clamped in (("stitch", mesh.stitches), ("bridle", mesh.bridles)):
        yield kind, [one.nodes for one in clamped], [one.support for one in clamped]


def _wires(found: Equilibrium) -> tuple[Wires, Places]:
    wires, places = Wires(), Places()
    for kind, pieces, at in nodes_of(found.mesh):
        for number, nodes in enumerate(filter(None, pieces), start=len(wires.plain)):
            for place, node in enumerate(nodes):
                # Clamps of stitch wires are nodes of the messenger wire, which came before.
                places.setdefault(node, (number, place))
        wires.add(kind, [found.positions[nodes] for nodes in pieces], at)
    return wires, places


def _droppers(found: Equilibrium, places: Places) -> Iterator[DropperData]:
    mesh = found.mesh
    ends = np.array([dropper.nodes for dropper in mesh.droppers], dtype=int).reshape(-1, 2)
    tops, bottoms = (rounded(found.positions[ends[:, end]]) for end in (0, 1))
    lengths, forces = (found.of_droppers(name) for name in ("link_length", "link_tension"))
    rows = zip(mesh.droppers, tops, bottoms, lengths.tolist(), forces.tolist(), strict=True)
    for dropper, top, bottom, length, force in rows:
        (top_wire, top_node), (wire, node) = (places[end] for end in dropper.nodes)
        yield {
            "name": dropper.name, "span": dropper.span, "x_m": dropper.x,
            "top": top, "bottom": bottom, "length_m": length, "force_N": force,
            "wire": wire, "node": node, "top_wire": top_wire, "top_node": top_node,
        }  # fmt: skip


def _supports(found: Equilibrium, places: Places) -> Iterator[SupportData]:
    hinges, points = _hinges(found), found.positions
    for support in found.mesh.supports:
        wire, node = places[support.contact_node]
        point = points[support.contact_node]
        arms: list[ArmData] = []
        if support.steady_arm is not None:
            arms = [{"from": rounded(point), "to": rounded(hinges[support.steady_arm])}]
        yield {
            "name": support.name, "x_m": support.x, "stagger_m": float(point[ACROSS]),
            "wire": wire, "node": node, "arms": arms,
        }  # fmt: skip


def _hinges(found: Equilibrium) -> Floats:
    """Return the points (n × 3) in m at which steady arms are hinged."""
    anchors = found.arrays["strut_anchor"].reshape(-1, found.mesh.dimension)
    if found.mesh.dimension != PLANAR:
        return anchors
    return np.column_stack([anchors[:, 0], np.zeros(len(anchors)), anchors[:, 1]])
