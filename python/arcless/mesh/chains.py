"""Nodes of each wire, and their numbers in the mesh."""

from dataclasses import dataclass, field

import numpy as np

from arcless.mesh import wires
from arcless.mesh.names import AUXILIARY, BRIDLE, MESSENGER, STITCH
from arcless.mesh.on_wires import inserted, inserts
from arcless.mesh.shapes import Guess
from arcless.mesh.types import Floats
from arcless.model.components import TensionedWire
from arcless.model.line import Line
from arcless.model.on_wires import Insert
from arcless.model.settings import Solver


@dataclass
class Chain:
    """Nodes of one wire: positions (n × 3) and their numbers in the mesh.

    Attributes
    ----------
    wire : what it is made of
    relieved : the same with the tension that stitch wires (bridles) leave it, between their clamps
    inserts : pieces that are made of something else
    hinges : rows of the nodes at which the wire turns freely
    leaving, arriving : rows of nodes whose slope is held by another node, for the element behind
        and for the one before, and that node's number
    """

    points: Floats
    wire: TensionedWire
    relieved: TensionedWire | None = None
    clamps: list[tuple[float, float]] = field(default_factory=list)
    inserts: list[Insert] = field(default_factory=list)
    hinges: list[int] = field(default_factory=list)
    nodes: list[int] = field(default_factory=list)
    leaving: dict[int, int] = field(default_factory=dict)
    arriving: dict[int, int] = field(default_factory=dict)

    def row(self, x: float) -> int:
        """Row of the node that stands at a station."""
        return int(np.searchsorted(self.points[:, 0], x - wires.SAME_PLACE))

    def at(self, x: float) -> int:
        """Return the number of the node that stands at a station."""
        return self.nodes[self.row(x)]

    def sections(self) -> list[TensionedWire]:
        """Return the wire of each element, with its tension."""
        middles = 0.5 * (self.points[1:, 0] + self.points[:-1, 0])
        found = self._tensioned(middles)
        for insert in self.inserts:
            first, last = insert.ends
            for row in np.flatnonzero((first < middles) & (middles < last)):
                found[row] = inserted(found[row], insert)
        return found

    def _tensioned(self, middles: Floats) -> list[TensionedWire]:
        if self.relieved is None:
            return [self.wire] * len(middles)
        left, right = np.asarray(self.clamps).T
        which = np.clip(np.searchsorted(left, middles) - 1, 0, len(left) - 1)
        between = (left[which] < middles) & (middles < right[which])
        return [self.relieved if inside else self.wire for inside in between]


@dataclass
class Chains:
    """All wires of a system; contact wires side by side are several chains."""

    contacts: dict[str, Chain]
    messenger: Chain | None
    auxiliary: Chain | None
    stitches: list[Chain]
    bridles: list[Chain]

    def of(self, wire: str, x: float) -> Chain:
        """Return the chain of a wire; of stitch wires, the one at a place."""
        if wire in {STITCH, BRIDLE}:
            pieces = self.stitches if wire == STITCH else self.bridles
            return pieces[int(np.searchsorted([piece.points[0, 0] for piece in pieces], x)) - 1]
        chain = {**self.contacts, MESSENGER: self.messenger, AUXILIARY: self.auxiliary}[wire]
        assert chain is not None
        return chain

    def all(self) -> list[Chain]:
        """Return all chains."""
        return [
            *filter(None, (self.messenger, self.auxiliary)),
            *self.contacts.values(),
            *self.stitches,
            *self.bridles,
        ]


@dataclass(frozen=True)
class Nodes:
    """Positions and slopes of all nodes, in the order of the mesh."""

    positions: Floats
    slopes: Floats


def make_chains(
    line: Line, solver: Solver, places: list[wires.Stations]
) -> tuple[list[Chains], Nodes]:
    """Divide the wires of all systems and number their nodes along the track."""
    systems = [_Division(line, solver, own).chains() for own in places]
    return systems, _number(systems, lumped=solver.wire_model == "lumped")


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
        x = wires.divide(self.places.along(name), self.solver.contact_wire_element)
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
        x = wires.divide(places.along(MESSENGER), self.solver.messenger_wire_element)
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
        x = wires.divide(self.places.along(AUXILIARY), self.solver.messenger_wire_element)
        own = inserts(self.line, self.system, AUXILIARY)
        return Chain(self.points(AUXILIARY, x, self.system.auxiliary_stagger), wire, inserts=own)

    def stitches(self, messenger: Chain) -> list[Chain]:
        wire, found = self.line.stitch_wire, []
        if wire is None:
            return []
        hung = np.array(self.places.along(STITCH))
        for first, last in self.places.clamps:
            own = hung[(hung >= first) & (hung <= last)]
            x = wires.divide(own.tolist(), self.solver.messenger_wire_element)
            made = self.points(STITCH, x, self.system.messenger_stagger)
            made[[0, -1]] = messenger.points[[messenger.row(first), messenger.row(last)]]
            stitch = Chain(made, wire)
            # As in a saddle, and more so: a dropper bends it by 40 milliradians within 6 cm.
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
            x = wires.divide([first, support, last], self.solver.messenger_wire_element)
            made = self.points(BRIDLE, x, self.system.contact_stagger)
            made[[0, -1]] = contact.points[[contact.row(first), contact.row(last)]]
            bridle = Chain(made, wire)
            bridle.hinges = [bridle.row(support)]
            found.append(bridle)
        return found


def _relieved(wire: TensionedWire, by: TensionedWire) -> TensionedWire:
    return wire.model_copy(update={"tension": wire.tension - by.tension})


class _Pool:
    """Nodes in the order they are made; sorted along the track in the end."""

    def __init__(self) -> None:
        self.points: list[Floats] = []
        self.tangents: list[Floats] = []
        self.count = 0

    def add(self, points: Floats, tangents: Floats) -> list[int]:
        self.points.append(points)
        self.tangents.append(tangents)
        self.count += len(points)
        return list(range(self.count - len(points), self.count))


def _number(systems: list[Chains], *, lumped: bool) -> Nodes:
    """Give numbers to all nodes along the track; messenger before contact wire."""
    pool = _Pool()
    for chains in systems:
        _fill(pool, chains, lumped=lumped)
    points = np.vstack(pool.points)
    order = np.argsort(points[:, 0], kind="stable")
    rank = np.empty(len(order), dtype=np.int64)
    rank[order] = np.arange(len(order))
    for chain in (chain for chains in systems for chain in chains.all()):
        chain.nodes = [int(rank[n]) for n in chain.nodes]
        chain.leaving = {row: int(rank[n]) for row, n in chain.leaving.items()}
        chain.arriving = {row: int(rank[n]) for row, n in chain.arriving.items()}
    return Nodes(points[order], np.vstack(pool.tangents)[order])


def _fill(pool: _Pool, chains: Chains, *, lumped: bool) -> None:
    """Add the nodes of one system to the pool."""
    if chains.messenger is not None:
        _fill_messenger(pool, chains.messenger, chains.stitches, lumped=lumped)
    for chain in (*filter(None, (chains.auxiliary,)), *chains.contacts.values()):
        chain.nodes = pool.add(chain.points, _slopes(chain, lumped=lumped))
    for bridle in chains.bridles:
        (contact,) = chains.contacts.values()
        _number_stitch(pool, bridle, contact, lumped=lumped)


def _fill_messenger(pool: _Pool, messenger: Chain, stitches: list[Chain], *, lumped: bool) -> None:
    tangents = _slopes(messenger, lumped=lumped)
    messenger.nodes = pool.add(messenger.points, tangents)
    if not lumped:
        # A chain of point masses has no slopes to be told apart at a hinge.
        far = pool.add(messenger.points[messenger.hinges], tangents[messenger.hinges])
        messenger.leaving = dict(zip(messenger.hinges, far, strict=True))
    for stitch in stitches:
        _number_stitch(pool, stitch, messenger, lumped=lumped)


def _number_stitch(pool: _Pool, stitch: Chain, carrier: Chain, *, lumped: bool) -> None:
    """Its ends are nodes of another wire, at which it turns freely, as at its droppers."""
    tangents, last = _slopes(stitch, lumped=lumped), len(stitch.points) - 1
    ends = [carrier.at(float(x)) for x in stitch.points[[0, -1], 0]]
    stitch.nodes = [ends[0], *pool.add(stitch.points[1:-1], tangents[1:-1]), ends[1]]
    if not lumped:
        turning = [0, *stitch.hinges, last]
        own = pool.add(stitch.points[turning], tangents[turning])
        stitch.leaving = dict(zip(turning[:-1], own[:-1], strict=True))
        stitch.arriving = {last: own[-1]}


def _slopes(chain: Chain, *, lumped: bool) -> Floats:
    if lumped:
        return np.zeros_like(chain.points)
    return wires.slopes(chain.points, wires.stretch(chain.wire))
