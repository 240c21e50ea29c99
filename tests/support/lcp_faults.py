"""Deliberate faults of the complementarity solver: another problem, or another answer."""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from unittest.mock import patch

import numpy as np

import arcless.lcp  # noqa: F401 - so that the next line finds it
from tests.support.faults import Fault

PROBLEM = sys.modules["arcless.lcp.problem"]
Problem = tuple[np.ndarray, np.ndarray]


@contextmanager
def complementarity(
    spoil: Callable[[np.ndarray, np.ndarray], Problem],
    answer: Callable[[np.ndarray], np.ndarray] = lambda x: x,
) -> Iterator[None]:
    """Let the core solve a spoiled problem, or spoil its answer."""
    pivoted, solved = PROBLEM.pivoted, []

    def solve(matrix: np.ndarray, vector: np.ndarray):
        H, w = spoil(matrix, vector)
        x, y, info = pivoted(np.ascontiguousarray(H), w)
        solved.append(info)
        return answer(x), y, info

    try:
        with patch.object(PROBLEM, "pivoted", solve):
            yield
    finally:
        if not solved:
            raise RuntimeError("the fault was never put in")


def stale(H: np.ndarray, w: np.ndarray) -> Problem:
    """Return the problem as if a contact had moved on, but its column not quite."""
    H = H.copy()
    H[:, 0] *= 1.0 + 1e-9
    return H, w


def slips(same: Callable[..., None], same_in_a_run: Callable[..., None]) -> list[Fault]:
    """Return what any comparison with another solver must notice."""
    return [
        Fault("rows and columns of H exchanged", complementarity(lambda H, w: (H.T, w)), same,
              name="skew"),
        Fault("first column of H off by 1e-9", complementarity(stale), same, name="definite"),
        Fault("gaps 1e-12 m too small", complementarity(lambda H, w: (H, w - 1e-12)),
              same_in_a_run),
        Fault("forces 1 µN too large", complementarity(lambda H, w: (H, w), lambda x: x + 1e-6),
              same, name="ring"),
    ]  # fmt: skip
