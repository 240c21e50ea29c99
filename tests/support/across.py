"""A second program: wires that move up and down only, under tensions that stay.

Independent of the product but for the numbers of the model file: straight wires, so no sag but
that of a contact wire between its droppers, cubic beams, the trapezoidal rule, and slack droppers
found by trial.

    μ ẅ + α μ ẇ = H w″ − EI w⁗ + β ∂/∂t (…) + forces of droppers, supports, contact
"""

from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_matrix, csc_matrix
from scipy.sparse.linalg import splu

from arcless.model import Scenario
from arcless.model.line.parts.components import SteadyArmSpring, TensionedWire

Floats = NDArray[np.float64]
# Elements in m: point forces find corners that are rounded over 0.1 m.
CONTACT, MESSENGER = 0.25, 0.5
GRAVITY = 9.81


def element(length: float) -> tuple[Floats, Floats, Floats]:
    """Matrices of mass, tension and bending of a beam, each for a coefficient of one."""
    a = length
    mass = a / 420 * np.array([
        [156, 22 * a, 54, -13 * a], [22 * a, 4 * a * a, 13 * a, -3 * a * a],
        [54, 13 * a, 156, -22 * a], [-13 * a, -3 * a * a, -22 * a, 4 * a * a],
    ])  # fmt: skip
    pull = 1 / (30 * a) * np.array([
        [36, 3 * a, -36, 3 * a], [3 * a, 4 * a * a, -3 * a, -a * a],
        [-36, -3 * a, 36, -3 * a], [3 * a, -a * a, -3 * a, 4 * a * a],
    ])  # fmt: skip
    bend = 1 / a**3 * np.array([
        [12, 6 * a, -12, 6 * a], [6 * a, 4 * a * a, -6 * a, 2 * a * a],
        [-12, -6 * a, 12, -6 * a], [6 * a, 2 * a * a, -6 * a, 4 * a * a],
    ])  # fmt: skip
    return mass, pull, bend


def shape(xi: float, length: float) -> Floats:
    """Cubic shape functions."""
    return np.array([
        1 - 3 * xi**2 + 2 * xi**3, length * (xi - 2 * xi**2 + xi**3),
        3 * xi**2 - 2 * xi**3, length * (xi**3 - xi**2),
    ])  # fmt: skip


@dataclass
class Wire:
    """A wire in elements: unknowns of deflection and slope, from `first` on."""

    x: Floats
    first: int
    hinges: tuple[int, ...]
    rows: list[list[int]] = field(init=False)
    count: int = field(init=False)

    def __post_init__(self) -> None:
        # Behind a hinge an element has a slope of its own, after all others.
        extra = {node: self.first + 2 * len(self.x) + k for k, node in enumerate(self.hinges)}
        at = [self.first + 2 * node for node in range(len(self.x))]
        self.rows = [
            [at[k], extra.get(k, at[k] + 1), at[k + 1], at[k + 1] + 1]
            for k in range(len(self.x) - 1)
        ]
        self.count = 2 * len(self.x) + len(self.hinges)

    def at(self, place: float) -> tuple[list[int], Floats]:
        """Unknowns and shares of a place."""
        k = min(int(np.searchsorted(self.x, place, side="right")) - 1, len(self.x) - 2)
        length = self.x[k + 1] - self.x[k]
        return self.rows[k], shape((place - self.x[k]) / length, length)


def divided(places: list[float], longest: float) -> Floats:
    """Nodes at all places and between them."""
    parts = [
        np.linspace(a, b, int(np.ceil((b - a) / longest - 1e-9)) + 1)[:-1]
        for a, b in pairwise(places)
    ]
    return np.append(np.concatenate(parts), places[-1])


class Line:
    """Matrices of a line of equal kinds of spans, on which nothing leans or pulls along."""

    def __init__(self, scenario: Scenario) -> None:
        line = scenario.line
        assert line.messenger_wire is not None and line.dropper is not None
        spans = line.span_list()
        supports = np.cumsum([0.0, *(span.length for span in spans)]).tolist()
        self.places = [
            start + x
            for start, span in zip(supports, spans, strict=False)
            for x in span.droppers.positions
        ]
        nodes = sorted({*supports, *self.places})
        upper = divided(nodes, MESSENGER)
        inner = supports[1:-1]
        hinges = tuple(int(np.argmin(abs(upper - x))) for x in inner)
        self.contact = Wire(divided(nodes, CONTACT), 0, ())
        self.messenger = Wire(upper, self.contact.count, hinges)
        self.size = self.contact.count + self.messenger.count
        self._parts: dict[str, list[tuple[int, int, float]]] = {k: [] for k in "mck"}
        self._add_wire(self.contact, line.contact_wire)
        self._add_wire(self.messenger, line.messenger_wire)
        arm = line.steady_arm
        assert isinstance(arm, SteadyArmSpring)
        for x in inner:
            self._add("k", [self._row(self.messenger, x)], [[line.support.vertical_stiffness]])
            self._add("k", [self._row(self.contact, x)], [[arm.vertical_stiffness]])
        kind = line.dropper
        self.stiffness = kind.stiffness
        self.viscosity = kind.damping + kind.rayleigh.beta * kind.stiffness
        self.pairs = [
            (self._row(self.messenger, x), self._row(self.contact, x)) for x in self.places
        ]
        bare = self._matrix("k")
        ends = [
            self._row(w, x) for w in (self.contact, self.messenger) for x in supports[:: len(spans)]
        ]
        self.free = np.setdiff1d(np.arange(self.size), ends)
        self.rest, self.tensions = self._at_rest(
            bare, line.contact_wire, inner, arm.vertical_stiffness
        )
        for pair in self.pairs:
            pull = np.array([[1.0, -1.0], [-1.0, 1.0]])
            self._add("k", list(pair), self.stiffness * pull)
            self._add("c", list(pair), self.viscosity * pull)
        self.m, self.c, self.k = (self._matrix(name) for name in "mck")

    def _row(self, wire: Wire, place: float) -> int:
        return wire.first + 2 * int(np.argmin(abs(wire.x - place)))

    def _add(self, kind: str, rows: list[int], values: Any) -> None:
        block = np.asarray(values)
        self._parts[kind] += [
            (i, j, float(block[a, b])) for a, i in enumerate(rows) for b, j in enumerate(rows)
        ]

    def _add_wire(self, wire: Wire, of: TensionedWire) -> None:
        for k, rows in enumerate(wire.rows):
            mass, pull, bend = element(float(wire.x[k + 1] - wire.x[k]))
            mass, stiff = of.mass * mass, of.tension * pull + of.bending_stiffness * bend
            self._add("m", rows, mass)
            self._add("k", rows, stiff)
            self._add("c", rows, of.damping.alpha * mass + of.damping.beta * stiff)

    def _matrix(self, kind: str) -> csc_matrix:
        i, j, v = zip(*self._parts[kind], strict=True)
        return csc_matrix(coo_matrix((v, (i, j)), shape=(self.size, self.size)))

    def _at_rest(
        self, bare: csc_matrix, of: TensionedWire, inner: list[float], arm: float
    ) -> tuple[Floats, Floats]:
        """Shape of the contact wire, level at its droppers, and what these carry, but not arms."""
        wire = self.contact
        weight = np.zeros(self.size)
        for k, rows in enumerate(wire.rows):
            a = wire.x[k + 1] - wire.x[k]
            weight[rows] -= of.mass * GRAVITY * a * np.array([0.5, a / 12, 0.5, -a / 12])
        k = bare.tolil()
        for x in inner:
            row = self._row(wire, x)
            k[row, row] -= arm
        held = [lower for _, lower in self.pairs]
        loose = np.setdiff1d(self.free[self.free < wire.count], held)
        u = np.zeros(self.size)
        k = csc_matrix(k)
        u[loose] = splu(csc_matrix(k[loose][:, loose])).solve(weight[loose])
        return u, np.asarray((k @ u - weight)[held])


def run(scenario: Scenario, step: float, places: Floats) -> Floats:
    """Contact force in N while the only pantograph, of two masses, goes through places in m."""
    line = Line(scenario)
    placed = scenario.pantographs[0]
    base, head = placed.model.masses
    n = line.size
    pan = [n, n + 1]
    m, c, k = (x.tolil() for x in (line.m, line.c, line.k))
    for matrix in (m, c, k):
        matrix.resize((n + 2, n + 2))
    for matrix, lower, upper in (
        (c, base.damping, head.damping), (k, base.stiffness, head.stiffness),
    ):  # fmt: skip
        matrix[n, n], matrix[n + 1, n + 1] = lower + upper, upper
        matrix[n, n + 1] = matrix[n + 1, n] = -upper
    m[n, n], m[n + 1, n + 1] = base.mass, head.mass
    free = np.append(line.free, pan)
    m, c, k = (csc_matrix(csc_matrix(x)[free][:, free]) for x in (m, c, k))
    at = np.full(n + 2, -1)
    at[free] = np.arange(len(free))
    steady = np.zeros(len(free))
    steady[at[n]] = 1.0
    droppers = _Droppers(line, at, step)
    law = scenario.contact.stiffness
    rest = line.rest

    def contact(x: float) -> tuple[Floats, float]:
        rows, shares = line.contact.at(x)
        found = np.zeros(len(free))
        found[at[n + 1]] = 1.0
        for row, share in zip(rows, shares, strict=True):
            if at[row] >= 0:
                found[at[row]] -= share
        return found, float(shares @ rest[rows])

    # At rest with the contact, whose force there is the static one; all droppers are taut.
    g, height = contact(places[0])
    factor = splu(k)
    lifted, column = factor.solve(np.column_stack([steady, g])).T
    wanted = placed.static_force
    # g·(σ lifted − λ column) − height = λ/k for the force λ that is wanted.
    share = (wanted / law + wanted * (g @ column) + height) / (g @ lifted)
    steady *= share
    u = share * lifted - wanted * column
    v, a = np.zeros_like(u), np.zeros_like(u)
    matrix = csc_matrix(4 / step**2 * m + 2 / step * c + k)
    factor = splu(matrix)
    droppers.prepare(factor)
    forces = [law * (g @ u - height)]
    for x in places[1:]:
        g, height = contact(x)
        right = steady + m @ (4 / step**2 * u + 4 / step * v + a) + c @ (2 / step * u + v)
        plain, column = factor.solve(np.column_stack([right, g])).T
        new, force = droppers.settle(plain, column, (g, height, law), (u, v))
        speed = 2 / step * (new - u) - v
        a = 4 / step**2 * (new - u) - 4 / step * v - a
        u, v = new, speed
        forces.append(force)
    return np.array(forces)


class _Droppers:
    """Droppers of which those that would push are released, found by trial."""

    def __init__(self, line: Line, at: Any, step: float) -> None:
        self.upper, self.lower = (np.array(rows) for rows in zip(*line.pairs, strict=True))
        self.upper, self.lower = at[self.upper], at[self.lower]
        self.tensions, self.k, self.c = line.tensions, line.stiffness, line.viscosity
        self.step, self.size = step, int(at.max()) + 1

    def prepare(self, factor: Any) -> None:
        pulls = np.zeros((self.size, len(self.upper)))
        number = np.arange(len(self.upper))
        pulls[self.upper, number], pulls[self.lower, number] = 1.0, -1.0
        # A force that pushes both ends apart as far as the spring would pull them together.
        self.columns = factor.solve(pulls)

    def settle(
        self, plain: Floats, column: Floats, of: tuple[Floats, float, float], old: Any
    ) -> tuple[Floats, float]:
        """Motion and contact force at the end of a step."""
        (g, height, law), (u, v) = of, old

        def apart(x: Floats) -> Floats:
            return np.asarray(x[self.upper] - x[self.lower])

        stiff = self.k + 2 * self.c / self.step
        before = self.tensions - self.c * apart(2 / self.step * u + v)
        slack = np.zeros(len(self.upper), dtype=bool)
        for _ in range(100):
            rows = np.flatnonzero(slack)
            pushes = self.columns[:, rows]
            # Unknown: contact force, and the push of each slack dropper, which is taken away.
            a = np.empty((1 + len(rows),) * 2)
            a[0, 0] = 1 / law + g @ column
            a[0, 1:] = -(g @ pushes)
            a[1:, 0] = stiff * apart(column)[rows]
            a[1:, 1:] = np.eye(len(rows)) - stiff * apart(pushes)[rows]
            right = np.append(g @ plain - height, (before + stiff * apart(plain))[rows])
            found = np.linalg.solve(a, right)
            new = plain - found[0] * column + pushes @ found[1:]
            tension = before + stiff * apart(new)
            again = tension < 0.0
            if (again == slack).all():
                return new, float(found[0])
            slack = again
        raise AssertionError("droppers that do not settle")
