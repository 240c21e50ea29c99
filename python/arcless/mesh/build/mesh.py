"""Line and solver settings → mesh."""

from collections.abc import Mapping

import numpy as np

from arcless.errors import MeshError
from arcless.mesh.build.supports import Holding
from arcless.mesh.build.track_curves import add_curves
from arcless.mesh.build.wires_and_droppers import Wired, Wiring
from arcless.mesh.division import wires
from arcless.mesh.division.chain import Chains
from arcless.mesh.division.nodes import make_chains
from arcless.mesh.division.numbering import Nodes
from arcless.mesh.division.systems import WireSystem, wire_systems
from arcless.mesh.tables.context import Kit
from arcless.mesh.tables.mesh_types import PLANAR, SPATIAL, Floats, Mesh, SupportPlace, SystemNodes
from arcless.model.line.line import Line
from arcless.model.settings.run_settings import Solver


def build_mesh(line: Line, solver: Solver, measured: Mapping[float, float] | None = None) -> Mesh:
    """Divide a line into elements.

    Parameters
    ----------
    line
        The overhead line.
    solver
        Gives the longest elements, the dimension and gravity.
    measured
        Heights of the contact wire in m at places along the track, in place of those drawn.

    Raises
    ------
    MeshError
        A planar calculation is asked for a line that has stagger or hinged steady arms.
    """
    kit = Kit(line, solver, _dimension(line, solver))
    places = [wires.stations(line, system) for system in wire_systems(line, measured or {})]
    chains, nodes = make_chains(line, solver, places)
    wired: list[Wired] = []
    supports: list[SupportPlace] = []
    systems: list[SystemNodes] = []
    for own, made in zip(places, chains, strict=True):
        wired.append(Wiring(kit, own, made).build())
        supports += Holding(kit, own, made).build()
        systems.append(_nodes(own.system, made, wired[-1]))
    add_curves(kit, nodes.positions)
    return _mesh(kit, nodes, systems, wired, supports)


def _mesh(
    kit: Kit, nodes: Nodes, systems: list[SystemNodes], wired: list[Wired], held: list[SupportPlace]
) -> Mesh:
    rows: dict[str, list[int]] = {}
    # Neighbours overlap, so they are on different lanes; the next but one begins behind the end.
    side_by_side = len(wired[0].contacts)
    lanes: list[list[int]] = [[] for _ in range(side_by_side * min(len(wired), 2))]
    for index, own in enumerate(wired):
        for wire, added in own.rows.items():
            rows.setdefault(wire, []).extend(added)
        for which, contact in enumerate(own.contacts):
            lanes[index % 2 * side_by_side + which].extend(contact)
    return Mesh(
        dimension=kit.dimension,
        positions=_in_space(kit, nodes.positions),
        slopes=_in_space(kit, nodes.slopes),
        parts=kit.parts.arrays(),
        gravity=kit.solver.gravity,
        lanes=lanes,
        wire_rows=rows,
        droppers=[dropper for own in wired for dropper in own.droppers],
        supports=held,
        systems=systems,
        ends=[end for own in wired for end in own.ends],
    )


def _nodes(system: WireSystem, chains: Chains, wired: Wired) -> SystemNodes:
    return SystemNodes(
        label=system.label,
        contact={name: chain.nodes for name, chain in chains.contacts.items()},
        messenger=[] if chains.messenger is None else chains.messenger.nodes,
        auxiliary=[] if chains.auxiliary is None else chains.auxiliary.nodes,
        stitches=wired.stitches,
        bridles=wired.bridles,
    )


def _in_space(kit: Kit, vectors: Floats) -> Floats:
    """Order the components as the core wants them: planar ones are (along, up, unused)."""
    if kit.spatial:
        return vectors
    return np.column_stack([vectors[:, 0], vectors[:, 2], np.zeros(len(vectors))])


def _dimension(line: Line, solver: Solver) -> int:
    if solver.dimension == "auto":
        return SPATIAL if line.is_spatial else PLANAR
    if solver.dimension == "planar" and line.is_spatial:
        raise MeshError(
            "solver.dimension",
            got="planar",
            expected="auto or spatial for a line with stagger, curves, hinged steady arms or wires"
            " that part",
            hint="a planar line is straight, without stagger, with steady arms of kind spring",
        )
    return PLANAR if solver.dimension == "planar" else SPATIAL
