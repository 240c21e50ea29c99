"""AC simple in plain SciPy: what an engineer would write, to compare speed and forces with.

The model of Arcless with `linearised` kinematics, planar, one pantograph that is a chain of masses
(docs/theory: wires, dynamics, contact). From Arcless come the mesh, the shape at rest, and the
solver of complementarity problems. Matrices are assembled here with NumPy and stepped with sparse
products and SuperLU. Line and pantograph form one system; u from the state at rest, a = 1 − α_f, c
for the contact, columns of G for droppers, κ = a k + a_C (damping of a dropper):

    A Δu = b + c λ − G r,      A = a_M M + a_C C + a K
    [ d/a + λ/(a k_c) ]   [ cᵀA⁻¹c + 1/(a k_c)      −cᵀA⁻¹G    ] [ λ ]   [ d₀/a ]
    [ T/κ             ] = [ GᵀA⁻¹c              1/κ − GᵀA⁻¹G   ] [ r ] + [ T₀/κ ]

It is not made slow: A is factorised once with the ordering that suits it, A⁻¹G is prepared, and
only droppers that would push or were slack enter a problem.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.sparse.linalg import splu

from arcless import lcp
from arcless.equilibrium.equilibrium import Equilibrium
from arcless.model import Scenario
from benchmarks.plain_matrices import Matrices, shape

Array = Any


class Scheme:
    """Generalised-α (Chung & Hulbert, J. Appl. Mech. 60 (1993) 371)."""

    def __init__(self, radius: float, h: float) -> None:
        self.h, self.m, self.f = h, (2 * radius - 1) / (radius + 1), radius / (radius + 1)
        self.gamma = 0.5 - self.m + self.f
        self.beta = 0.25 * (1.0 - self.m + self.f) ** 2
        self.mass = (1.0 - self.m) / (self.beta * h**2)
        self.damping = (1.0 - self.f) * self.gamma / (self.beta * h)
        self.stiffness = 1.0 - self.f

    def end(self, change: Array, v: Array, a: Array) -> tuple[Array, Array]:
        """Velocity and acceleration at the end of a step."""
        new = change / (self.beta * self.h**2) - v / (self.beta * self.h)
        new -= (0.5 / self.beta - 1.0) * a
        return v + self.h * ((1.0 - self.gamma) * a + self.gamma * new), new

    def old(self, v: Array, a: Array) -> tuple[Array, Array]:
        """Velocity and acceleration at the time of balance, without what the increment adds."""
        v_end, a_end = self.end(np.zeros_like(v), v, a)
        return (1 - self.f) * v_end + self.f * v, (1 - self.m) * a_end + self.m * a


@dataclass
class Record:
    """Contact force of each step in N; most slack droppers; solves with A, and pivots, in all."""

    force: Array
    slack: int = 0
    solves: int = 0
    pivots: int = 0


class Plain:
    """A scenario ready to step."""

    def __init__(self, scenario: Scenario, found: Equilibrium) -> None:
        self.scenario, self.line = scenario, Matrices(scenario, found)
        self.scheme = Scheme(scenario.stepping.scheme.spectral_radius, scenario.time_step_s)
        s, (mass, damping, stiffness) = self.scheme, self.line.matrices
        a = s.mass * mass + s.damping * damping + s.stiffness * stiffness
        # Nodes are in the order of the track, which fills least; a symmetric, positive definite
        # matrix needs no exchange of rows.
        self.solve = splu(a.tocsc(), permc_spec="NATURAL", diag_pivot_thresh=0.0).solve
        self.g = self.line.g.tocsr()
        self.at_g = self.solve(self.g.T.toarray())
        self.g_at_g = self.g @ self.at_g
        kind = self.line.droppers
        self.kappa = s.stiffness * kind.stiffness + s.damping * kind.viscosity

    def _place(self, x: float) -> tuple[float, Array]:
        """Height of the contact wire over x at rest, and c."""
        line = self.line
        k = int(np.clip(np.searchsorted(line.left, x, side="right") - 1, 0, len(line.left) - 1))
        length, xi = line.length[k], (x - line.left[k]) / (line.right[k] - line.left[k])
        for _ in range(2):  # Newton; the wire is nearly straight
            error = shape(xi, length) @ line.ends[k][:, 0] - x
            xi -= error / (shape(xi, length, 1) @ line.ends[k][:, 0] * length)
        weights, c = shape(xi, length), np.zeros(line.size)
        c[line.heights[k]] = weights
        c[line.held] = 0.0
        c[-1] = -1.0
        return float(weights @ line.ends[k][:, 1]), c

    def _start(self, x: float, force: float) -> tuple[Array, Array]:
        """State at rest with the given contact force, and the constant load."""
        line, n = self.line, self.line.size - len(self.scenario.pantographs[0].model.masses)
        height, c = self._place(x)
        stiffness, u = line.matrices[2].tocsc(), np.zeros(line.size)
        u[:n] = splu(stiffness[:n, :n]).solve(force * c[:n])
        assert (line.droppers.tension + line.droppers.stiffness * (self.g @ u) >= 0.0).all(), (
            "slack at rest"
        )
        # K u = p (1, 0, …) − force (0, …, 1), and the head is pressed into the wire.
        masses = line.size - n
        system = np.zeros((masses + 1, masses + 1))
        system[:-1, :-1] = stiffness[n:, n:].toarray()
        system[0, -1], system[-1, -2] = -1.0, 1.0
        known = np.zeros(masses + 1)
        known[-2], known[-1] = -force, height + c @ u + force / self.scenario.contact.stiffness
        *u[n:], preload = np.linalg.solve(system, known)
        load = np.zeros(line.size)
        load[n] = preload
        return u, load

    def run(self, force: float, steps: int) -> Record:
        """Take steps, from rest under a contact force in N."""
        x, travelled = self.scenario.travel_range()[0], self.scenario.speed * self.scheme.h
        u, self.load = self._start(x, force)
        v, a, r = np.zeros_like(u), np.zeros_like(u), np.zeros(len(self.kappa))
        record = Record(np.zeros(steps))
        for step in range(steps):
            where = x + travelled * (step + 1.0 - self.scheme.f)
            change, record.force[step], r = self._step(where, (u, v, a), r, record)
            record.slack = max(record.slack, int(np.count_nonzero(r)))
            v, a = self.scheme.end(change, v, a)
            u = u + change
        return record

    def _step(
        self, x: float, state: tuple[Array, Array, Array], r: Array, record: Record
    ) -> tuple[Array, float, Array]:
        (u, v, a), (mass, damping, stiffness) = state, self.line.matrices
        keep, kind = self.scheme.stiffness, self.line.droppers
        height, c = self._place(x)
        rate, second = self.scheme.old(v, a)
        free = self.solve(self.load - mass @ second - damping @ rate - stiffness @ u)
        at_c = self.solve(c)
        record.solves += 2
        gap = height + c @ u + keep * (c @ free)
        old = kind.stiffness * (self.g @ u) + kind.viscosity * (self.g @ rate)
        pull = self.line.droppers.tension + old + self.kappa * (self.g @ free)
        g_at_c = self.g @ at_c
        within = (r > 0.0) | (pull < 0.0)
        while True:
            rows = np.flatnonzero(within)
            force, r = self._problem(gap, pull, (c @ at_c, g_at_c), rows, record)
            change = free + at_c * force - self.at_g[:, rows] @ r[rows]
            now = pull + self.kappa * (g_at_c * force - self.g_at_g[:, rows] @ r[rows])
            pushes = (now < 0.0) & ~within
            if not pushes.any():
                return change, force, r
            within |= pushes

    def _problem(
        self, gap: float, pull: Array, at: tuple[float, Array], rows: Array, record: Record
    ) -> tuple[float, Array]:
        """Contact force and corrections from the problem with the given droppers."""
        own, g_at_c = at
        n, keep = len(rows) + 1, self.scheme.stiffness
        h = np.empty((n, n))
        h[0, 0] = own + 1.0 / (keep * self.scenario.contact.stiffness)
        h[1:, 0], h[0, 1:] = g_at_c[rows], -g_at_c[rows]
        h[1:, 1:] = np.diag(1.0 / self.kappa[rows]) - self.g_at_g[np.ix_(rows, rows)]
        w = np.concatenate([[gap / keep], pull[rows] / self.kappa[rows]])
        (force, *found), _, info = lcp.solve(h, w, symmetric=False)
        record.pivots += info.pivots
        r = np.zeros(len(self.kappa))
        r[rows] = found
        return float(force), r
