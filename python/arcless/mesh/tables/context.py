"""Data that every wire system is built with."""

from dataclasses import dataclass, field

from arcless.mesh.tables.mesh_types import SPATIAL
from arcless.mesh.tables.parts import Parts
from arcless.model.line.line import Line
from arcless.model.settings.run_settings import Solver


@dataclass(frozen=True)
class Kit:
    """The line, how to divide it, and the tables its parts go into."""

    line: Line
    solver: Solver
    dimension: int
    parts: Parts = field(default_factory=Parts)

    @property
    def up(self) -> int:
        """Number of the vertical component."""
        return self.dimension - 1

    @property
    def spatial(self) -> bool:
        """True when nodes have a lateral position."""
        return self.dimension == SPATIAL

    @property
    def lumped(self) -> bool:
        """True when wires are chains of point masses."""
        return self.solver.wires == "lumped"
