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


def at_rest(
    mesh: Mesh, *, design: bool = False, fitted_bends: bool = False,
    residual_flexibility: bool = False,
) -> equilibrium.Equilibrium:  # fmt: skip
    """Find the equilibrium; through the module that deliberate faults spoil."""
    core = equilibrium._core.Equilibrium(
        *(mesh.dimension, mesh.positions, mesh.slopes, mesh.parts, mesh.gravity),
        design=design,
        residual_flexibility=residual_flexibility,
        fitted_bends=fitted_bends,
    )
    return equilibrium.Equilibrium(mesh, core, core.arrays())
