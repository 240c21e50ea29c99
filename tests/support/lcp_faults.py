"""Deliberate faults of the complementarity solver: another problem, or another answer."""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import ModuleType
from unittest.mock import patch

import numpy as np

import arcless.lcp  # noqa: F401 - so that the next line finds it

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


def noticed_slips(noticed: Callable[..., None], checked: ModuleType) -> None:
    """Show that a comparison with another solver notices the slips that any of them must."""
    with complementarity(lambda H, w: (H.T, w)):
        noticed("rows and columns of H exchanged", checked.test_same_forces, name="skew")
    with complementarity(stale):
        noticed("first column of H off by 1e-9", checked.test_same_forces, name="definite")
    with complementarity(lambda H, w: (H, w - 1e-12)):
        noticed("gaps 1e-12 m too small", checked.test_same_forces_in_a_run)
    with complementarity(lambda H, w: (H, w), lambda x: x + 1e-6):
        noticed("forces 1 µN too large", checked.test_same_forces, name="ring")
