"""The published step from Python: answers with closed forms, refusals, and its example."""

import doctest
import importlib.util
import sys
from pathlib import Path

import numpy as np
import pytest

from arcless import lcp

EXAMPLE = Path(__file__).parents[3] / "examples/dropped_beam.py"
NAN = float("nan")


def spring(tau: float = 1e-3) -> lcp.PublishedStep:
    return lcp.PublishedStep([[2.0]], [[0.0]], [[2.0 * (2 * np.pi * 20) ** 2]], tau)


def run_free(step: lcp.PublishedStep, u_2: float, u_1: float, count: int) -> np.ndarray:
    """Displacements of one degree of freedom without contacts."""
    u = [u_2, u_1]
    for _ in range(count):
        u.append(step.step([u[-1]], [u[-2]], [0.0], np.zeros((1, 0)), []).u[0])
    return np.array(u[2:])


def test_numerical_damping_is_that_of_backward_differences() -> None:
    """u_i = Re zⁱ, z = 1/(1 − iωτ): 20 Hz lose 6.25 % of critical at 1 ms."""
    omega_tau = 2 * np.pi * 20 * 1e-3
    i = np.arange(1, 201)
    exact = (1 + omega_tau**2) ** (-i / 2) * np.cos(i * np.arctan(omega_tau))
    # 200 steps, each with the round-off of 1 over (ωτ)² = 0.016: 1e-12, ten times that for a sum.
    np.testing.assert_allclose(run_free(spring(), 1.0, 1.0, 200), exact, rtol=0, atol=1e-11)
    decay, angle = 0.5 * np.log1p(omega_tau**2), np.arctan(omega_tau)
    # As many digits as the percentage is given with.
    assert decay / np.hypot(decay, angle) == pytest.approx(0.06254, abs=5e-6)


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


def test_rest_is_the_static_solution() -> None:
    """The beam of the page on its three stops, as a flexibility and as a system in time."""
    length, bending, n = 6.0, 2.0e6, 7  # nodes at 0.75 m … 5.25 m
    x = length * np.arange(1, n + 1) / (n + 1)
    a, b = np.minimum.outer(x, x), np.maximum.outer(x, x)
    F = a * (length - b) * (length**2 - (length - b) ** 2 - a**2) / (6 * length * bending)
    K = np.linalg.inv(F)
    K = (K + K.T) / 2
    C = np.eye(n)[:, [1, 3, 5]]
    d0, p = np.array([0.010, 0.0, 0.0]), -60e3 * np.eye(n)[1]
    system = lcp.PublishedStep(12.0 * np.eye(n), 1e-3 * K, K, 1e-3)
    u_1 = u_2 = np.zeros(n)
    for _ in range(3000):
        step = system.step(u_1, u_2, p, C, d0)
        u_1, u_2 = step.u, u_1
    force, gap, _ = lcp.solve(C.T @ F @ C, d0 + C.T @ F @ p)
    # 3 s of some 3 1/s of decay or more, and the rounding of K, condition number 3e3.
    np.testing.assert_allclose(step.force, force, rtol=1e-6)
    np.testing.assert_allclose(step.gap, gap, rtol=0, atol=1e-9)
    assert (force > 0).tolist() == [True, True, False]


def test_friction_pulls_along() -> None:
    """A block on a floor is accelerated by f g, from the second step on."""
    mass, tau, C, tangent = 3.0, 1e-3, [[0.0], [1.0]], np.array([[1.0], [0.0]])
    zero = np.zeros((2, 2))
    block = lcp.PublishedStep(mass * np.eye(2), zero, zero, tau)
    u_1 = u_2 = np.zeros(2)
    force = np.zeros(1)
    for i in range(20):
        load = [0.0, -9.81 * mass] + tangent @ lcp.friction(0.3, force)
        step = block.step(u_1, u_2, load, C, [0.0])
        # Round-off of u below 1 divided by τ.
        assert (step.u - u_1)[0] / tau == pytest.approx(0.3 * 9.81 * i * tau, abs=1e-12)
        u_1, u_2, force = step.u, u_1, step.force


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
        r"mass: not symmetric: entry \(0, 1\) is 0.5 and entry \(1, 0\) is",
    ),
    ((I2, SKEW, I2, 1), "damping: not symmetric"),
    ((I2, I2, SKEW, 1), "stiffness: not symmetric"),
    ((np.diag([1.0, -2.0]), I2, 9 * I2, 1), "mass: got an eigenvalue of -2"),
    ((I2, I2, -9 * I2, 1), r"A: M/τ² \+ C_d/τ \+ K is not positive definite: pivot -7"),
    ((I2, 0 * I2, [[0, 3], [3, 0]], 1), "A: .* not positive definite: pivot -8"),
    ((0 * I2, 0 * I2, 0 * I2, 1), "A: .* not positive definite: pivot 0"),
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
    ({"contact_map": [[0.0]]}, "contact_map: column 0 is zero: that contact acts on nothing"),
    ({"initial_gap": [[0.0]]}, r"initial_gap: got shape \(1, 1\), expected one dimension"),
    ({"initial_gap": [1j]}, "initial_gap: got complex numbers"),
]


@pytest.mark.parametrize(("change", "message"), BAD_STEPS)
def test_bad_steps_are_named(change, message: str) -> None:
    system = spring()
    for call in (system.problem, system.step):
        with pytest.raises(lcp.LcpInputError, match=message):
            call(**GOOD | change)


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
