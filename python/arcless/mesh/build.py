"""Line and solver settings → mesh."""

from collections.abc import Iterable, Mapping

import numpy as np

from arcless.errors import MeshError
from arcless.mesh import wires
from arcless.mesh.chains import Chains, Nodes, make_chains
from arcless.mesh.holding import Holding
from arcless.mesh.kit import Kit
from arcless.mesh.systems import wire_systems
from arcless.mesh.track import add_curves
from arcless.mesh.types import PLANAR, SPATIAL, Floats, Mesh, SupportPlace
from arcless.mesh.wiring import Wired, Wiring
from arcless.model.line import Line
from arcless.model.settings import Solver


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
    systems, nodes = make_chains(line, solver, places)
    wired: list[Wired] = []
    supports: list[SupportPlace] = []
    for own, chains in zip(places, systems, strict=True):
        wired.append(Wiring(kit, own, chains).build())
        supports += Holding(kit, own, chains).build()
    add_curves(kit, nodes.positions)
    return _mesh(kit, nodes, systems, wired, supports)


def _mesh(
    kit: Kit, nodes: Nodes, systems: list[Chains], wired: list[Wired], supports: list[SupportPlace]
) -> Mesh:
    contacts = [chain for chains in systems for chain in chains.contacts]
    auxiliaries = [chains.auxiliary for chains in systems if chains.auxiliary is not None]
    rows: dict[str, list[int]] = {}
    for own in wired:
        for wire, added in own.rows.items():
            rows.setdefault(wire, []).extend(added)
    return Mesh(
        dimension=kit.dimension,
        positions=_in_space(kit, nodes.positions),
        slopes=_in_space(kit, nodes.slopes),
        parts=kit.parts.arrays(),
        gravity=kit.solver.gravity,
        lanes=[_joined(own.rows["contact_wire"] for own in wired)],
        wire_rows=rows,
        contact_nodes=_joined(chain.nodes for chain in contacts),
        messenger_nodes=_joined(chains.messenger.nodes for chains in systems),
        droppers=[dropper for own in wired for dropper in own.droppers],
        supports=supports,
        auxiliary_nodes=_joined(chain.nodes for chain in auxiliaries),
        stitches=[stitch for own in wired for stitch in own.stitches],
    )


def _joined(pieces: Iterable[list[int]]) -> list[int]:
    return [number for piece in pieces for number in piece]


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
            expected="auto or spatial for a line with stagger, curves or hinged steady arms",
            hint="a planar line is straight, without stagger, with steady arms of kind spring",
        )
    return PLANAR if solver.dimension == "planar" else SPATIAL
