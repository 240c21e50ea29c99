"""Model → arrays: nodes, elements and the names behind their numbers."""

from arcless.mesh.build.alteration import alteration, diameters, end_forces, without
from arcless.mesh.build.mesh import build_mesh
from arcless.mesh.tables.mesh_types import (
    PLANAR,
    SPATIAL,
    DropperPlace,
    EndPlace,
    Mesh,
    StitchPlace,
    SupportPlace,
    SystemNodes,
)

__all__ = [
    "PLANAR",
    "SPATIAL",
    "DropperPlace",
    "EndPlace",
    "Mesh",
    "StitchPlace",
    "SupportPlace",
    "SystemNodes",
    "alteration",
    "build_mesh",
    "diameters",
    "end_forces",
    "without",
]
