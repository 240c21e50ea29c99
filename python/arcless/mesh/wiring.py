"""The wires and droppers of a wire system → rows of the tables."""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from arcless.mesh import wires
from arcless.mesh.chains import Chain, Chains
from arcless.mesh.kit import Kit
from arcless.mesh.types import DropperPlace, Floats, StitchPlace
from arcless.model.components import TensionedWire, Wire


@dataclass(frozen=True)
class Wired:
    """Rows of the elements of each wire by its field of the line, and what hangs between them.

    `contacts` has the rows of each contact wire.
    """

    rows: dict[str, list[int]]
    contacts: list[list[int]]
    stitches: list[StitchPlace]
    droppers: list[DropperPlace]


class Wiring:
    """Adds the wires and droppers of one system."""

    def __init__(self, kit: Kit, places: wires.Stations, chains: Chains) -> None:
        self.kit, self.places, self.chains = kit, places, chains
        self.line, self.parts = kit.line, kit.parts

    def build(self) -> Wired:
        """Add everything, wires first."""
        line, chains = self.line, self.chains
        contacts = [self._add_anchored(c, line.contact_wire) for c in chains.contacts.values()]
        rows = {"contact_wire": [row for contact in contacts for row in contact]}
        rows["messenger_wire"] = self._add_anchored(chains.messenger, line.messenger_wire)
        stitches = self._add_stitches()
        rows["stitch_wire"] = [row for stitch in stitches for row in stitch.rows]
        if chains.auxiliary is not None and line.auxiliary_wire is not None:
            rows["auxiliary_wire"] = self._add_anchored(chains.auxiliary, line.auxiliary_wire)
        return Wired(rows, contacts, stitches, self._add_droppers())

    def _add_anchored(self, chain: Chain, wire: Wire) -> list[int]:
        """Add the elements of a wire and what holds its ends; return the elements' rows."""
        rows = self._add_wire(chain)
        for component in range(self.kit.dimension):
            self.parts.add("fixed", (chain.nodes[0], component))
            self.parts.add("fixed", (chain.nodes[-1], component))
        released = int(wire.ends == "constant_force")
        self.parts.add("ends", (chain.nodes[-1], released), (wire.tension,))
        return rows

    def _add_stitches(self) -> list[StitchPlace]:
        """Add the stitch wires and their clamps on the messenger wire."""
        found, messenger = [], self.chains.messenger
        # The first support is an anchor.
        for number, chain in enumerate(self.chains.stitches, start=self.places.system.first + 1):
            rows = self._add_wire(chain)
            assert self.line.stitch_wire is not None
            for node in (chain.nodes[0], chain.nodes[-1]):
                alpha = messenger.wire.damping.alpha
                self.parts.add_mass(node, self.line.stitch_wire.clamp_mass, alpha)
            found.append(StitchPlace(number, chain.nodes, rows))
        return found

    def _add_wire(self, chain: Chain) -> list[int]:
        return self._add_segments(chain) if self.kit.lumped else self._add_elements(chain)

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
