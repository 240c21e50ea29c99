"""Model → arrays: nodes, elements and the names behind their numbers."""

from arcless.mesh.alteration import alteration, diameters, without
from arcless.mesh.build import build_mesh
from arcless.mesh.types import (
    PLANAR,
    SPATIAL,
    DropperPlace,
    Mesh,
    StitchPlace,
    SupportPlace,
    SystemNodes,
)

__all__ = [
    "PLANAR",
    "SPATIAL",
    "DropperPlace",
    "Mesh",
    "StitchPlace",
    "SupportPlace",
    "SystemNodes",
    "alteration",
    "build_mesh",
    "diameters",
    "without",
]
