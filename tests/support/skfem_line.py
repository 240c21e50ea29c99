"""A line by scikit-fem: wires cut to length, droppers, springs, fixed ends; Newton's method.

Stiffness, masses and gravity come from the model files. From Arcless come the division into
elements and what its design says of lengths: of wires and droppers, and the rests of the springs.
"""

from typing import Any

import numpy as np
from scipy.sparse import coo_matrix, csc_matrix
from scipy.sparse.linalg import eigsh, splu

from arcless.equilibrium.equilibrium import Equilibrium
from arcless.model import Scenario
from tests.support.skfem_wires import Array, Wire

X, Z = 0, 1
MOST_ROUNDS = 30


class Line:
    """Unknowns of all wires; each element of Arcless is divided into `parts`."""

    def __init__(self, scenario: Scenario, cut: Equilibrium, parts: int = 1) -> None:
        self.scenario, self.cut, self.parts = scenario, cut, parts
        self.wires: list[Wire] = []
        self.numbers: list[Array] = []
        self.at: dict[int, tuple[int, int]] = {}
        self.start: list[float] = []
        for name in ("contact_wire", "messenger_wire"):
            self._wire(name)
        self.size = len(self.start)
        mesh = cut.mesh
        self.fixed = {self.at[int(node)][int(c)] for node, c in mesh.parts["fixed"]}
        self.free = np.array(sorted(set(range(self.size)) - self.fixed))
        self.springs = self._springs()
        self.droppers = [
            (*self.at[d.nodes[0]], *self.at[d.nodes[1]], cut.arrays["link_rest_length"][d.link])
            for d in mesh.droppers
        ]
        self.weight = np.zeros(self.size)
        for wire, numbers in zip(self.wires, self.numbers, strict=True):
            np.add.at(self.weight, numbers, wire.weight(scenario.solver.gravity))

    def _wire(self, name: str) -> None:
        """Cut a wire at its hinges; number its pieces."""
        mesh, kind = self.cut.mesh, getattr(self.scenario.line, name)
        piece: list[int] = []
        slopes = mesh.parts["wires"]["slope_nodes"]
        for row in mesh.wire_rows[name]:
            if piece and slopes[piece[-1], 1] != slopes[row, 0]:  # another slope: a hinge
                self._piece(piece, kind)
                piece = []
            piece.append(row)
        self._piece(piece, kind)

    def _piece(self, rows: list[int], kind: Any) -> None:
        mesh, parts = self.cut.mesh, self.parts
        lengths = self.cut.arrays["wire_rest_length"][rows]
        joints = np.concatenate([[0.0], np.cumsum(lengths)])
        fine = np.interp(np.arange(len(rows) * parts + 1) / parts, range(len(joints)), joints)
        wire = Wire(fine, kind.axial_stiffness, kind.bending_stiffness, kind.mass)
        table = mesh.parts["wires"]["nodes"]
        nodes = [int(table[rows[0], 0]), *(int(node) for node in table[rows, 1])]
        drawn = [np.interp(fine, joints, mesh.positions[nodes, c]) for c in (X, Z)]
        numbers = np.full(2 * wire.size, -1)
        for node, s in zip(nodes, joints, strict=True):
            for c in (X, Z):
                if node in self.at:  # hung on the piece before
                    numbers[c * wire.size + wire.unknown(s)] = self.at[node][c]
        new = numbers < 0
        numbers[new] = len(self.start) + np.arange(np.count_nonzero(new))
        guess = np.zeros(2 * wire.size)
        for c in (X, Z):
            for s, value in zip(fine, drawn[c], strict=True):
                guess[c * wire.size + wire.unknown(s)] = value
                guess[c * wire.size + wire.unknown(s, slope=True)] = 1.0 - c
        self.start += guess[new].tolist()
        for node, s in zip(nodes, joints, strict=True):
            one = wire.unknown(s)
            self.at.setdefault(node, (int(numbers[one]), int(numbers[wire.size + one])))
        self.wires.append(wire)
        self.numbers.append(numbers)

    def _springs(self) -> list[tuple[int, float, float]]:
        line, mesh = self.scenario.line, self.cut.mesh
        on_contact, made = set(mesh.contact_nodes), []
        for row, (node, component) in enumerate(mesh.parts["springs"][["node", "component"]]):
            part = line.steady_arm if int(node) in on_contact else line.support
            stiffness = part.longitudinal_stiffness if component == X else part.vertical_stiffness
            unknown = self.at[int(node)][int(component)]
            made.append((unknown, stiffness, self.cut.arrays["spring_rest"][row]))
        return made

    def terms(self, q: Array) -> tuple[Array, Any]:
        """Forces out of balance, and the stiffness."""
        force, entries = -self.weight.copy(), []
        for wire, numbers in zip(self.wires, self.numbers, strict=True):
            inner, matrix = wire.terms(q[numbers])
            np.add.at(force, numbers, inner)
            block = matrix.tocoo()
            entries.append((numbers[block.row], numbers[block.col], block.data))
        for unknown, stiffness, rest in self.springs:
            force[unknown] += stiffness * (q[unknown] - rest)
            entries.append(([unknown], [unknown], [stiffness]))
        for *unknowns, rest in self.droppers:
            inner, matrix = self._dropper(q[unknowns], rest)
            np.add.at(force, unknowns, inner)
            entries.append((np.repeat(unknowns, 4), np.tile(unknowns, 4), matrix.ravel()))
        rows, columns, data = (np.concatenate(part) for part in zip(*entries, strict=True))
        return force, csc_matrix(coo_matrix((data, (rows, columns)), (self.size, self.size)))

    def _dropper(self, ends: Array, rest: float) -> tuple[Array, Array]:
        along = ends[:2] - ends[2:]
        length = float(np.hypot(*along))
        n, pull = along / length, self.scenario.line.dropper.stiffness * (length - rest)
        block = self.scenario.line.dropper.stiffness * np.outer(n, n)
        block += pull / length * (np.eye(2) - np.outer(n, n))
        return pull * np.concatenate([n, -n]), np.block([[block, -block], [-block, block]])

    def settle(self) -> Array:
        """Find the equilibrium, from wires as drawn."""
        q = np.array(self.start)
        for _ in range(MOST_ROUNDS):
            force, stiffness = self.terms(q)
            move = splu(stiffness[self.free][:, self.free]).solve(force[self.free])
            q[self.free] -= move
            if np.abs(move).max() < 1e-12:
                return q
        raise AssertionError("Newton's method did not end")

    def dropper_forces(self, q: Array) -> Array:
        """Tension of each dropper in N."""
        found = [np.hypot(q[a] - q[c], q[b] - q[d]) - rest for a, b, c, d, rest in self.droppers]
        return self.scenario.line.dropper.stiffness * np.array(found)

    def masses(self) -> Any:
        """Mass matrix."""
        entries = []
        for wire, numbers in zip(self.wires, self.numbers, strict=True):
            block = wire.masses().tocoo()
            entries.append((numbers[block.row], numbers[block.col], block.data))
        rows, columns, data = (np.concatenate(part) for part in zip(*entries, strict=True))
        return csc_matrix(coo_matrix((data, (rows, columns)), (self.size, self.size)))

    def frequencies(self, q: Array, count: int) -> Array:
        """Lowest natural frequencies in Hz."""
        _, stiffness = self.terms(q)
        inner = np.ix_(self.free, self.free)
        squares = eigsh(
            stiffness[inner], k=count, M=self.masses()[inner], sigma=0.0, return_eigenvectors=False
        )
        return np.sqrt(np.sort(squares)) / (2.0 * np.pi)
