"""Model → arrays: nodes, elements and the names behind their numbers."""

from arcless.mesh.build import build_mesh
from arcless.mesh.types import DropperPlace, Mesh, SupportPlace

__all__ = ["DropperPlace", "Mesh", "SupportPlace", "build_mesh"]
