"""The published step: its formulas against the equations they come from, refusals, its example."""

import contextlib
import doctest
import importlib.util
import sys
from pathlib import Path

import numpy as np
import pytest

from arcless import lcp
from arcless.lcp import published

EXAMPLE = Path(__file__).parents[3] / "examples/dropped_beam.py"
NAN = float("nan")


def spring(tau: float = 1e-3) -> lcp.PublishedStep:
    return lcp.PublishedStep([[2.0]], [[0.0]], [[2.0 * (2 * np.pi * 20) ** 2]], tau)


def test_step_is_the_problem_solved() -> None:
    """H, w and u against matrices formed here, with numpy's own solver in place of the exchange."""
    random = np.random.default_rng(3)
    n, m, tau = 6, 2, 0.02
    M, C_d, K = (g @ g.T + np.eye(n) for g in random.standard_normal((3, n, n)))
    C, d0, p = random.standard_normal((n, m)), 1e-3 * random.random(m), random.standard_normal(n)
    u_1, u_2 = 1e-3 * random.standard_normal((2, n))
    system = lcp.PublishedStep(M, C_d, np.eye(n), tau)
    system.reform(K)
    A, B = M / tau**2 + C_d / tau + K, 2 * M / tau**2 + C_d / tau
    p_hat = M @ u_2 / tau**2 - B @ u_1 - p
    H, w = system.problem(u_1, u_2, p, C, d0)
    # Condition number of A below 1e3.
    np.testing.assert_allclose(H, C.T @ np.linalg.solve(A, C), rtol=1e-11)
    np.testing.assert_allclose(w, d0 - C.T @ np.linalg.solve(A, p_hat), rtol=0, atol=1e-14)
    step = system.step(u_1, u_2, p, C, d0)
    x, y, info = lcp.solve(H, w)
    np.testing.assert_array_equal(step.force, x)
    np.testing.assert_array_equal(step.gap, y)
    assert step.info == info
    # Round-off of numbers below 1; forces are these over τ²/M, four digits less.
    np.testing.assert_allclose(C.T @ step.u + d0, step.gap, rtol=0, atol=1e-15)
    np.testing.assert_allclose(A @ step.u + p_hat, C @ step.force, rtol=0, atol=1e-11)
    assert (system.size, system.time_step) == (n, tau)


def test_increments_give_the_same_step() -> None:
    """u measured from the newest coordinates, internal forces in the load."""
    random = np.random.default_rng(5)
    M, C_d, K = (g @ g.T + np.eye(5) for g in random.standard_normal((3, 5, 5)))
    C, d0, p = random.standard_normal((5, 2)), np.full(2, -0.1), random.standard_normal(5)
    u_1, u_2 = 1e-2 * random.standard_normal((2, 5))
    system = lcp.PublishedStep(M, C_d, K, 0.02)
    whole = system.step(u_1, u_2, p, C, d0)
    increment = system.step(np.zeros(5), u_2 - u_1, p - K @ u_1, C, d0 + C.T @ u_1)
    # Round-off of a 5 × 5 solve with numbers below 1.
    np.testing.assert_allclose(u_1 + increment.u, whole.u, rtol=0, atol=1e-14)
    # Forces are displacements of 1e-2 over τ²/M: four digits less.
    np.testing.assert_allclose(increment.force, whole.force, rtol=0, atol=1e-10)
    assert whole.force.max() > 0


def test_arrays_may_have_any_layout_and_are_left_alone() -> None:
    K = np.array([[3.0, -1.0], [-1.0, 2.0]])
    system = lcp.PublishedStep(np.eye(2), np.zeros((2, 2)), K, 0.1)
    C = np.array([[1.0, 0.0], [0.5, 1.0]])
    plain = system.step([0, 0], [0, 0], [-1, -1], C, [0, 0])
    wide = np.zeros((4, 4))
    wide[::2, ::2] = C
    for form in (np.asfortranarray(C), wide[::2, ::2], C.tolist()):
        again = system.step(np.zeros(2), np.zeros(2), [-1.0, -1.0], form, (0, 0))
        np.testing.assert_array_equal(again.u, plain.u)
    np.testing.assert_array_equal(C, [[1, 0], [0.5, 1]])


def test_block_exchange_is_the_exchange_of_every_row() -> None:
    """Steps 6 and 7: table 1 with its n rows exchanged one after the other is table 2."""
    random = np.random.default_rng(7)
    n, m, tau = 7, 3, 0.5
    M, C_d, K = (g @ g.T + 0.5 * np.eye(n) for g in random.uniform(-1, 1, (3, n, n)))
    C, d0, p = random.uniform(-1, 1, (n, m)), random.uniform(-1, 1, m), random.uniform(-1, 1, n)
    u_1, u_2 = random.uniform(-0.1, 0.1, (2, n))
    A, B = M / tau**2 + C_d / tau + K, 2 * M / tau**2 + C_d / tau
    p_hat = M @ u_2 / tau**2 - B @ u_1 - p
    table = np.block([[A, -C, p_hat[:, None]], [C.T, np.zeros((m, m)), d0[:, None]]])
    for k in range(n):
        published.exchange(table, k)
    system = lcp.PublishedStep(M, C_d, K, tau)
    H, w = system.problem(u_1, u_2, p, C, d0)
    # Entries of order 1, condition number about 20.
    np.testing.assert_allclose(H, table[n:, n:-1], rtol=0, atol=1e-13)
    np.testing.assert_allclose(w, table[n:, -1], rtol=0, atol=1e-13)
    step = system.step(u_1, u_2, p, C, d0)
    # The upper rows: A⁻¹C and −A⁻¹p̂ with the forces of the step. And those of R_i: A⁻¹, CᵀA⁻¹.
    np.testing.assert_allclose(
        step.u, table[:n, n:] @ np.append(step.force, 1.0), rtol=0, atol=1e-13
    )
    np.testing.assert_allclose(table[:n, :n], np.linalg.inv(A), rtol=0, atol=1e-13)
    np.testing.assert_allclose(table[n:, :n], C.T @ np.linalg.inv(A), rtol=0, atol=1e-13)
    assert step.force.max() > 0


def test_exchange_is_its_own_inverse() -> None:
    """An exchange undone is none; a symmetric matrix has a symmetric inverse to the last bit."""
    g = np.random.default_rng(9).uniform(-1, 1, (9, 9))
    A = g @ g.T + 0.5 * np.eye(9)
    A = (A + A.T) / 2
    table = A.copy()
    for k in range(9):
        published.exchange(table, k)
    np.testing.assert_array_equal(table, table.T)
    for k in range(9):
        published.exchange(table, k)
    # Condition number about 20.
    np.testing.assert_allclose(table, A, rtol=0, atol=1e-13 * A.max())


def test_every_step_satisfies_the_model() -> None:
    """Models 1 to 3 at the end of each step, while contacts move and the stiffness is re-formed."""
    random = np.random.default_rng(11)
    n, m, tau = 8, 3, 0.01

    def gram(shift: float) -> np.ndarray:
        g = random.uniform(-1, 1, (n, n))
        return g @ g.T + shift * np.eye(n)

    M, C_d = gram(0.5), gram(0.0)
    system = lcp.PublishedStep(M, C_d, gram(0.0), tau)
    u_1 = u_2 = np.zeros(n)
    closed = 0
    for i in range(200):
        if i % 50 == 0:
            K = gram(0.0)
            system.reform(K)
        if i % 5 == 0:
            C, d0 = random.uniform(-1, 1, (n, m)), 1e-3 * random.uniform(-1, 1, m)
        p = random.uniform(-1, 1, n)
        step = system.step(u_1, u_2, p, C, d0)
        u, velocity = step.u, (step.u - u_1) / tau  # step 1
        inertia = M @ ((u - 2 * u_1 + u_2) / tau**2)  # step 2
        R = inertia + C_d @ velocity + K @ u - p - C @ step.force
        size = max(np.abs(part).max() for part in (inertia, C @ step.force, p))
        # Rounding of u is divided by τ² = 1e-4 here.
        assert np.abs(R).max() < 1e-10 * size
        # A few roundings of the displacements.
        assert np.abs(C.T @ u + d0 - step.gap).max() < 1e-14 * max(1.0, np.abs(u).max())
        assert (step.gap >= 0).all()
        assert (step.force >= 0).all()
        assert (step.gap * step.force == 0).all()
        closed += np.count_nonzero(step.force)
        u_1, u_2 = u, u_1
    assert 100 < closed < 500, "of 600: both states occur"


def test_twin_contacts_are_solved() -> None:
    """Two contacts at one place: H has rank one, and the nearer of the two carries everything."""
    system = lcp.PublishedStep([[1.0]], [[0.0]], [[1e3]], 1e-2)
    step = system.step([0.0], [0.0], [-5.0], [[1.0, 1.0]], [0.0, 1e-3])
    # Rounding of numbers of order 1.
    np.testing.assert_allclose(step.force, [5.0, 0.0], rtol=0, atol=1e-12)
    np.testing.assert_allclose(step.gap, [0.0, 1e-3], rtol=0, atol=1e-15)
    assert step.force[1] == 0.0


def test_the_caller_may_change_his_arrays() -> None:
    M, C_d, K = np.eye(2), np.zeros((2, 2)), 3.0 * np.eye(2)
    system = lcp.PublishedStep(M, C_d, K, 0.1)
    given = ([0.1, 0.0], [0.0, 0.0], [-1.0, -1.0], np.eye(2), [0.0, 0.0])
    before = system.step(*given)
    for matrix in (M, C_d, K):
        matrix[:] = 7.0
    np.testing.assert_array_equal(system.step(*given).u, before.u)


I2 = np.eye(2)
SKEW = [[1.0, 0.5], [0.4, 1.0]]
BAD_SYSTEMS = [
    ((np.ones((2, 3)), I2, I2, 1), r"mass: got shape \(2, 3\), expected a square matrix"),
    ((np.zeros((0, 0)), I2, I2, 1), r"mass: got shape \(0, 0\)"),
    (([["a"]], I2, I2, 1), "mass: got could not convert"),
    ((I2, [[1.0]], I2, 1), r"damping: got shape \(1, 1\), expected \(2, 2\), as the mass matrix"),
    ((I2, I2, [1.0, 1.0], 1), r"stiffness: got shape \(2,\), expected \(2, 2\)"),
    ((I2, I2, [[1, NAN], [NAN, 1]], 1), r"stiffness\[0, 1\]: got nan, expected a number"),
    (
        (SKEW, I2, I2, 1),
        r"mass: got mass\[0, 1\] = 0.5 and mass\[1, 0\] = 0.4, expected a symmetric matrix",
    ),
    ((I2, SKEW, I2, 1), r"damping: got damping\[0, 1\] = 0.5"),
    ((I2, I2, SKEW, 1), r"stiffness: got stiffness\[0, 1\] = 0.5"),
    ((np.diag([1.0, -2.0]), I2, 9 * I2, 1), "mass: got an eigenvalue of -2"),
    ((I2, I2, -9 * I2, 1), r"M/τ² \+ C_d/τ \+ K: got a pivot of -7 in row 0"),
    ((I2, 0 * I2, [[0, 3], [3, 0]], 1), "K: got a pivot of -8 .* expected a positive definite"),
    ((0 * I2, 0 * I2, 0 * I2, 1), "K: got a pivot of 0 "),
    ((I2, I2, I2, 1e-200), "K: got a pivot of inf"),
    (([[0.0, 1e308], [-1e308, 0.0]], I2, I2, 1), "mass: got"),
    ((I2, I2, I2, 0), "time_step: got 0, expected a positive number, s"),
    ((I2, I2, I2, -1e-3), "time_step: got -0.001"),
    ((I2, I2, I2, NAN), "time_step: got nan"),
    ((I2, I2, I2, [1.0, 2.0]), "time_step: got"),
]


@pytest.mark.parametrize(("arguments", "message"), BAD_SYSTEMS)
def test_bad_systems_are_named(arguments, message: str) -> None:
    with pytest.raises(lcp.LcpInputError, match=message) as caught:
        lcp.PublishedStep(*arguments)
    assert caught.value.exit_code == 2


GOOD = {"u_1": [0.0], "u_2": [0.0], "load": [-1.0], "contact_map": [[1.0]], "initial_gap": [0.0]}
BAD_STEPS = [
    ({"u_1": [0.0, 0.0]}, r"u_1: got shape \(2,\), expected \(1,\), for 1 degrees of freedom"),
    ({"u_2": 0.0}, r"u_2: got shape \(\), expected \(1,\)"),
    ({"load": [NAN]}, r"load\[0\]: got nan"),
    ({"contact_map": [[1.0, 1.0]]}, r"contact_map: got shape \(1, 2\), expected \(1, 1\)"),
    ({"contact_map": [[np.inf]]}, r"contact_map\[0, 0\]: got inf"),
    ({"contact_map": [[0.0]]}, r"contact_map\[:, 0\]: got zeros, expected a contact that acts"),
    ({"initial_gap": [[0.0]]}, r"initial_gap: got shape \(1, 1\), expected one dimension"),
    ({"initial_gap": [1j]}, "initial_gap: got complex numbers"),
]


@pytest.mark.parametrize(("change", "message"), BAD_STEPS)
def test_bad_steps_are_named(change, message: str) -> None:
    system = spring()
    before = system.step(**GOOD)
    for call in (system.problem, system.step):
        with pytest.raises(lcp.LcpInputError, match=message):
            call(**GOOD | change)
    np.testing.assert_array_equal(system.step(**GOOD).u, before.u)


@pytest.mark.parametrize("name", ["u_1", "u_2", "load", "contact_map", "initial_gap"])
def test_numbers_beyond_all_floats_end_in_an_error_or_in_numbers(name: str) -> None:
    """Neither a warning of NumPy nor an infinite displacement."""
    given = GOOD | {name: [[1e308]] if name == "contact_map" else [1e308]}
    free = given | {"contact_map": np.zeros((1, 0)), "initial_gap": []}
    for case in (given, free):
        with contextlib.suppress(lcp.LcpUnsolvedError, lcp.LcpInputError), np.errstate(all="raise"):
            assert np.isfinite(spring().step(**case).u).all()


def test_failed_reform_keeps_the_old_stiffness() -> None:
    system = spring()
    before = system.step(**GOOD)
    for stiffness in ([[-1e9]], [[NAN]], [[1.0, 0.0], [0.0, 1.0]]):
        with pytest.raises(lcp.LcpInputError):
            system.reform(stiffness)
    np.testing.assert_array_equal(system.step(**GOOD).force, before.force)


def test_contacts_that_exclude_each_other_are_reported() -> None:
    """A mass between a floor and a ceiling lower than the floor."""
    with pytest.raises(lcp.LcpUnsolvedError):
        spring().step([0.0], [0.0], [0.0], [[1.0, -1.0]], [-1e-3, -1e-3])


@pytest.mark.parametrize(
    ("coefficient", "force", "message"),
    [
        (-0.1, [1.0], "coefficient: got -0.1, expected a number, not negative"),
        (NAN, [1.0], "coefficient: got nan"),
        (0.1, [NAN], r"previous_force\[0\]: got nan"),
        (0.1, 1.0, r"previous_force: got shape \(\)"),
        (1e308, [1e308], r"friction\[0\]: got inf"),
    ],
)
def test_bad_friction_is_named(coefficient, force, message: str) -> None:
    with pytest.raises(lcp.LcpInputError, match=message):
        lcp.friction(coefficient, force)


def test_docstring_example() -> None:
    results = doctest.testmod(sys.modules["arcless.lcp.published"])
    assert results.attempted > 0
    assert results.failed == 0


def test_dropped_beam_comes_to_rest_as_the_textbook_says(
    capsys: pytest.CaptureFixture[str],
) -> None:
    spec = importlib.util.spec_from_file_location("dropped_beam", EXAMPLE)
    assert spec is not None
    assert spec.loader is not None
    example = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(example)
    force, gap = example.main()
    printed = capsys.readouterr().out
    page = (EXAMPLE.parents[1] / "docs/guide/lcp.md").read_text("utf-8")
    assert f"```text\n{printed}```" in page

    P, q, span = 500 * 9.81, 16 * 9.81, 3.0
    # After 5 s the slowest motion has 4e-11 of its rest left.
    np.testing.assert_allclose(force[-1], [P / 2, P / 2 + 6 * q, 0], rtol=1e-8)
    free_end = (P / 16 - q * span / 4) * span**3 / 2.0e6
    np.testing.assert_allclose(gap[-1], [0, 0, free_end], rtol=1e-8)
    # From rest to rest the supports take what the weight gives, and nothing else.
    assert 1e-3 * force.sum() == pytest.approx((P + 6 * q) * 5.0, rel=1e-9)
    assert (np.minimum(force, gap) == 0).all()
    assert force[:, 2].max() > 0
