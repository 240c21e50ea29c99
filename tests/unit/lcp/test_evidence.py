"""The complementarity solver against two others that share nothing with it.

Enumeration tries all 2ⁿ contact states, Lemke's method walks along a ray. The core's own tests do
the same with other problems and look at pivots; here the public function is judged.
"""

import itertools

import numpy as np
import pytest

from arcless import lcp

Problem = tuple[np.ndarray, np.ndarray]


def definite(n: int, seed: int) -> Problem:
    """Condition number some hundreds."""
    random = np.random.default_rng(seed)
    g = random.standard_normal((n, n))
    return g @ g.T / n + 0.1 * np.eye(n), random.standard_normal(n)


def near_singular(n: int, seed: int) -> Problem:
    """Return a matrix of rank one third, plus 1e-6: contacts that move almost together."""
    random = np.random.default_rng(seed)
    g = random.standard_normal((n, -(-n // 3)))
    return g @ g.T / n + 1e-6 * np.eye(n), random.standard_normal(n)


def degenerate(n: int, seed: int) -> Problem:
    """Small whole numbers: forces and gaps that vanish together, equal energies, equal ratios."""
    random = np.random.default_rng(seed)
    g = random.integers(-1, 2, (n, n))
    return (g @ g.T + np.eye(n)).astype(float), random.integers(-1, 2, n).astype(float)


def all_zero(n: int, seed: int) -> Problem:
    """Touching without force everywhere."""
    return definite(n, seed)[0], np.zeros(n)


KINDS = [definite, near_singular, degenerate, all_zero]


def enumeration(H: np.ndarray, w: np.ndarray) -> np.ndarray:
    """The x whose most negative force or gap is least negative, of all contact states."""
    best, least = np.zeros_like(w), min(0.0, w.min())
    for state in itertools.product([False, True], repeat=w.size):
        closed = np.array(state)
        x = np.zeros_like(w)
        x[closed] = np.linalg.solve(H[np.ix_(closed, closed)], -w[closed])
        y = np.where(closed, 0.0, H @ x + w)
        if (worst := min(x.min(), y.min())) > least:
            best, least = x, worst
    return best


def lemke(H: np.ndarray, w: np.ndarray) -> np.ndarray:
    """Lemke's method with the lexicographic ratio test (Cottle, Pang & Stone, 4.4.5 and 4.9).

    Table of y − Hx − e z₀ = w, columns y, x, z₀, w. The lexicographic rule compares the rows of
    (w | B⁻¹), so that ties in degenerate problems cannot make it cycle.
    """
    n = w.size
    table = np.hstack([np.eye(n), -H, -np.ones((n, 1)), w[:, np.newaxis]])
    basis = np.arange(n)
    if w.min() >= 0:
        return np.zeros(n)
    row, entering = int(np.argmin(w)), 2 * n
    for _ in range(50 * n):
        table[row] /= table[row, entering]
        column = table[:, entering].copy()
        column[row] = 0
        table -= np.outer(column, table[row])
        leaving, basis[row] = basis[row], entering
        if leaving == 2 * n:
            x = np.zeros(2 * n)
            x[basis] = table[:, -1]
            return x[n:]
        entering = leaving + n if leaving < n else leaving - n
        row = ratio_test(table, basis, entering)
    raise AssertionError("Lemke's method did not end")


def ratio_test(table: np.ndarray, basis: np.ndarray, entering: int) -> int:
    n = basis.size
    rows = np.flatnonzero(table[:, entering] > 1e-9)
    for column in (-1, *range(n)):
        ratio = table[rows, column] / table[rows, entering]
        rows = rows[ratio <= ratio.min() + 1e-11 * (1 + abs(ratio.min()))]
        if column == -1 and (basis[rows] == 2 * n).any():
            return int(rows[basis[rows] == 2 * n][0])
        if rows.size == 1:
            break
    return int(rows[0])


def energy(problem: Problem, x: np.ndarray) -> float:
    """½ xᵀHx + wᵀx, well determined even where x is not; the solution makes it least."""
    H, w = problem
    return float(0.5 * x @ H @ x + w @ x)


def judge(problem: Problem, other: np.ndarray, digits: float) -> lcp.LcpInfo:
    """Compare energy, gaps, and forces up to what the condition of H leaves of them."""
    H, w = problem
    x, y, info = lcp.solve(H, w)
    assert info.status == "solved"
    assert (x >= 0).all()
    assert (y >= 0).all()
    assert (np.minimum(x, y) == 0).all()
    size = 1 + np.abs(w).max()
    # `digits` is the accuracy of the other solver; gaps scale with w, forces with the condition of
    # H.
    np.testing.assert_allclose(y, np.maximum(H @ other + w, 0), rtol=0, atol=digits * size)
    assert energy(problem, x) == pytest.approx(energy(problem, other), rel=digits, abs=1e-12)
    worth = digits * np.linalg.cond(H) * (1 + np.abs(other).max())
    np.testing.assert_allclose(x, other, rtol=0, atol=worth)
    return info


# Condition number below 1e7 for all kinds: nine of sixteen digits for the gaps.
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("n", range(1, 11))
def test_agrees_with_enumeration(kind, n: int) -> None:
    for seed in range(8 if n < 9 else 2):
        problem = kind(n, seed)
        judge(problem, enumeration(*problem), 1e-9)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("n", [1, 2, 5, 12, 30, 80])
def test_agrees_with_lemke(kind, n: int) -> None:
    for seed in range(10):
        problem = kind(n, 100 * n + seed)
        judge(problem, lemke(*problem), 1e-8)


# Lemke's table gathers the rounding of several hundred exchanges.
@pytest.mark.parametrize("kind", [definite, near_singular, degenerate])
def test_large_problems_agree_with_lemke(kind) -> None:
    problem = kind(500, 7)
    info = judge(problem, lemke(*problem), 1e-6)
    assert info.pivots < 1000  # about one per closed contact; the bound is 55 000


def test_contacts_at_one_place_share_a_determined_force() -> None:
    """H of rank one, plus 1e-11: the sum of the forces and the gaps keep their digits."""
    H = np.ones((3, 3)) + 1e-11 * np.eye(3)
    x, y, _ = lcp.solve(H, [-2.0, -2.0, 1.0])
    # The sum is 2/(1 + 1e-11/2), and free of the 1e-5 that round-off makes of the single forces.
    assert x.sum() == pytest.approx(2.0, rel=1e-10)
    np.testing.assert_allclose(y, [0, 0, 3], atol=1e-10)


def test_definite_problem_that_makes_the_energy_criterion_cycle() -> None:
    """Period 12 from the empty set (how it was found: crates/core/tests/lcp_hard); solved by the
    least-index rule. The plain rule is walked here to show that it does not end."""
    H = np.array(
        [
            [361, -134, -423, -171, -89, 218],
            [-134, 149, 202, -36, -60, -67],
            [-423, 202, 611, 207, 124, -235],
            [-171, -36, 207, 285, 88, -111],
            [-89, -60, 124, 88, 236, -56],
            [218, -67, -235, -111, -56, 137],
        ],
        dtype=float,
    )
    w = np.array([327, -75, -161, -102, -17, 203], dtype=float)
    closed, seen = np.zeros(6, dtype=bool), []
    for _ in range(40):
        seen.append(tuple(closed))
        inside = np.where(closed, 1.0, 0.0)
        block = H * np.outer(inside, inside) + np.diag(1 - inside)
        inverse = np.linalg.inv(block)
        x = -inverse @ (w * inside)
        value = np.where(closed, x, H @ x + w)
        schur = np.diag(H) - np.einsum("ij,jk,ki->i", H * inside, inverse, (H * inside).T)
        released = np.where(value < -1e-9, value**2 / np.where(closed, np.diag(inverse), schur), 0)
        assert released.max() > 0, "never solved by the energy criterion alone"
        closed = closed.copy()
        closed[released.argmax()] ^= True
    assert seen[0:28] == seen[12:40]
    assert judge((H, w), enumeration(H, w), 1e-9).fallback_used
