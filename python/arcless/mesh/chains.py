"""Nodes of each wire, and their numbers in the mesh."""

from dataclasses import dataclass, field

import numpy as np

from arcless.mesh import wires
from arcless.mesh.shapes import Guess, stagger_guess
from arcless.mesh.types import Floats
from arcless.mesh.wires import AUXILIARY, CONTACT, MESSENGER, STITCH
from arcless.model.components import TensionedWire
from arcless.model.line import Line
from arcless.model.settings import Solver


@dataclass
class Chain:
    """Nodes of one wire: positions (n × 3) and their numbers in the mesh.

    Attributes
    ----------
    wire : what it is made of
    relieved : the same with the tension that stitch wires leave it, between their clamps
    hinges : rows of the nodes at which the wire turns freely
    leaving, arriving : rows of nodes whose slope is held by another node, for the element behind
        and for the one before, and that node's number
    """

    points: Floats
    wire: TensionedWire
    relieved: TensionedWire | None = None
    clamps: list[tuple[float, float]] = field(default_factory=list)
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
        if self.relieved is None:
            return [self.wire] * (len(self.points) - 1)
        middles = 0.5 * (self.points[1:, 0] + self.points[:-1, 0])
        left, right = np.asarray(self.clamps).T
        which = np.clip(np.searchsorted(left, middles) - 1, 0, len(left) - 1)
        between = (left[which] < middles) & (middles < right[which])
        return [self.relieved if inside else self.wire for inside in between]


@dataclass
class Chains:
    """All wires of a line; the nodes' positions and slopes in the order of the mesh."""

    contact: Chain
    messenger: Chain
    auxiliary: Chain | None
    stitches: list[Chain]
    positions: Floats = field(default_factory=lambda: np.empty((0, 3)))
    slopes: Floats = field(default_factory=lambda: np.empty((0, 3)))

    def of(self, wire: str, x: float) -> Chain:
        """Return the chain of a wire; of stitch wires, the one at a place."""
        if wire == STITCH:
            clamps = self.messenger.clamps
            return self.stitches[int(np.searchsorted([left for left, _ in clamps], x)) - 1]
        found = {CONTACT: self.contact, MESSENGER: self.messenger, AUXILIARY: self.auxiliary}[wire]
        assert found is not None
        return found


def make_chains(line: Line, solver: Solver, places: wires.Stations) -> Chains:
    """Divide all wires of a line and number their nodes along the track."""
    chains = _divided(line, solver, places)
    _number(chains, lumped=solver.wire_model == "lumped")
    return chains


def _divided(line: Line, solver: Solver, places: wires.Stations) -> Chains:
    guess, geometry = Guess(line, places, solver.gravity), line.geometry

    def points(wire: str, x: Floats, stagger: tuple[float, ...]) -> Floats:
        y = stagger_guess(stagger, places.supports, x)
        return np.column_stack([x, y, guess.of(wire, x)])

    longest = solver.messenger_wire_element
    x = wires.divide(places.along(CONTACT), solver.contact_wire_element)
    contact = Chain(points(CONTACT, x, geometry.stagger_contact_wire), line.contact_wire)
    x = wires.divide(places.along(MESSENGER), longest)
    above = points(MESSENGER, x, geometry.stagger_messenger_wire)
    messenger = Chain(above, line.messenger_wire, clamps=places.clamps)
    # The saddle of a support follows the wire, which bends there without lifting: no moment is
    # carried. A slope continuous over the support would need elements shorter than √(EI/T).
    turning = [*places.supports[1:-1], *(x for pair in places.clamps for x in pair)]
    messenger.hinges = sorted(messenger.row(x) for x in turning)
    auxiliary, stitches = None, []
    if line.auxiliary_wire is not None:
        x = wires.divide(places.along(AUXILIARY), longest)
        stagger = geometry.stagger_auxiliary_wire or geometry.stagger_contact_wire
        auxiliary = Chain(points(AUXILIARY, x, stagger), line.auxiliary_wire)
    if line.stitch_wire is not None:
        left = line.messenger_wire.tension - line.stitch_wire.tension
        messenger.relieved = line.messenger_wire.model_copy(update={"tension": left})
        hung = np.array(places.along(STITCH))
        for first, last in places.clamps:
            own = hung[(hung >= first) & (hung <= last)]
            x = wires.divide(own.tolist(), longest)
            made = points(STITCH, x, geometry.stagger_messenger_wire)
            made[[0, -1]] = messenger.points[[messenger.row(first), messenger.row(last)]]
            stitch = Chain(made, line.stitch_wire)
            # As in a saddle, and more so: a dropper bends it by 40 milliradians within 6 cm.
            stitch.hinges = [stitch.row(x) for x in own[1:-1]]
            stitches.append(stitch)
    return Chains(contact, messenger, auxiliary, stitches)


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


def _number(chains: Chains, *, lumped: bool) -> None:
    """Give numbers to all nodes along the track; messenger before contact wire."""
    pool, messenger = _Pool(), chains.messenger
    tangents = _slopes(messenger, lumped=lumped)
    messenger.nodes = pool.add(messenger.points, tangents)
    if not lumped:
        # A chain of point masses has no slopes to be told apart at a hinge.
        far = pool.add(messenger.points[messenger.hinges], tangents[messenger.hinges])
        messenger.leaving = dict(zip(messenger.hinges, far, strict=True))
    for stitch in chains.stitches:
        _number_stitch(pool, stitch, messenger, lumped=lumped)
    for chain in filter(None, (chains.auxiliary, chains.contact)):
        chain.nodes = pool.add(chain.points, _slopes(chain, lumped=lumped))
    points = np.vstack(pool.points)
    order = np.argsort(points[:, 0], kind="stable")
    rank = np.empty(len(order), dtype=np.int64)
    rank[order] = np.arange(len(order))
    for chain in filter(None, (messenger, chains.auxiliary, chains.contact, *chains.stitches)):
        chain.nodes = [int(rank[n]) for n in chain.nodes]
        chain.leaving = {row: int(rank[n]) for row, n in chain.leaving.items()}
        chain.arriving = {row: int(rank[n]) for row, n in chain.arriving.items()}
    chains.positions, chains.slopes = points[order], np.vstack(pool.tangents)[order]


def _number_stitch(pool: _Pool, stitch: Chain, messenger: Chain, *, lumped: bool) -> None:
    """Its ends are nodes of the messenger wire, at which it turns freely, as at its droppers."""
    tangents, last = _slopes(stitch, lumped=lumped), len(stitch.points) - 1
    ends = [messenger.at(float(x)) for x in stitch.points[[0, -1], 0]]
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
