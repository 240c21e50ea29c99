"""The wires and droppers of a wire system → rows of the tables."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from arcless.mesh.division import wires
from arcless.mesh.division.chain import Chain, Chains
from arcless.mesh.division.masses_and_inserts import masses
from arcless.mesh.tables.columns import UNLOADED
from arcless.mesh.tables.context import Kit
from arcless.mesh.tables.mesh_types import DropperPlace, EndPlace, Floats, StitchPlace
from arcless.mesh.tables.parts import each_of
from arcless.model.line.parts.components import StitchWire, TensionedWire, Wire
from arcless.model.line.parts.contact_supports import Bridle
from arcless.model.line.parts.midpoint_anchor import MidpointAnchor


@dataclass(frozen=True)
class Wired:
    """Rows of the elements of each wire by its field of the line, and what hangs between them.

    `contacts` has the rows of each contact wire.
    """

    rows: dict[str, list[int]]
    contacts: list[list[int]]
    stitches: list[StitchPlace]
    bridles: list[StitchPlace]
    droppers: list[DropperPlace]
    ends: list[EndPlace]


class Wiring:
    """Adds the wires and droppers of one system."""

    def __init__(self, kit: Kit, places: wires.Stations, chains: Chains) -> None:
        self.kit, self.places, self.chains = kit, places, chains
        self.line, self.parts = kit.line, kit.parts
        self.ends: list[EndPlace] = []

    def build(self) -> Wired:
        """Add everything, wires first."""
        line, chains = self.line, self.chains
        contacts = [self._add_anchored(c, "contact_wire") for c in chains.contacts.values()]
        rows = {"contact_wire": [row for contact in contacts for row in contact]}
        stitches: list[StitchPlace] = []
        if chains.messenger is not None and line.messenger_wire is not None:
            rows["messenger_wire"] = self._add_anchored(chains.messenger, "messenger_wire")
            stitches = self._add_clamped(chains.stitches, chains.messenger, line.stitch_wire)
        rows["stitch_wire"] = [row for stitch in stitches for row in stitch.rows]
        (contact, *_) = chains.contacts.values()
        bridles = self._add_clamped(chains.bridles, contact, line.bridle)
        rows["bridle"] = [row for bridle in bridles for row in bridle.rows]
        if chains.auxiliary is not None and line.auxiliary_wire is not None:
            rows["auxiliary_wire"] = self._add_anchored(chains.auxiliary, "auxiliary_wire")
        self._add_masses()
        return Wired(rows, contacts, stitches, bridles, self._add_droppers(), self.ends)

    def _add_anchored(self, chain: Chain, wire: str) -> list[int]:
        """Add the elements of a wire and what holds its ends; return the elements' rows."""
        rows = self._add_wire(chain)
        for component in range(self.kit.dimension):
            self.parts.fix(chain.nodes[0], component)
            self.parts.fix(chain.nodes[-1], component)
        self._add_end(wire, chain.nodes[-1], rows[-1], 1.0)
        if self.line.midpoint_anchor is not None:
            self._add_end(wire, chain.nodes[0], rows[0], -1.0)
            held = chain.at(self._midpoint(self.line.midpoint_anchor))
            stiffness = self.line.midpoint_anchor.stiffness
            self.parts.add_spring(held, 0, UNLOADED, stiffness=stiffness)
        return rows

    def _add_end(self, name: str, node: int, element: int, outward: float) -> None:
        """Add what tensions an end: an anchor, a constant force, or that and a spring about it.

        A device with friction holds still as long as its tension stays in a band, and the designed
        one lies in it. What happens beyond is for the line as built.
        """
        wire: Wire = getattr(self.line, name)
        free = not wire.is_anchored and not wire.has_friction
        row = self.parts.add("ends", node=node, force=outward * wire.tension, released=free)
        self.ends.append(EndPlace(row, name, node, element, outward))
        # The weight's mass acts along the track only: it moves up and down at the pulley.
        self.parts.add_mass(node, wire.end_mass)
        if wire.end_stiffness is not None:
            self.parts.add_spring(node, 0, UNLOADED, stiffness=wire.end_stiffness)

    def _midpoint(self, anchor: MidpointAnchor) -> float:
        """Return where the wires are held along the track, in m."""
        system = self.places.system
        if anchor.support is not None:
            return system.supports[anchor.support - system.first]
        return system.supports[len(system.supports) // 2]

    def _add_clamped(
        self, chains: list[Chain], carrier: Chain, wire: StitchWire | Bridle | None
    ) -> list[StitchPlace]:
        """Add stitch wires (bridles) and their clamps on the wire that they are clamped to."""
        found = []
        # The first support is an anchor.
        for number, chain in enumerate(chains, start=self.places.system.first + 1):
            rows = self._add_wire(chain)
            assert wire is not None
            for node in (chain.nodes[0], chain.nodes[-1]):
                self.parts.add_mass(node, wire.clamp_mass, carrier.wire.damping.alpha)
            found.append(StitchPlace(number, chain.nodes, rows))
        return found

    def _add_masses(self) -> None:
        for wire, x, mass in masses(self.line, self.places.system):
            chain = self.chains.of(wire, x)
            self.parts.add_mass(chain.at(x), mass, chain.wire.damping.alpha)

    def _add_wire(self, chain: Chain) -> list[int]:
        return self._add_segments(chain) if self.kit.lumped else self._add_elements(chain)

    def _add_elements(self, chain: Chain) -> list[int]:
        sections = chain.sections()
        lengths = self._unstretched(chain, sections, wires.stretch)
        nodes = np.array(chain.nodes)
        ends = np.column_stack([nodes[:-1], nodes[1:]])
        slopes = ends.copy()
        slopes[list(chain.leaving), 0] = list(chain.leaving.values())
        slopes[[row - 1 for row in chain.arriving], 1] = list(chain.arriving.values())
        return self.parts.add_wires(sections, ends, slopes, lengths)

    def _add_segments(self, chain: Chain) -> list[int]:
        """Add a chain of point masses that bends at its inner nodes, except at the hinges."""
        sections = chain.sections()
        lengths = self._unstretched(chain, sections, wires.chain_stretch)
        nodes = np.array(chain.nodes)
        ends = np.column_stack([nodes[:-1], nodes[1:]])
        rows = self.parts.add_segments(sections, ends, lengths)
        self.parts.add_bends(sections, rows, chain.hinges)
        return rows

    @staticmethod
    def _unstretched(
        chain: Chain, sections: list[TensionedWire], law: Callable[[TensionedWire], float]
    ) -> Floats:
        stretches = each_of(sections, lambda wire: {"stretch": law(wire)})
        return wires.chord_lengths(chain.points, stretches["stretch"])

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
