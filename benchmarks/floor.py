"""What a step has to do at least: operations, bytes, and the chain of what waits for what.

Counted for one step of the whole line with the equation of docs/theory/dynamics.md, from the nodes,
the blocks of the factor below its diagonal and the entries of the mass matrix; see
docs/performance.md. D unknowns a node, numbers of 8 bytes.
"""

from dataclasses import dataclass
from itertools import product

import numpy as np

from arcless.equilibrium.equilibrium import Equilibrium

NUMBER, INDEX = 8, 8
# Vectors that pass the processor in a step, docs/performance.md: the product with M has 2, the
# substitutions 5, what is subtracted from them 3, the new state 9.
VECTORS = 19
# New u, v, a and the two vectors the next step starts from, and one subtraction.
NEW_STATE = 22


@dataclass(frozen=True)
class Floor:
    """Work of a step."""

    nodes: int
    unknowns: int
    operations: int
    matrices: int
    vectors: int
    chain: int

    @property
    def bytes(self) -> int:
        """Bytes that pass between the processor and its caches."""
        return self.matrices + self.vectors


def mass_entries(found: Equilibrium) -> int:
    """Pairs of nodes that the mass matrix couples, both ways, and each node with itself."""
    pairs = {(node, node) for node in range(len(found.mesh.positions))}
    wires = found.mesh.parts["wires"]
    for row in np.hstack([wires["nodes"], wires["slope_nodes"]]).tolist():
        pairs.update(product(row, row))
    return len(pairs)


def floor(nodes: int, blocks: int, entries: int, width: int) -> Floor:
    """Count for `width` unknowns a node."""
    square, unknowns = width * width, width * nodes
    block = NUMBER * square + INDEX
    return Floor(
        nodes,
        unknowns,
        operations=4 * width * entries + 2 * square * (2 * blocks + nodes) + NEW_STATE * unknowns,
        matrices=2 * blocks * block
        + nodes * NUMBER * square
        + entries * (2 * NUMBER * width + INDEX),
        vectors=VECTORS * NUMBER * unknowns,
        # Nodes are eliminated from both ends: two chains run side by side, forwards and backwards.
        chain=nodes,
    )
