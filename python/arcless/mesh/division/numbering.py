"""Numbers of the nodes of all wires, system by system along the track."""

from dataclasses import dataclass

import numpy as np

from arcless.mesh.division import wires
from arcless.mesh.division.chain import Chain, Chains
from arcless.mesh.tables.mesh_types import Floats


@dataclass(frozen=True)
class Nodes:
    """Positions and slopes of all nodes, in the order of the mesh."""

    positions: Floats
    slopes: Floats


class _Pool:
    """Nodes in the order they are made; sorted in the end."""

    def __init__(self) -> None:
        self.points: list[Floats] = []
        self.tangents: list[Floats] = []
        self.count = 0

    def add(self, points: Floats, tangents: Floats) -> list[int]:
        self.points.append(points)
        self.tangents.append(tangents)
        self.count += len(points)
        return list(range(self.count - len(points), self.count))


def number(systems: list[Chains], *, lumped: bool) -> Nodes:
    """Give numbers to all nodes: system by system along the track, messenger before contact wire.

    Nothing couples two systems, so the core takes each as an island and steps those that move.
    """
    pool, sizes = _Pool(), []
    for chains in systems:
        before = pool.count
        _fill(pool, chains, lumped=lumped)
        sizes.append(pool.count - before)
    points = np.vstack(pool.points)
    order = np.lexsort((points[:, 0], np.repeat(np.arange(len(sizes)), sizes)))
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
