"""Model → arrays: nodes, elements and the names behind their numbers."""

from arcless.mesh.build import PLANAR, SPATIAL, build_mesh
from arcless.mesh.types import DropperPlace, Mesh, SupportPlace

__all__ = ["PLANAR", "SPATIAL", "DropperPlace", "Mesh", "SupportPlace", "build_mesh"]
