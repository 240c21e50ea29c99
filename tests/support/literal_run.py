"""A pantograph under one wire, stepped by the literal published step with dense matrices.

The wire is a chain of n point masses in the plane, written out here: r are all positions, d = G r
the vectors along its segments, D r the second differences at its inner points,

    U = Σ ½ (EA/L)(|d| − L)² + ½ (EI/L³)|D r|²,      internal forces ∂U/∂r, tangent ∂²U/∂r².

Nothing is shared with the core but the complementarity solver.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from arcless import lcp

Floats = NDArray[np.float64]

ALONG, UP = 0, 1
MOST_APPROXIMATIONS = 30  # of an equilibrium; some five reach rounding


@dataclass
class Chain:
    """A wire between two fixed points of equal height.

    Parameters
    ----------
    length, count : span in m, and its segments
    mass, axial, bending, tension : kg/m, N, N·m², N
    gravity : m/s²
    """

    length: float = 24.0
    count: int = 48
    mass: float = 1.07
    axial: float = 12e6
    bending: float = 145.0
    tension: float = 12e3
    gravity: float = 9.81

    def __post_init__(self) -> None:
        n, step = self.count + 1, self.length / self.count
        self.rest_length = step / (1.0 + self.tension / self.axial)
        self.positions = np.column_stack([step * np.arange(n), np.zeros(n)])
        self.G = np.diff(np.eye(n), axis=0)
        self.D = np.diff(np.eye(n), 2, axis=0)
        self.inner = slice(2, 2 * n - 2)  # of all coordinates, node by node
        self.masses = np.full(2 * (n - 2), self.mass * self.rest_length)

    def _strained(self, r: Floats) -> tuple[Floats, Floats, Floats]:
        d = self.G @ r
        length = np.linalg.norm(d, axis=1)
        stiffness = self.axial / self.rest_length
        return d / length[:, None], stiffness * (length - self.rest_length), length

    def residual(self, r: Floats) -> Floats:
        """Return internal forces less the weight, N, at the inner points."""
        direction, tension, _ = self._strained(r)
        g = self.G.T @ (tension[:, None] * direction)
        g += self.bending / self.rest_length**3 * self.D.T @ (self.D @ r)
        g[:, UP] += self.mass * self.rest_length * self.gravity
        return g.ravel()[self.inner]

    def tangent(self, r: Floats) -> Floats:
        """Return the stiffness of the inner points, N/m."""
        direction, tension, length = self._strained(r)
        along = direction[:, :, None] * direction[:, None, :]
        across = (tension / length)[:, None, None] * (np.eye(2) - along)
        each = self.axial / self.rest_length * along + across
        K = np.einsum("sa,sce,sb->acbe", self.G, each, self.G)
        K = K.reshape(r.size, r.size)
        K += np.kron(self.bending / self.rest_length**3 * self.D.T @ self.D, np.eye(2))
        return K[self.inner, self.inner]

    def moved(self, u: Floats, rest: Floats) -> Floats:
        """Return the positions of all points with displaced inner ones."""
        r = rest.copy()
        r.reshape(-1)[self.inner] += u
        return r

    def settled(self, start: Floats, load: Floats) -> Floats:
        """Return the equilibrium under loads on the inner points, by Newton's method."""
        r = start
        for _ in range(MOST_APPROXIMATIONS):
            r = self.moved(np.linalg.solve(self.tangent(r), load - self.residual(r)), r)
        return r


@dataclass
class Pantograph:
    """A pantograph by its matrices.

    Parameters
    ----------
    mass, damping, stiffness : kg, N·s/m, N/m
    strip : combination of its coordinates that touches the wire, and that the preload acts on
    force : contact force at the start, N
    """

    mass: Floats
    damping: Floats
    stiffness: Floats
    strip: Floats
    force: float


class LiteralRun:
    """Line and pantograph as one system of the published step, its stiffness renewed each time."""

    def __init__(self, chain: Chain, pantograph: Pantograph, start: float, tau: float) -> None:
        self.chain, self.pantograph = chain, pantograph
        self.rest = chain.settled(chain.positions, np.zeros(len(chain.masses)))
        r, force = self.rest, pantograph.force
        for _ in range(MOST_APPROXIMATIONS):  # the force moves the place where it acts
            r = chain.settled(r, self.shares(start, r, UP) * force)
        u = (r - self.rest).ravel()[chain.inner]
        # At rest the strip is as high as the wire has risen: K z = strip · (preload − force).
        e, K = pantograph.strip, pantograph.stiffness
        rise = self.shares(start, r, UP) @ u
        push = rise / (e @ np.linalg.solve(K, e))
        self.preload = push + force
        self.u_1 = np.append(u, np.linalg.solve(K, e * push))
        self.u_2 = self.u_1
        self.datum = self.height(start, r)
        M = self._both(np.diag(chain.masses), pantograph.mass)
        C_d = self._both(np.zeros((len(u), len(u))), pantograph.damping)
        self.system = lcp.PublishedStep(M, C_d, self._both(chain.tangent(r), K), tau)

    def _both(self, line: Floats, pantograph: Floats) -> Floats:
        n = len(line)
        both = np.zeros((n + len(pantograph), n + len(pantograph)))
        both[:n, :n], both[n:, n:] = line, pantograph
        return both

    def _weights(self, x: float, r: Floats) -> Floats:
        """Return the shares of all points in what acts at x on the wire where it is now."""
        k = int(np.searchsorted(r[:, ALONG], x)) - 1
        weights = np.zeros(len(r))
        part = (x - r[k, ALONG]) / (r[k + 1, ALONG] - r[k, ALONG])
        weights[k : k + 2] = 1.0 - part, part
        return weights

    def shares(self, x: float, r: Floats, component: int) -> Floats:
        """Return the shares of the inner points' coordinates in a force at x."""
        return np.outer(self._weights(x, r), np.eye(2)[component]).ravel()[self.chain.inner]

    def height(self, x: float, r: Floats) -> float:
        """Return the height at rest of what is now at x, m."""
        return float(self._weights(x, r) @ self.rest[:, UP])

    def advance(self, x: float, coefficient: float, force_1: Floats) -> lcp.Step:
        """Take a step with the strip at x, under friction of the forces of the step before."""
        n = len(self.chain.masses)
        r = self.chain.moved(self.u_1[:n], self.rest)
        K = self._both(self.chain.tangent(r), self.pantograph.stiffness)
        self.system.reform(K)
        # Such that K u − p is the force at the new position, to first order.
        p = K @ self.u_1
        p[:n] -= self.chain.residual(r)
        p[n:] = self.pantograph.strip * self.preload
        p[:n] += self.shares(x, r, ALONG) * lcp.friction(coefficient, force_1)[0]
        C = np.append(self.shares(x, r, UP), -self.pantograph.strip)
        gap = [self.height(x, r) - self.datum]
        step = self.system.step(self.u_1, self.u_2, p, C[:, None], gap)
        self.u_1, self.u_2 = step.u, self.u_1
        return step
