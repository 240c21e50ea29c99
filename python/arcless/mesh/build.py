"""Line and solver settings → mesh."""

from collections.abc import Callable
from itertools import pairwise

import numpy as np

from arcless.errors import MeshError
from arcless.mesh import wires
from arcless.mesh.chains import Chain, make_chains
from arcless.mesh.parts import HELD, UNLOADED, Parts
from arcless.mesh.types import DropperPlace, Floats, Mesh, StitchPlace, SupportPlace
from arcless.model.components import NoSteadyArm, SteadyArmBar, TensionedWire, Wire
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


class _Builder:
    def __init__(self, line: Line, solver: Solver) -> None:
        self.line, self.solver = line, solver
        self.dimension = _dimension(line, solver)
        self.up = self.dimension - 1
        self.lumped = solver.wire_model == "lumped"
        self.places = wires.stations(line)
        self.chains = make_chains(line, solver, self.places)
        self.parts = Parts()

    def build(self) -> Mesh:
        chains = self.chains
        path = self._add_anchored(chains.contact, self.line.contact_wire)
        rows = {"contact_wire": path}
        rows["messenger_wire"] = self._add_anchored(chains.messenger, self.line.messenger_wire)
        stitches = self._add_stitches()
        rows["stitch_wire"] = [row for stitch in stitches for row in stitch.rows]
        if chains.auxiliary is not None and self.line.auxiliary_wire is not None:
            rows["auxiliary_wire"] = self._add_anchored(chains.auxiliary, self.line.auxiliary_wire)
        droppers = self._add_droppers()
        supports = self._add_supports(chains.contact, chains.messenger)
        return Mesh(
            dimension=self.dimension,
            positions=self._in_space(chains.positions),
            slopes=self._in_space(chains.slopes),
            parts=self.parts.arrays(),
            gravity=self.solver.gravity,
            path=path,
            wire_rows=rows,
            contact_nodes=chains.contact.nodes,
            messenger_nodes=chains.messenger.nodes,
            droppers=droppers,
            supports=supports,
            auxiliary_nodes=[] if chains.auxiliary is None else chains.auxiliary.nodes,
            stitches=stitches,
        )

    def _in_space(self, vectors: Floats) -> Floats:
        """Order the components as the core wants them: planar ones are (along, up, unused)."""
        if self.dimension == SPATIAL:
            return vectors
        return np.column_stack([vectors[:, 0], vectors[:, 2], np.zeros(len(vectors))])

    def _add_anchored(self, chain: Chain, wire: Wire) -> list[int]:
        """Add the elements of a wire and what holds its ends; return the elements' rows."""
        rows = self._add_wire(chain)
        for component in range(self.dimension):
            self.parts.add("fixed", (chain.nodes[0], component))
            self.parts.add("fixed", (chain.nodes[-1], component))
        released = int(wire.ends == "constant_force")
        self.parts.add("ends", (chain.nodes[-1], released), (wire.tension,))
        return rows

    def _add_stitches(self) -> list[StitchPlace]:
        """Add the stitch wires and their clamps on the messenger wire."""
        found, messenger = [], self.chains.messenger
        for number, chain in enumerate(self.chains.stitches, start=2):
            rows = self._add_wire(chain)
            assert self.line.stitch_wire is not None
            for node in (chain.nodes[0], chain.nodes[-1]):
                alpha = messenger.wire.damping.alpha
                self.parts.add_mass(node, self.line.stitch_wire.clamp_mass, alpha)
            found.append(StitchPlace(number, chain.nodes, rows))
        return found

    def _add_wire(self, chain: Chain) -> list[int]:
        return self._add_segments(chain) if self.lumped else self._add_elements(chain)

    def _add_elements(self, chain: Chain) -> list[int]:
        sections = chain.sections()
        lengths = self._unstretched(chain, sections, wires.stretch)
        rows = []
        for row, (nodes, section) in enumerate(zip(pairwise(chain.nodes), sections, strict=True)):
            slopes = (chain.leaving.get(row, nodes[0]), chain.arriving.get(row + 1, nodes[1]))
            rows.append(self.parts.add_wire(section, nodes, slopes, float(lengths[row])))
        return rows

    def _add_segments(self, chain: Chain) -> list[int]:
        """Add a chain of point masses that bends at its inner nodes, but for the hinges."""
        sections = chain.sections()
        lengths = self._unstretched(chain, sections, wires.chain_stretch)
        rows = [
            self.parts.add_segment(section, nodes, float(length))
            for nodes, section, length in zip(pairwise(chain.nodes), sections, lengths, strict=True)
        ]
        hinges = set(chain.hinges)
        for node, (before, behind) in enumerate(pairwise(rows), start=1):
            if node not in hinges:
                self.parts.add_bend(chain.wire, before, behind)
        return rows

    @staticmethod
    def _unstretched(
        chain: Chain, sections: list[TensionedWire], law: Callable[[TensionedWire], float]
    ) -> Floats:
        if chain.relieved is None:
            return wires.chord_lengths(chain.points, law(chain.wire))
        full, left = law(chain.wire), law(chain.relieved)
        by_element = [left if section is chain.relieved else full for section in sections]
        return wires.chord_lengths(chain.points, np.array(by_element))

    def _add_droppers(self) -> list[DropperPlace]:
        found: list[DropperPlace] = []
        for hanging in self.places.hangings:
            kind, x = hanging.kind, hanging.x
            above, below = (self.chains.of(wire, x) for wire in (hanging.upper, hanging.lower))
            nodes = (above.at(x), below.at(x))
            apart = above.points[above.row(x)] - below.points[below.row(x)]
            distance = float(np.linalg.norm(apart))
            row = self.parts.add_dropper(kind, *nodes, distance, hanging.length)
            self.parts.add_mass(nodes[0], kind.clamp_mass_messenger_wire, above.wire.damping.alpha)
            self.parts.add_mass(nodes[1], kind.clamp_mass_contact_wire, below.wire.damping.alpha)
            names = (hanging.upper, hanging.lower)
            found.append(DropperPlace(hanging.name, hanging.span, x, row, nodes, names))
        return sorted(found, key=lambda dropper: (dropper.span, dropper.x))

    def _add_supports(self, contact: Chain, messenger: Chain) -> list[SupportPlace]:
        last = len(self.places.supports) - 1
        auxiliary = self.chains.auxiliary
        found = []
        for index, x in enumerate(self.places.supports):
            node = contact.at(x)
            spring = arm = None
            if 0 < index < last:
                spring = self._hold_messenger(messenger.at(x))
                arm = self._hold_contact_wire(node, index)
                if auxiliary is not None and self.dimension == SPATIAL:
                    # A pull-off keeps its lateral position; it hangs on droppers alone.
                    self.parts.add("fixed", (auxiliary.at(x), 1))
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
