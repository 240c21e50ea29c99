"""Steps of a run on the matrices of scikit-fem, dense, with every dropper in each problem.

Equations of docs/theory/dynamics.md and contact.md; what Arcless does to be fast (short columns,
few links, warm starts, no product with K) is not done. For line and pantograph together, u from the
state at rest, a = 1 − α_f, c for the contact, the columns of G for droppers:

    A Δu = b + c λ − G r,      A = a_M M + a_C C + a K,      C = αM + β (K − springs) + pantograph
    [ d/a + λ/(a k_c) ]   [ cᵀA⁻¹c + 1/(a k_c)      −cᵀA⁻¹G    ] [ λ ]   [ d₀/a ]
    [ T/κ             ] = [ GᵀA⁻¹c              1/κ − GᵀA⁻¹G   ] [ r ] + [ T₀/κ ]
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from scipy.linalg import block_diag, lu_factor, lu_solve

from tests.support.skfem_line import Line, X

Solver = Callable[[Any, Any], Any]


class Scheme:
    """Generalised-α (Chung & Hulbert, J. Appl. Mech. 60 (1993) 371)."""

    def __init__(self, radius: float, h: float) -> None:
        self.h, self.m, self.f = h, (2 * radius - 1) / (radius + 1), radius / (radius + 1)
        self.gamma = 0.5 - self.m + self.f
        self.beta = 0.25 * (1.0 - self.m + self.f) ** 2
        self.mass = (1.0 - self.m) / (self.beta * h**2)
        self.damping = (1.0 - self.f) * self.gamma / (self.beta * h)

    def end(self, change: Any, v: Any, a: Any) -> tuple[Any, Any]:
        """Velocity and acceleration at the end of a step."""
        new = change / (self.beta * self.h**2) - v / (self.beta * self.h)
        new -= (0.5 / self.beta - 1.0) * a
        return v + self.h * ((1.0 - self.gamma) * a + self.gamma * new), new

    def balance(self, change: Any, v: Any, a: Any) -> tuple[Any, Any]:
        """Velocity and acceleration at the time of balance."""
        v_new, a_new = self.end(change, v, a)
        return (1 - self.f) * v_new + self.f * v, (1 - self.m) * a_new + self.m * a


class Run:
    """Line at rest in q, pantograph under it, `solve` for the complementarity problems."""

    def __init__(self, line: Line, q: Any, solve: Solver) -> None:
        scenario = line.scenario
        self.line, self.q, self.solve = line, q, solve
        self.scheme = Scheme(scenario.stepping.scheme.spectral_radius, scenario.time_step_s)
        self.contact = scenario.contact.stiffness
        self.n = len(line.free)
        self._matrices()
        self.factor = lu_factor(
            self.scheme.mass * self.M + self.scheme.damping * self.C + (1 - self.scheme.f) * self.K
        )
        self._droppers()
        self.at_G = lu_solve(self.factor, self.G)

    def _matrices(self) -> None:
        line, free = self.line, self.line.free
        inner = np.ix_(free, free)
        _, stiffness = line.terms(self.q)
        grounded = np.zeros(line.size)
        for unknown, k, _ in line.springs:
            grounded[unknown] = k
        damping = line.scenario.line.contact_wire.damping
        mass, stiffness = line.masses()[inner].toarray(), stiffness[inner].toarray()
        own = damping.alpha * mass + damping.beta * (stiffness - np.diag(grounded[free]))
        base, head = line.scenario.pantographs[0].model.masses
        self.k = chain(base.stiffness, head.stiffness)
        self.M = block_diag(mass, np.diag([base.mass, head.mass]))
        self.C = block_diag(own, chain(base.damping, head.damping))
        self.K = block_diag(stiffness, self.k)

    def _row(self, unknown: int) -> int:
        return int(np.searchsorted(self.line.free, unknown))

    def _droppers(self) -> None:
        kind = self.line.scenario.line.dropper
        self.G = np.zeros((self.n + 2, len(self.line.droppers)))
        for column, (*unknowns, _) in enumerate(self.line.droppers):
            ends = self.q[unknowns]
            along = (ends[2:] - ends[:2]) / np.hypot(*(ends[2:] - ends[:2]))
            rows = [self._row(unknown) for unknown in unknowns]
            self.G[rows, column] = [*(-along), *along]
        self.tension = self.line.dropper_forces(self.q)
        self.spring, self.damper = kind.stiffness, kind.rayleigh.beta * kind.stiffness

    def place(self, x: float) -> tuple[float, Any]:
        """Height of the contact wire above x, and c: its height in terms of the unknowns."""
        wire, numbers = self.line.wires[0], self.line.numbers[0]
        s = self._along(x)
        shape = wire.basis.probes(np.array([[s]])).toarray()[0]
        c = np.zeros(self.n + 2)
        used = np.flatnonzero(shape)
        unknowns = numbers[wire.size + used]
        is_free = np.isin(unknowns, self.line.free)
        c[np.searchsorted(self.line.free, unknowns[is_free])] = shape[used][is_free]
        return float(shape @ self.q[numbers[wire.size :]]), c

    def _along(self, x: float) -> float:
        """Coordinate of the wire that stands at x; the wire is straight to 1e-5."""
        wire, along = self.line.wires[0], self.q[self.line.numbers[0][: self.line.wires[0].size]]
        s = x * wire.ends[-1] / self.line.cut.mesh.positions[:, X].max()
        for _ in range(4):
            s -= float((wire.basis.probes(np.array([[s]])) @ along)[0] - x) / 1.0013
        return s

    def _start(self, x: float, force: float) -> Any:
        """Line and pantograph at rest under a contact force; the preload that takes."""
        height, c = self.place(x)
        u = np.zeros(self.n + 2)
        u[: self.n] = np.linalg.solve(self.K[: self.n, : self.n], force * c[: self.n])
        slack = self.tension + self.spring * (self.G.T @ u) < 0.0
        assert not slack.any(), "a dropper is slack at the start"
        top = height + c @ u + force / self.contact
        # k (u₁, top) = (p, −force)
        lower = (force + self.k[1, 1] * top) / -self.k[1, 0]
        u[self.n :] = lower, top
        self.load = np.zeros(self.n + 2)
        self.load[self.n] = self.k[0] @ u[self.n :]
        return u

    def forces(self, steps: int) -> tuple[Any, int]:
        """Contact force of each step in N, and the largest number of slack droppers."""
        placed, (x, _) = self.line.scenario.pantographs[0], self.line.scenario.travel_range()
        u = self._start(x, placed.static_force)
        v, a = np.zeros_like(u), np.zeros_like(u)
        found, slack, travelled = np.zeros(steps), 0, self.line.scenario.speed * self.scheme.h
        for step in range(steps):
            where = x + travelled * (step + 1.0 - self.scheme.f)
            change, found[step], r = self._step(where, u, v, a)
            slack = max(slack, int(np.count_nonzero(r)))
            v, a = self.scheme.end(change, v, a)
            u = u + change
        return found, slack

    def _step(self, x: float, u: Any, v: Any, a: Any) -> tuple[Any, float, Any]:
        share = 1.0 - self.scheme.f
        height, c = self.place(x)
        c[-1] = -1.0
        rate, second = self.scheme.balance(np.zeros_like(u), v, a)
        free = lu_solve(self.factor, self.load - self.M @ second - self.C @ rate - self.K @ u)
        rate, _ = self.scheme.balance(free, v, a)
        gap = height + c @ (u + share * free)
        pull = self.tension + self.G.T @ (self.spring * (u + share * free) + self.damper * rate)
        kappa = share * self.spring + self.scheme.damping * self.damper
        at_c = lu_solve(self.factor, c)
        H = np.block([
            [np.atleast_2d(c @ at_c + 1.0 / (share * self.contact)), -(c @ self.at_G)[None, :]],
            [(self.G.T @ at_c)[:, None], np.eye(len(pull)) / kappa - self.G.T @ self.at_G],
        ])  # fmt: skip
        force, *r = self.solve(H, np.concatenate([[gap / share], pull / kappa]))
        return free + at_c * force - self.at_G @ r, force, np.array(r)


def chain(lower: float, upper: float) -> Any:
    """Springs or dampers below two masses."""
    return np.array([[lower + upper, -upper], [-upper, upper]])
