"""Small structures made by hand: arrays of a mesh, brought to rest by the core."""

from typing import Any

import numpy as np

from arcless.equilibrium import equilibrium
from arcless.mesh import Mesh
from arcless.mesh.tables.parts import Parts


def mesh_of(
    dimension: int, positions: Any, slopes: Any, parts: Parts, lane: list[int], *,
    gravity: float = 0.0,
) -> Mesh:  # fmt: skip
    """Make a mesh of parts: nodes (n × 3: along, across, up) in m, their slopes; gravity, m/s²."""
    return Mesh(
        dimension=dimension,
        positions=np.asarray(positions, dtype=np.float64),
        slopes=np.asarray(slopes, dtype=np.float64),
        parts=parts.arrays(),
        gravity=gravity,
        lanes=[lane],
        droppers=[],
        supports=[],
        wire_rows={},
        systems=[],
    )


def add_element(
    parts: Parts, i: int, *, rest: float, axial: float, mass: float, tension: float,
    bending: float | None = None,
) -> int:  # fmt: skip
    """Add an undamped element from node `i` to the next: cubic if it has a bending stiffness.

    Rest length in m, EA in N, kg/m, tension of the design in N, EI in N·m².
    """
    columns = {
        "nodes": (i, i + 1), "rest_length": rest, "axial_stiffness": axial, "mass": mass,
        "alpha": 0.0, "beta": 0.0, "design_tension": tension,
    }  # fmt: skip
    if bending is None:
        return parts.add("segments", **columns)
    return parts.add("wires", **columns, slope_nodes=(i, i + 1), bending_stiffness=bending)


def at_rest(
    mesh: Mesh, *, design: bool = False, fitted_bends: bool = False,
    residual_flexibility: bool = False,
) -> equilibrium.Equilibrium:  # fmt: skip
    """Find the equilibrium; through the module that deliberate faults spoil."""
    core = equilibrium._core.Equilibrium(
        dimension=mesh.dimension,
        positions=mesh.positions,
        slopes=mesh.slopes,
        parts=mesh.parts,
        gravity=mesh.gravity,
        design=design,
        residual_flexibility=residual_flexibility,
        fitted_bends=fitted_bends,
    )
    return equilibrium.Equilibrium(mesh, core, core.arrays())
