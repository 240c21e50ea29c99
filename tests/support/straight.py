"""Straight wires without weight, built by hand: the smallest meshes on which waves run.

All wires have nodes at the same places along the track; the first one is the lane.
"""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from arcless.equilibrium.equilibrium import Equilibrium
from arcless.mesh import PLANAR, SPATIAL
from arcless.mesh.division import wires
from arcless.mesh.tables.columns import GIVEN
from arcless.mesh.tables.parts import Parts
from arcless.model.line.parts.components import DropperType, Wire
from tests.support.structures import at_rest, mesh_of

Floats = NDArray[np.float64]

ALONG, UP = 0, 1
# In space.
ACROSS, UPWARDS = 1, 2
# Springs and dampers are one part, and its stiffness must not be zero. In N/m.
NEARLY_NONE = 1e-9
# EA of an arm, N: a tube of 42 mm, of which 1 kN stretches 1.2 m by 0.05 mm.
ARM = 2e7


def wire(
    tension: float, mass: float, bending: float = 0.0, axial: float = 1e9, **damping: float
) -> Wire:
    """Return a wire: N, kg per metre without tension, N·m², N; alpha in 1/s and beta in s."""
    stiffness = {"axial_stiffness": axial, "bending_stiffness": bending}
    return Wire.model_validate({"tension": tension, "mass": mass, **stiffness, "damping": damping})


def stations(start: float, end: float, coarse: float, fine: dict[float, float]) -> Floats:
    """Places of nodes, m: elements no longer than `coarse`, and finer ones near given places.

    `fine` has the longest element, m, at each place, m; from there they grow by a fifth.
    """
    places = sorted({start, end, *fine})
    pieces = [
        _graded(left, right, fine.get(left, coarse), fine.get(right, coarse), coarse)
        for left, right in pairwise(places)
    ]
    return np.concatenate([[start], *(piece[1:] for piece in pieces)])


def _graded(left: float, right: float, at_left: float, at_right: float, coarse: float) -> Floats:
    """Divide a piece: at d from an end, an element is as long as the one there plus d/5."""
    x = [left]
    while x[-1] < right:
        here = min(coarse, at_left + 0.2 * (x[-1] - left), at_right + 0.2 * (right - x[-1]))
        x.append(x[-1] + here)
    scaled = left + (np.array(x) - left) * (right - left) / (x[-1] - left)
    scaled[-1] = right
    return scaled


class Straight:
    """Wires side by side, and what is fastened to their nodes.

    Parameters
    ----------
    x : places of the nodes along the track, m
    kinds : the wires
    heights : their heights, m; without them all are at 0
    lumped : chains of point masses in place of cubic elements
    fitted : chains whose points, and what is between them, yield like the wire, as explicit steps
        have them
    flexible : with residual flexibility where forces meet the wires
    loose : the ends are held along the track only, not in height
    slant : what wires in space run across the track per metre along it; None in the plane
    corners : places, m, at which they turn back to the other side, and are held across the track
    arms : length of the level, hinged arms that pull there, m; None: held without them
    """

    def __init__(
        self,
        x: Floats,
        *kinds: Wire,
        heights: Sequence[float] = (0.0,),
        lumped: bool = False,
        fitted: bool = False,
        flexible: bool = False,
        loose: bool = False,
        slant: float | None = None,
        corners: Sequence[float] = (),
        arms: float | None = None,
    ) -> None:
        self.x, self.kinds, self.heights = x, kinds, heights
        self.parts, self.lumped, self.fitted = Parts(), lumped or fitted, fitted
        self.flexible, self.slant, self.corners = flexible, slant, corners
        self.up = UP if slant is None else UPWARDS
        self.rows = [self._lay(which, kind) for which, kind in enumerate(kinds)]
        for which, kind in enumerate(kinds):
            for end in (0, len(x) - 1):
                number = end * len(kinds) + which
                self.parts.fix(number, ALONG)
                if not loose:
                    self.parts.fix(number, self.up)
                if slant is not None:
                    self.parts.fix(number, ACROSS)
            for corner in corners:
                if arms is None:
                    self.parts.fix(self.node(corner, which), ACROSS)
                else:
                    self._pull(corner, which, arms)
            self.parts.add("ends", node=number, force=kind.tension, released=False)

    def across(self) -> tuple[Floats, Floats]:
        """Return where nodes are across the track, m, and how wires run there, per metre."""
        turns = np.searchsorted(self.corners, 0.5 * (self.x[:-1] + self.x[1:]))
        slopes = (self.slant or 0.0) * np.where(turns % 2, -1.0, 1.0)
        place = np.concatenate([[0.0], np.cumsum(slopes * np.diff(self.x))])
        both = 0.5 * (np.append(slopes[0], slopes) + np.append(slopes, slopes[-1]))
        return place - 0.5 * (place.max() + place.min()), both

    def _pull(self, x: float, which: int, length: float) -> None:
        """Let an arm pull the corner outward: by T times the angle of the corner."""
        place = float(self.across()[0][int(np.argmin(abs(self.x - x)))])
        side = float(np.sign(place))
        pull = 2.0 * self.kinds[which].tension * abs(self.slant or 0.0)
        self.parts.add(
            "struts", node=self.node(x, which), direction=(0.0, side, 0.0),
            anchor=(x, place + side * length, self.heights[which]),
            rest_length=length / (1.0 + pull / ARM), stiffness=ARM * (1.0 + pull / ARM) / length,
            moving_mass=0.0, hanging_mass=0.0, adjust=False,
        )  # fmt: skip

    def _lay(self, which: int, kind: Wire) -> list[int]:
        numbers = [i * len(self.kinds) + which for i in range(len(self.x))]
        lengths = np.diff(self.x) * np.hypot(1.0, self.slant or 0.0)
        ends = np.column_stack([numbers[:-1], numbers[1:]])
        kinds = [kind] * len(lengths)
        if not self.lumped:
            return self.parts.add_wires(kinds, ends, ends, lengths / wires.stretch(kind))
        rows = self.parts.add_segments(kinds, ends, lengths / wires.chain_stretch(kind))
        self.parts.add_bends(kinds, rows, hinges=())
        return rows

    def node(self, x: float, which: int = 0) -> int:
        """Node of a wire at a place, which must be one of the stations."""
        index = int(np.argmin(abs(self.x - x)))
        assert abs(self.x[index] - x) < 1e-9, f"no node at {x} m"
        return index * len(self.kinds) + which

    def add_mass(self, x: float, mass: float, which: int = 0) -> None:
        """Fasten a mass, kg."""
        self.parts.add_mass(self.node(x, which), mass)

    def add_spring(
        self, x: float, stiffness: float = NEARLY_NONE, damping: float = 0.0, which: int = 0
    ) -> None:
        """Fasten a spring to the ground, N/m, with a parallel damper, N·s/m."""
        self.parts.add_spring(
            self.node(x, which), self.up, GIVEN,
            stiffness=stiffness, viscosity=damping, rest=self.heights[which],
        )  # fmt: skip

    def add_dropper(self, x: float, kind: DropperType, pull: float = 0.0) -> int:
        """Hang the first wire on the second; return its row.

        `pull` is the force in N in the dropper, which loads on both wires balance.
        """
        upper, lower = self.node(x, 1), self.node(x, 0)
        if pull:
            self.parts.add("loads", node=lower, component=self.up, force=-pull)
            self.parts.add("loads", node=upper, component=self.up, force=pull)
        apart = self.heights[1] - self.heights[0]
        return self.parts.add_dropper(kind, upper, lower, apart, apart - pull / kind.stiffness)

    def find(self) -> Equilibrium:
        """Find the equilibrium, as the program does it for a line."""
        count, several = len(self.x), len(self.kinds)
        positions = np.zeros((count * several, 3))
        positions[:, ALONG] = np.repeat(self.x, several)
        positions[:, self.up] = np.tile(self.heights, count)
        directions = np.tile([1.0, 0.0, 0.0], (count, 1))
        if self.slant is not None:
            place, slope = self.across()
            positions[:, ACROSS] = np.repeat(place, several)
            directions[:, ACROSS] = slope
            directions /= np.hypot(1.0, slope)[:, None]
        slopes = np.zeros_like(positions)
        if not self.lumped:
            stretches = [wires.stretch(kind) for kind in self.kinds]
            slopes = np.kron(directions, np.array(stretches)[:, None])
        dimension = PLANAR if self.slant is None else SPATIAL
        mesh = mesh_of(dimension, positions, slopes, self.parts, self.rows[0])
        return at_rest(
            mesh, design=True, fitted_bends=self.fitted, residual_flexibility=self.flexible
        )
