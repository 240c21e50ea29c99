"""Matrices of a planar line and a pantograph for `plain_scipy`, assembled with NumPy.

Wires: docs/theory/wires.md; dampings: docs/theory/dynamics.md. A node has four unknowns: x, z and
their derivatives along the wire. An unknown that cannot move keeps its place with a one on the
diagonal of K.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.sparse import block_diag, coo_matrix, csr_matrix, diags, hstack

from arcless.equilibrium.equilibrium import Equilibrium
from arcless.model import Scenario

Array = Any
X, Z, SLOPE, PER_NODE = 0, 1, 2, 4
POINTS, WEIGHTS = np.polynomial.legendre.leggauss(5)


def shape(xi: float, length: Any, derivative: int = 0) -> Array:
    """Cubic Hermite functions, or a derivative of them, at ξ; rows for r₁, r₁′, r₂, r₂′."""
    x2, x3 = xi * xi, xi * xi * xi
    if derivative == 0:
        of_ends, of_slopes = 1 - 3 * x2 + 2 * x3, (xi - 2 * x2 + x3, x3 - x2)
        return np.array([of_ends + 0 * length, length * of_slopes[0],
                         1 - of_ends + 0 * length, length * of_slopes[1]])  # fmt: skip
    if derivative == 1:
        of_ends, of_slopes = 6 * (x2 - xi) / length, (1 - 4 * xi + 3 * x2, 3 * x2 - 2 * xi)
        same = 0 * length
        return np.array([of_ends, of_slopes[0] + same, -of_ends, of_slopes[1] + same])
    of_ends = (12 * xi - 6) / length**2
    return np.array([of_ends, (6 * xi - 4) / length, -of_ends, (6 * xi - 2) / length])


def wire_tangent(e: Array, length: Array, axial: Array, bending: Array) -> Array:
    """Second derivative of ∫ ½ EA ε² + ½ EI κ² ds for coordinates e (elements × 4 × 2)."""
    k, one = np.zeros((len(e), 4, 2, 4, 2)), np.eye(2)
    pull, half = axial[:, None, None], 0.5 * bending[:, None, None]
    for point, weight in zip(0.5 * (POINTS + 1.0), 0.5 * WEIGHTS, strict=True):
        d, dd = shape(point, length, 1), shape(point, length, 2)
        a, b = (np.einsum("kn,nkc->nc", w, e) for w in (d, dd))
        s, t, w = ((p * q).sum(axis=1)[:, None, None] for p, q in ((a, a), (b, b), (a, b)))
        aa, ab, bb = (np.einsum("np,nq->npq", p, q) for p, q in ((a, a), (a, b), (b, b)))
        ba = ab.transpose(0, 2, 1)
        # κ² = t/s² − w²/s³: its second derivatives by r′ twice, r″ twice, and both.
        slopes = (6 * w**2 / s**4 - 4 * t / s**3) * one
        slopes += (24 * t / s**4 - 48 * w**2 / s**5) * aa + 12 * w / s**4 * (ab + ba)
        slopes = pull * (0.5 * (s - 1.0) * one + aa) + half * (slopes - 2 / s**3 * bb)
        bends = half * (2 / s**2 * one - 2 / s**3 * aa)
        both = -2 * w / s**3 * one + 12 * w / s**4 * aa - 8 / s**3 * ab - 2 / s**3 * ba
        other = half * both.transpose(0, 2, 1)
        terms = (d, slopes, d), (dd, bends, dd), (d, half * both, dd), (dd, other, d)
        for left, middle, right in terms:
            k += np.einsum("n,in,npq,jn->nipjq", weight * length, left, middle, right)
    return k.reshape(len(e), 8, 8)


def wire_mass(length: Array, mass: Array) -> Array:
    """Consistent mass of cubic elements (Przemieniecki 1968)."""
    h, one = length, np.ones_like(length)
    rows = [
        [156 * one, 22 * h, 54 * one, -13 * h],
        [22 * h, 4 * h**2, 13 * h, -3 * h**2],
        [54 * one, 13 * h, 156 * one, -22 * h],
        [-13 * h, -3 * h**2, -22 * h, 4 * h**2],
    ]
    whole = np.einsum("n,ijn,pq->nipjq", mass * length / 420.0, np.array(rows), np.eye(2))
    return whole.reshape(len(length), 8, 8)


def chain(values: list[float]) -> Array:
    """Springs or dampers below masses on top of each other."""
    matrix = np.zeros((len(values) + 1, len(values) + 1))
    for i, value in enumerate(values):
        matrix[i : i + 2, i : i + 2] += value * np.array([[1, -1], [-1, 1]])
    return matrix[1:, 1:]


@dataclass(frozen=True)
class Droppers:
    """Stiffness in N/m and damping in N·s/m along each dropper, and its tension at rest in N."""

    stiffness: Array
    viscosity: Array
    tension: Array


class Matrices:
    """M, C, K of line and pantograph; G of the droppers; the contact wire at rest."""

    def __init__(self, scenario: Scenario, found: Equilibrium) -> None:
        self.scenario, self.found, self.mesh = scenario, found, found.mesh
        self.nodes = len(self.mesh.positions)
        self.at = found.arrays["positions"].reshape(-1, 2)
        slopes = found.arrays["slopes"].reshape(-1, 2)
        wires = self.mesh.parts["wires"]
        (a, b), (slope_a, slope_b) = wires["nodes"].T, wires["slope_nodes"].T
        corners = [self.at[a], slopes[slope_a], self.at[b], slopes[slope_b]]
        self.coordinates = np.stack(corners, axis=1)
        owners = np.stack([a, slope_a, b, slope_b], axis=1)
        first = PER_NODE * owners + np.array([0, SLOPE, 0, SLOPE])
        self.unknowns = (first[:, :, None] + np.arange(2)).reshape(-1, 8)
        self._line(wires)
        self._pantograph()
        self._contact_wire()

    def _sum(self, places: Array, blocks: Array) -> Any:
        """Assemble blocks (count × n × n) at unknowns (count × n)."""
        n, size = places.shape[1], PER_NODE * self.nodes
        rows, columns = np.repeat(places, n, axis=1), np.tile(places, (1, n))
        entries = (blocks.ravel(), (rows.ravel(), columns.ravel()))
        return coo_matrix(entries, shape=(size, size)).tocsr()

    def _line(self, wires: Array) -> None:
        length = self.found.arrays["wire_rest_length"]
        alpha, beta = (wires[name][:, None, None] for name in ("alpha", "beta"))
        rigid = wires["axial_stiffness"], wires["bending_stiffness"]
        stiffness = wire_tangent(self.coordinates, length, *rigid)
        mass = wire_mass(length, wires["mass"])
        self.mass = self._sum(self.unknowns, mass)
        self.stiffness = self._sum(self.unknowns, stiffness)
        self.damping = self._sum(self.unknowns, alpha * mass + beta * stiffness)
        masses, springs = self.mesh.parts["masses"], self.mesh.parts["springs"]
        self._add_masses(masses["node"], masses["mass"], masses["alpha"])
        place = (PER_NODE * springs["node"] + springs["component"])[:, None]
        self.stiffness += self._sum(place, springs["stiffness"][:, None, None])
        self.damping += self._sum(place, springs["viscosity"][:, None, None])
        self._droppers()

    def _add_masses(self, nodes: Array, mass: Array, alpha: Array) -> None:
        places = PER_NODE * nodes[:, None] + np.array([X, Z])
        blocks = mass[:, None, None] * np.eye(2)
        self.mass += self._sum(places, blocks)
        self.damping += self._sum(places, alpha[:, None, None] * blocks)

    def _droppers(self) -> None:
        links = self.mesh.parts["links"]
        upper, lower = links["nodes"].T
        k, c, mass = links["stiffness"], links["viscosity"], links["mass"]
        alpha, beta = links["alpha"], links["beta"]
        rest = self.found.arrays["link_rest_length"]
        along = self.at[lower] - self.at[upper]
        length = np.hypot(*along.T)
        n, tension = along / length[:, None], k * (length - rest)
        for node in (upper, lower):
            self._add_masses(node, 0.5 * mass * length, alpha)
        nn = np.einsum("np,nq->npq", n, n)
        swings = (tension / length)[:, None, None] * (np.eye(2) - nn)
        spring = k[:, None, None] * nn + swings
        damper = beta[:, None, None] * spring + c[:, None, None] * nn
        places = PER_NODE * np.stack([upper, upper, lower, lower], axis=1) + [X, Z, X, Z]
        pair = np.array([[1, -1], [-1, 1]])
        self.stiffness += self._sum(places, np.kron(pair, spring))
        self.damping += self._sum(places, np.kron(pair, damper))
        self.droppers = Droppers(k, c + beta * k, tension)
        rows = np.repeat(np.arange(len(k)), 4)
        entries = (np.concatenate([-n, n], axis=1).ravel(), (rows, places.ravel()))
        self.elongation = csr_matrix(entries, shape=(len(k), PER_NODE * self.nodes))

    def _pantograph(self) -> None:
        """Put the pantograph behind the line, and take out what cannot move."""
        parts = self.scenario.pantographs[0].model.masses
        fixed = self.mesh.parts["fixed"]
        held = self.stiffness.diagonal() == 0.0  # of nodes that hold a slope only
        held[PER_NODE * fixed["node"] + fixed["component"]] = True
        self.held = np.concatenate([held, np.zeros(len(parts), dtype=bool)])
        self.size = len(self.held)
        own = (
            np.diag([part.mass for part in parts]),
            chain([part.damping for part in parts]), chain([part.stiffness for part in parts]),
        )  # fmt: skip
        free = diags((~self.held).astype(float))
        whole = zip((self.mass, self.damping, self.stiffness), own, strict=True)
        mass, damping, stiffness = ((free @ block_diag(pair) @ free).tocsr() for pair in whole)
        self.matrices = mass, damping, (stiffness + diags(self.held.astype(float))).tocsr()
        none = csr_matrix((self.elongation.shape[0], len(parts)))
        self.g = (hstack([self.elongation, none]) @ free).tocsr()

    def _contact_wire(self) -> None:
        """Elements in the order of the track: ends, coordinates, unknowns of the height."""
        rows = self.mesh.lanes[0]
        self.ends = self.coordinates[rows]
        self.left, self.right = self.ends[:, 0, X], self.ends[:, 2, X]
        self.length = self.found.arrays["wire_rest_length"][rows]
        self.heights = self.unknowns[rows][:, 1::2]
