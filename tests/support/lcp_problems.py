"""Complementarity problems with one solution each (P-matrices): random, hard, and out of runs."""

import contextlib
import io
import runpy
from collections.abc import Callable
from pathlib import Path
from unittest.mock import patch

import numpy as np

from arcless import lcp

Problem = tuple[np.ndarray, np.ndarray]
Kind = Callable[[int, np.random.Generator], Problem]
SIZES = (2, 3, 5, 9, 17, 33)
BEAM = Path(__file__).parents[2] / "examples" / "dropped_beam.py"
EPS = float(np.finfo(float).eps)


def definite(n: int, random: np.random.Generator) -> Problem:
    """Symmetric, condition number some hundreds."""
    g = random.standard_normal((n, n))
    return g @ g.T / n + 0.1 * np.eye(n), random.standard_normal(n)


def skew(n: int, random: np.random.Generator) -> Problem:
    """Contacts and droppers: two definite blocks, coupled by opposite signs."""
    H, w = definite(n, random)
    half, coupling = n // 2, random.standard_normal((n, n))
    H[:half, half:], H[half:, :half] = -coupling[:half, half:], coupling[:half, half:].T
    return H, w


def touching(n: int, random: np.random.Generator) -> Problem:
    """Small whole numbers: forces and gaps that vanish together."""
    g = random.integers(-1, 2, (n, n))
    return (g @ g.T + np.eye(n)).astype(float), random.integers(-1, 2, n).astype(float)


def murty(n: int, random: np.random.Generator) -> Problem:
    """Murty's matrix of 1978: 2ⁿ pivots for the simplest rule; w in any order of size."""
    return np.eye(n) + 2.0 * np.tril(np.ones((n, n)), -1), -random.uniform(0.5, 2.0, n)


def circulant(n: int, random: np.random.Generator) -> Problem:
    """x_k + 1.5 x_k+1 in a ring, n odd: xᵀHx < 0 for some x, and yet a P-matrix."""
    n += 1 - n % 2
    return np.eye(n) + 1.5 * np.roll(np.eye(n), 1, axis=1), -random.uniform(0.9, 1.1, n)


def near_singular(n: int, random: np.random.Generator) -> Problem:
    """Return a matrix of rank one third, plus 1e-6: contacts that move almost together."""
    g = random.standard_normal((n, -(-n // 3)))
    return g @ g.T / n + 1e-6 * np.eye(n), random.standard_normal(n)


def many(kind: Kind, seeds: int = 20, largest: int = 33) -> list[Problem]:
    """Problems of a kind in several sizes, the same ones at every call."""
    return [
        kind(n, np.random.default_rng([seed, n]))
        for n in SIZES
        if n <= largest
        for seed in range(seeds)
    ]


def dropped_beam() -> list[Problem]:
    """Problems in the first second of examples/dropped_beam.py, of steps that touch a support."""
    step, taken = lcp.PublishedStep.step, []

    def keep(self, *given):
        taken.append(self.problem(*given))
        return step(self, *given)

    with (
        patch.object(lcp.PublishedStep, "step", keep),
        contextlib.redirect_stdout(io.StringIO()),
    ):
        runpy.run_path(str(BEAM))["main"](1e-3, 1.0)
    return [(H, w) for H, w in taken if w.min() < 0]


def unit_diagonal(H: np.ndarray, w: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the problem without units, with H_kk = 1 and |w| ≤ 1; x is scale · x′."""
    d = 1.0 / np.sqrt(np.diagonal(H))
    size = max(np.abs(d * w).max(), np.finfo(float).tiny)
    return np.ascontiguousarray(H * np.outer(d, d)), d * w / size, d * size


def roundings(H: np.ndarray, w: np.ndarray, x: np.ndarray, other: np.ndarray) -> float:
    """Largest difference of two answers, in units of ε · cond(H) · largest force.

    All at unit diagonal: a rounding of H or w moves the answer by about one such unit.
    """
    matrix, _, scale = unit_diagonal(H, w)
    unit = EPS * np.linalg.cond(matrix) * max(np.abs(other / scale).max(), np.finfo(float).tiny)
    return float(np.abs((x - other) / scale).max() / unit)


def violation(H: np.ndarray, w: np.ndarray, x: np.ndarray) -> float:
    """Largest |min(x, Hx + w)| at unit diagonal and |w| ≤ 1."""
    matrix, vector, scale = unit_diagonal(H, w)
    return float(np.abs(np.minimum(x / scale, matrix @ (x / scale) + vector)).max())
