"""Division of the wires of all systems into nodes."""

import numpy as np

from arcless.mesh.division import wires
from arcless.mesh.division.chain import Chain, Chains
from arcless.mesh.division.masses_and_inserts import inserts
from arcless.mesh.division.numbering import Nodes, number
from arcless.mesh.division.shapes import Guess
from arcless.mesh.division.wire_names import AUXILIARY, BRIDLE, MESSENGER, STITCH
from arcless.mesh.tables.mesh_types import Floats
from arcless.model.line.line import Line
from arcless.model.line.parts.components import TensionedWire
from arcless.model.settings.run_settings import Solver


def make_chains(
    line: Line, solver: Solver, places: list[wires.Stations]
) -> tuple[list[Chains], Nodes]:
    """Divide the wires of all systems and number their nodes along the track."""
    systems = [_Division(line, solver, own).chains() for own in places]
    return systems, number(systems, lumped=solver.wires == "lumped")


class _Division:
    """Divides the wires of one system."""

    def __init__(self, line: Line, solver: Solver, places: wires.Stations) -> None:
        self.line, self.solver, self.places, self.system = line, solver, places, places.system
        self.guess = Guess(line, places, solver.gravity)

    def chains(self) -> Chains:
        contacts = {name: self.contact(name) for name in self.system.contact_wires}
        messenger = self.messenger()
        stitches = [] if messenger is None else self.stitches(messenger)
        bridles = [piece for contact in contacts.values() for piece in self.bridles(contact)]
        return Chains(contacts, messenger, self.auxiliary(), stitches, bridles)

    def points(self, wire: str, x: Floats, stagger: list[float]) -> Floats:
        y = np.interp(x, self.places.supports, stagger)
        return np.column_stack([x, y, self.guess.of(wire, x)])

    def contact(self, name: str) -> Chain:
        x = wires.divide(self.places.along(name), self.solver.contact_wire_element_m)
        wire, bridle = self.line.contact_wire, self.line.bridle
        points = self.points(name, x, self.system.stagger_of(name))
        own = inserts(self.line, self.system, name)
        chain = Chain(points, wire, clamps=self.places.bridles, inserts=own)
        if bridle is not None:
            chain.relieved = _relieved(wire, bridle)
        return chain

    def messenger(self) -> Chain | None:
        line, places = self.line, self.places
        if line.messenger_wire is None:
            return None
        x = wires.divide(places.along(MESSENGER), self.solver.messenger_wire_element_m)
        points = self.points(MESSENGER, x, self.system.messenger_stagger)
        own = inserts(line, self.system, MESSENGER)
        chain = Chain(points, line.messenger_wire, clamps=places.clamps, inserts=own)
        # The saddle of a support follows the wire, which bends there without lifting: no moment is
        # carried. A slope continuous over the support would need elements shorter than √(EI/T).
        turning = [*places.supports[1:-1], *(x for pair in places.clamps for x in pair)]
        chain.hinges = sorted(chain.row(x) for x in turning)
        if line.stitch_wire is not None:
            chain.relieved = _relieved(line.messenger_wire, line.stitch_wire)
        return chain

    def auxiliary(self) -> Chain | None:
        wire = self.line.auxiliary_wire
        if wire is None:
            return None
        x = wires.divide(self.places.along(AUXILIARY), self.solver.messenger_wire_element_m)
        own = inserts(self.line, self.system, AUXILIARY)
        return Chain(self.points(AUXILIARY, x, self.system.auxiliary_stagger), wire, inserts=own)

    def stitches(self, messenger: Chain) -> list[Chain]:
        wire, found = self.line.stitch_wire, []
        if wire is None:
            return []
        hung = np.array(self.places.along(STITCH))
        for first, last in self.places.clamps:
            own = hung[(hung >= first) & (hung <= last)]
            x = wires.divide(own.tolist(), self.solver.messenger_wire_element_m)
            made = self.points(STITCH, x, self.system.messenger_stagger)
            made[[0, -1]] = messenger.points[[messenger.row(first), messenger.row(last)]]
            stitch = Chain(made, wire)
            # A hinge as in a saddle: a dropper bends the wire by 40 milliradians within 6 cm.
            stitch.hinges = [stitch.row(x) for x in own[1:-1]]
            found.append(stitch)
        return found

    def bridles(self, contact: Chain) -> list[Chain]:
        """Hung in the middle, where they turn as in a saddle; ends on the contact wire."""
        wire, found = self.line.bridle, []
        if wire is None:
            return []
        for support, (first, last) in zip(
            self.places.supports[1:-1], self.places.bridles, strict=True
        ):
            x = wires.divide([first, support, last], self.solver.messenger_wire_element_m)
            made = self.points(BRIDLE, x, self.system.contact_stagger)
            made[[0, -1]] = contact.points[[contact.row(first), contact.row(last)]]
            bridle = Chain(made, wire)
            bridle.hinges = [bridle.row(support)]
            found.append(bridle)
        return found


def _relieved(wire: TensionedWire, by: TensionedWire) -> TensionedWire:
    return wire.model_copy(update={"tension": wire.tension - by.tension})
