"""Deliberate faults of the complementarity solver: another problem, or another answer."""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
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
