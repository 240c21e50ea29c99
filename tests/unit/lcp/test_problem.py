"""The public complementarity solver: answers, refusals, and the page that explains it."""

import contextlib
import doctest
import io
import itertools
import pickle
import re
import sys
import textwrap
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from arcless import lcp
from arcless.errors import ArclessError

PAGE = Path(__file__).parents[3] / "docs/guide/lcp.md"


def blocks(language: str) -> list[str]:
    """Code blocks of the page, in order."""
    return re.findall(rf"```{language}\n(.*?)```", PAGE.read_text("utf-8"), re.DOTALL)


def definite(n: int, seed: int) -> tuple[np.ndarray, np.ndarray]:
    random = np.random.default_rng(seed)
    g = random.standard_normal((n, n))
    return g @ g.T + 0.1 * np.eye(n), random.standard_normal(n)


def brute_force(H: np.ndarray, w: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The one of all 2ⁿ contact states whose most negative force or gap is least negative."""
    best = (-np.inf, np.zeros_like(w), w)
    for state in itertools.product([False, True], repeat=w.size):
        closed = np.array(state)
        x = np.zeros_like(w)
        x[closed] = np.linalg.solve(H[np.ix_(closed, closed)], -w[closed])
        y = np.where(closed, 0.0, H @ x + w)
        best = max(best, (min(x.min(), y.min()), x, y), key=lambda candidate: candidate[0])
    return best[1], best[2]


@given(n=st.integers(1, 7), seed=st.integers(0, 2**32 - 1))
def test_agrees_with_brute_force(n: int, seed: int) -> None:
    H, w = definite(n, seed)
    x, y, info = lcp.solve(H, w)
    x_all, y_all = brute_force(H, w)
    # Condition number some hundreds: three of sixteen digits, and three in reserve.
    np.testing.assert_allclose(x, x_all, rtol=1e-9, atol=1e-10 * np.abs(x_all).max())
    np.testing.assert_allclose(y, y_all, rtol=1e-9, atol=1e-10 * np.abs(w).max())
    assert (x >= 0).all()
    assert (y >= 0).all()
    assert (np.minimum(x, y) == 0).all()
    assert info.status == "solved"
    assert info.residual < 1e-14 * n  # a few roundings per row


def test_nothing_pushes_when_all_gaps_are_open() -> None:
    x, y, info = lcp.solve(np.eye(3), [1, 0, 2])
    assert x.tolist() == [0, 0, 0]
    assert y.tolist() == [1, 0, 2]
    assert (info.pivots, info.fallback_used, info.residual) == (0, False, 0.0)


def test_input_is_left_alone_and_may_have_any_layout() -> None:
    H, w = definite(5, 1)
    kept = H.copy(), w.copy()
    x, _, _ = lcp.solve(H, w)
    np.testing.assert_array_equal(H, kept[0])
    np.testing.assert_array_equal(w, kept[1])
    skew = H + np.triu(np.ones((5, 5)), 1) - np.tril(np.ones((5, 5)), -1)
    answers = [lcp.solve(form, w, symmetric=False)[0] for form in (skew, np.asfortranarray(skew))]
    np.testing.assert_array_equal(*answers)
    strided = np.zeros((10, 10))
    strided[::2, ::2] = H
    np.testing.assert_array_equal(lcp.solve(strided[::2, ::2], w)[0], x)
    np.testing.assert_array_equal(lcp.solve(H.tolist(), w.tolist())[0], x)


def test_fallback_is_reported() -> None:
    """The circulant P-matrix of the core's tests; x = 1/4 solves (1 + 3) x = 1."""
    H = [[1, 3, 0], [0, 1, 3], [3, 0, 1]]
    x, _, info = lcp.solve(H, [-1, -1, -1], symmetric=False)
    # The last bits of a 3 × 3 solve.
    np.testing.assert_allclose(x, 0.25, rtol=1e-15)
    assert info.fallback_used


NAN, INF = float("nan"), float("inf")
BAD = [
    ([[1, 2, 3], [2, 5, 6]], [1, 1], r"H: got shape \(2, 3\), expected a square matrix"),
    ([1, 2], [1, 1], r"H: got shape \(2,\), expected a square matrix"),
    ([[1, 0], [0, 1]], [1, 2, 3], "w: got 3 entries, expected 2"),
    ([[1.0]], [[1.0]], r"w: got shape \(1, 1\), expected one dimension"),
    (np.zeros((0, 0)), [], "H: got n = 0"),
    ([[1, NAN], [NAN, 1]], [1, 1], r"H\[0, 1\]: got nan"),
    ([[1, 0], [0, 1]], [1, -INF], r"w\[1\]: got -inf"),
    ([[1, 0.5], [0.4, 1]], [1, 1], r"H\[0, 1\] = 0.5 and H\[1, 0\] = 0.4, expected a symmetric"),
    ([[1, 0], [0, -2]], [1, 1], r"H\[1, 1\] = -2, expected a positive definite"),
    ([[0.0]], [1], r"H\[0, 0\] = 0, expected a positive definite"),
    ([[1, 2], [2, 1]], [1, 1], "a smallest eigenvalue of -1 at unit diagonal"),
    (np.ones((3, 3)), [1, 1, 1], "expected a positive definite matrix; hint: two rows"),
    ([["a"]], [1], "H: got could not convert"),
    ([[1, 2], [3]], [1, 1], "H: got .*expected an array of numbers"),
    ([[1 + 1j]], [1], "H: got complex numbers"),
]


@pytest.mark.parametrize(("H", "w", "message"), BAD)
def test_bad_input_is_named(H: object, w: object, message: str) -> None:
    with pytest.raises(lcp.LcpInputError, match=message) as caught:
        lcp.solve(H, w)  # type: ignore[arg-type]
    assert isinstance(caught.value, ValueError)
    assert isinstance(caught.value, ArclessError)
    assert caught.value.exit_code == 2


def test_symmetry_is_judged_row_by_row_in_the_units_of_the_rows() -> None:
    """1e-12 is rounding compared with 1, and everything compared with 1e-12."""
    H, w = definite(2, 3)
    units = np.array([1.0, 1e-6])
    H = H * np.outer(units, units)
    H[0, 1] *= 1 + 1e-12
    lcp.solve(H, w * units)
    H[0, 1] *= 1 + 1e-6
    with pytest.raises(lcp.LcpInputError, match="symmetric"):
        lcp.solve(H, w * units)


def test_matrix_outside_the_class_is_not_solved() -> None:
    """Without a solution: y₁ + y₂ = −x₁ − x₂ − 2 < 0."""
    with pytest.raises(lcp.LcpUnsolvedError, match="not a P-matrix") as caught:
        lcp.solve([[1, -2], [-2, 1]], [-1, -1], symmetric=False)
    assert caught.value.exit_code == 1
    assert caught.value.pivots == 1
    assert str(pickle.loads(pickle.dumps(caught.value))) == str(caught.value)


def test_docstring_example() -> None:
    results = doctest.testmod(sys.modules["arcless.lcp.problem"])
    assert results.attempted > 0
    assert results.failed == 0


def test_page_prints_what_it_says() -> None:
    code, _ = blocks("python")
    expected, _ = blocks("text")
    printed = io.StringIO()
    names: dict[str, object] = {}
    with contextlib.redirect_stdout(printed):
        exec(compile(code, str(PAGE), "exec"), names)
    assert printed.getvalue() == expected


def test_page_quotes_its_second_example() -> None:
    _, code = blocks("python")
    example = (PAGE.parents[2] / "examples/dropped_beam.py").read_text("utf-8")
    assert textwrap.indent(code, "    ", lambda line: bool(line.strip())) in example


def test_beam_of_the_page_has_the_textbook_reaction() -> None:
    """Two equal spans, load in the middle of the first: 11/16 at the middle support."""
    code, _ = blocks("python")
    names: dict[str, object] = {}
    with contextlib.redirect_stdout(io.StringIO()):
        exec(compile(code.split("for load")[0], str(PAGE), "exec"), names)
    flexibility = names["flexibility"]
    assert callable(flexibility)
    w = names["clearance"] - 20e3 * flexibility(names["stops"], 1.5)
    x, _, _ = lcp.solve(names["H"], w)  # type: ignore[arg-type]
    np.testing.assert_allclose(x, [0, 11 / 16 * 20e3, 0], rtol=1e-12)
