"""Line and solver settings → mesh."""

from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np

from arcless.errors import MeshError
from arcless.mesh import wires
from arcless.mesh.parts import HELD, UNLOADED, Parts
from arcless.mesh.types import DropperPlace, Floats, Mesh, SupportPlace
from arcless.model.components import NoSteadyArm, SteadyArmBar, Wire
from arcless.model.line import Line
from arcless.model.settings import Solver

PLANAR, SPATIAL = 2, 3


def build_mesh(line: Line, solver: Solver) -> Mesh:
    """Divide a line into elements.

    Parameters
    ----------
    line
        The overhead line.
    solver
        Gives the longest elements, the dimension and gravity.

    Raises
    ------
    MeshError
        A planar calculation is asked for a line that has stagger or hinged steady arms.
    """
    return _Builder(line, solver).build()


@dataclass
class _Chain:
    """Nodes of one wire: positions (n × 3) and their numbers in the mesh.

    `leaving` maps a hinged node to the one that holds the slope behind the hinge.
    """

    points: Floats
    nodes: list[int] = field(default_factory=list)
    leaving: dict[int, int] = field(default_factory=dict)

    def row(self, x: float) -> int:
        """Row of the node that stands at a station."""
        return int(np.searchsorted(self.points[:, 0], x - wires.SAME_PLACE))

    def at(self, x: float) -> int:
        """Return the number of the node that stands at a station."""
        return self.nodes[self.row(x)]


class _Builder:
    def __init__(self, line: Line, solver: Solver) -> None:
        self.line, self.solver = line, solver
        self.dimension = _dimension(line, solver)
        self.up = self.dimension - 1
        self.lumped = solver.wire_model == "lumped"
        self.places = wires.stations(line)
        self.parts = Parts()

    def build(self) -> Mesh:
        contact, messenger = self._chains()
        positions, slopes = self._number(contact, messenger)
        path = self._add_wires(contact, messenger)
        droppers = self._add_droppers(contact, messenger)
        supports = self._add_supports(contact, messenger)
        return Mesh(
            dimension=self.dimension,
            positions=self._in_space(positions),
            slopes=self._in_space(slopes),
            parts=self.parts.arrays(),
            gravity=self.solver.gravity,
            path=path,
            contact_nodes=contact.nodes,
            messenger_nodes=messenger.nodes,
            droppers=droppers,
            supports=supports,
        )

    def _in_space(self, vectors: Floats) -> Floats:
        """Order the components as the core wants them: planar ones are (along, up, unused)."""
        if self.dimension == SPATIAL:
            return vectors
        return np.column_stack([vectors[:, 0], vectors[:, 2], np.zeros(len(vectors))])

    def _chains(self) -> tuple[_Chain, _Chain]:
        line, supports, gravity = self.line, self.places.supports, self.solver.gravity
        places = sorted([*supports, *(dropper[1] for dropper in self.places.droppers)])
        x = wires.divide(places, self.solver.contact_wire_element)
        y = wires.stagger_guess(line.geometry.stagger_contact_wire, supports, x)
        z = wires.contact_guess(line, self.places, x, gravity)
        contact = _Chain(np.column_stack([x, y, z]))
        x = wires.divide(places, self.solver.messenger_wire_element)
        y = wires.stagger_guess(line.geometry.stagger_messenger_wire, supports, x)
        z = wires.messenger_guess(line, supports, x, gravity)
        return contact, _Chain(np.column_stack([x, y, z]))

    def _number(self, contact: _Chain, messenger: _Chain) -> tuple[Floats, Floats]:
        """Give numbers to all nodes along the track; messenger before contact wire."""
        tangents = self._slopes(messenger, self.line.messenger_wire)
        # A chain of point masses has no slopes to be told apart at a hinge.
        hinges = [] if self.lumped else self._hinge_rows(messenger)
        points = np.vstack([messenger.points, messenger.points[hinges], contact.points])
        tangents = np.vstack(
            [tangents, tangents[hinges], self._slopes(contact, self.line.contact_wire)]
        )
        order = np.argsort(points[:, 0], kind="stable")
        rank = np.empty(len(order), dtype=np.int64)
        rank[order] = np.arange(len(order))
        numbers = [int(n) for n in rank]
        count, all_messenger = len(messenger.points), len(messenger.points) + len(hinges)
        messenger.nodes = numbers[:count]
        messenger.leaving = dict(
            zip((messenger.nodes[row] for row in hinges), numbers[count:all_messenger], strict=True)
        )
        contact.nodes = numbers[all_messenger:]
        return points[order], tangents[order]

    def _slopes(self, chain: _Chain, wire: Wire) -> Floats:
        if self.lumped:
            return np.zeros_like(chain.points)
        return wires.slopes(chain.points, wires.stretch(wire))

    def _hinge_rows(self, messenger: _Chain) -> list[int]:
        """Rows of the messenger wire's nodes at inner supports.

        The saddle of a support follows the wire, which bends there without lifting: no moment is
        carried. A slope continuous over the support would need elements shorter than √(EI/T).
        """
        return [messenger.row(support) for support in self.places.supports[1:-1]]

    def _add_wires(self, contact: _Chain, messenger: _Chain) -> list[int]:
        path = self._add_wire(contact, self.line.contact_wire, [])
        self._add_wire(messenger, self.line.messenger_wire, self._hinge_rows(messenger))
        return path

    def _add_wire(self, chain: _Chain, wire: Wire, hinges: list[int]) -> list[int]:
        """Add the elements of a wire and what holds its ends; return the elements' rows."""
        if self.lumped:
            rows = self._add_segments(chain, wire, set(hinges))
        else:
            rows = self._add_elements(chain, wire)
        for component in range(self.dimension):
            self.parts.add("fixed", (chain.nodes[0], component))
            self.parts.add("fixed", (chain.nodes[-1], component))
        released = int(wire.ends == "constant_force")
        self.parts.add("ends", (chain.nodes[-1], released), (wire.tension,))
        return rows

    def _add_elements(self, chain: _Chain, wire: Wire) -> list[int]:
        lengths = wires.chord_lengths(chain.points, wires.stretch(wire))
        rows = []
        for a, b, length in zip(chain.nodes, chain.nodes[1:], lengths, strict=False):
            slopes = (chain.leaving.get(a, a), b)
            rows.append(self.parts.add_wire(wire, (a, b), slopes, float(length)))
        return rows

    def _add_segments(self, chain: _Chain, wire: Wire, hinges: set[int]) -> list[int]:
        """Add a chain of point masses that bends at its inner nodes, but for the hinges."""
        lengths = wires.chord_lengths(chain.points, wires.chain_stretch(wire))
        rows = [
            self.parts.add_segment(wire, nodes, float(length))
            for nodes, length in zip(pairwise(chain.nodes), lengths, strict=True)
        ]
        for node, (before, behind) in enumerate(pairwise(rows), start=1):
            if node not in hinges:
                self.parts.add_bend(wire, before, behind)
        return rows

    def _add_droppers(self, contact: _Chain, messenger: _Chain) -> list[DropperPlace]:
        kind, line = self.line.dropper, self.line
        found: list[DropperPlace] = []
        count = 0
        for span, x, _, length in self.places.droppers:
            count = 1 if not found or found[-1].span != span else count + 1
            upper, lower = messenger.at(x), contact.at(x)
            apart = messenger.points[messenger.row(x)] - contact.points[contact.row(x)]
            distance = float(np.linalg.norm(apart))
            row = self.parts.add_dropper(kind, upper, lower, distance, length)
            self.parts.add_mass(
                upper, kind.clamp_mass_messenger_wire, line.messenger_wire.damping.alpha
            )
            self.parts.add_mass(
                lower, kind.clamp_mass_contact_wire, line.contact_wire.damping.alpha
            )
            found.append(DropperPlace(f"span {span} dropper {count}", span, x, row))
        return found

    def _add_supports(self, contact: _Chain, messenger: _Chain) -> list[SupportPlace]:
        last = len(self.places.supports) - 1
        found = []
        for index, x in enumerate(self.places.supports):
            node = contact.at(x)
            spring = arm = None
            if 0 < index < last:
                spring = self._hold_messenger(messenger.at(x))
                arm = self._hold_contact_wire(node, index)
            found.append(SupportPlace(f"support {index + 1}", x, node, spring, arm))
        return found

    def _hold_messenger(self, node: int) -> int:
        support = self.line.support
        vertical = (support.vertical_stiffness, support.vertical_damping, 0.0)
        row = self.parts.add("springs", (node, self.up, HELD), vertical)
        if self.dimension == SPATIAL:
            lateral = support.lateral_stiffness or support.vertical_stiffness
            self.parts.add("springs", (node, 1, HELD), (lateral, 0.0, 0.0))
        if support.longitudinal_stiffness > 0.0:
            stiffness = (support.longitudinal_stiffness, 0.0, 0.0)
            self.parts.add("springs", (node, 0, UNLOADED), stiffness)
        self.parts.add_mass(node, support.mass, 0.0)
        return row

    def _hold_contact_wire(self, node: int, index: int) -> int | None:
        arm = self.line.steady_arm
        if isinstance(arm, SteadyArmBar):
            return self.parts.add_steady_arm(arm, node, self._pull_side(index))
        if isinstance(arm, NoSteadyArm):
            return None
        if arm.vertical_stiffness > 0.0:
            spring = (arm.vertical_stiffness, arm.vertical_damping, 0.0)
            self.parts.add("springs", (node, self.up, UNLOADED), spring)
        self.parts.add_mass(node, arm.mass, 0.0)
        if self.dimension == SPATIAL:
            # An arm known only by its vertical stiffness holds the stagger rigidly.
            self.parts.add("fixed", (node, 1))
        return None

    def _pull_side(self, index: int) -> float:
        """Side the arm pulls to: outwards of the bend that the stagger makes, in tension."""
        pattern = self.line.geometry.stagger_contact_wire
        before, here, after = (pattern[i % len(pattern)] for i in (index - 1, index, index + 1))
        x0, x1, x2 = self.places.supports[index - 1 : index + 2]
        bend = (here - before) / (x1 - x0) - (after - here) / (x2 - x1)
        return -1.0 if bend < 0.0 else 1.0


def _dimension(line: Line, solver: Solver) -> int:
    if solver.dimension == "auto":
        return SPATIAL if line.is_spatial else PLANAR
    if solver.dimension == "planar" and line.is_spatial:
        raise MeshError(
            "solver.dimension",
            got="planar",
            expected="auto or spatial for a line with stagger or hinged steady arms",
            hint="a planar line has no stagger and a steady arm of kind spring",
        )
    return PLANAR if solver.dimension == "planar" else SPATIAL
