"""Closed forms of the published step: what swings, falls, rubs and comes to rest."""

import numpy as np
import pytest

from arcless import lcp

GRAVITY = 9.81
FREE = np.zeros((1, 0))  # no contact


def oscillator(mass: float, damping: float, stiffness: float, tau: float) -> lcp.PublishedStep:
    return lcp.PublishedStep([[mass]], [[damping]], [[stiffness]], tau)


def march(
    system: lcp.PublishedStep, u: tuple[float, float], load: float, C: np.ndarray, count: int
) -> list[lcp.Step]:
    """Steps of one degree of freedom from u₋₁ and u₀."""
    u_2, u_1 = u
    steps = []
    for _ in range(count):
        steps.append(system.step([u_1], [u_2], [load], C, np.zeros(C.shape[1])))
        u_2, u_1 = u_1, steps[-1].u[0]
    return steps


def swung(system: lcp.PublishedStep, u: tuple[float, float], count: int) -> np.ndarray:
    """Displacements without loads and contacts."""
    return np.array([step.u[0] for step in march(system, u, 0.0, FREE, count)])


@pytest.mark.parametrize("frequency", [0.5, 20.0, 300.0])
@pytest.mark.parametrize("zeta", [0.0, 0.05, 0.9])
def test_oscillator_follows_its_closed_form(frequency: float, zeta: float) -> None:
    """z = 1/(1 − λτ), λ = −ζω + iω√(1−ζ²): u_i = Re zⁱ from u₀ = 1 and u₋₁ = Re z⁻¹ = 1 + ζΩ."""
    mass, tau, omega = 2.5, 1e-3, 2 * np.pi * frequency
    system = oscillator(mass, 2 * zeta * omega * mass, omega**2 * mass, tau)
    found = swung(system, (1 + zeta * omega * tau, 1.0), 400)
    z = 1 / (1 + omega * tau * (zeta - 1j * np.sqrt(1 - zeta**2)))
    # 400 steps, each with roundings of the size of u, growing with 1/Ω below 1 Hz.
    np.testing.assert_allclose(found, (z ** np.arange(1, 401)).real, rtol=0, atol=1e-10)


def test_numerical_damping_at_20_hz_and_1_ms_is_six_per_cent() -> None:
    """|z| = 1/√(1+Ω²), angle arctan Ω, measured by u_{i+1} + |z|² u_{i−1} = 2 Re z u_i."""
    omega_tau = 2 * np.pi * 20 * 1e-3
    u = swung(oscillator(1.0, 0.0, (omega_tau / 1e-3) ** 2, 1e-3), (1.0, 1.0), 5)
    real, square = np.linalg.solve([[2 * u[1], -u[0]], [2 * u[2], -u[1]]], [u[2], u[3]])
    decay, angle = -0.5 * np.log(square), np.arccos(real / np.sqrt(square))
    exact_decay, exact_angle = 0.5 * np.log1p(omega_tau**2), np.arctan(omega_tau)
    exact = exact_decay / np.hypot(exact_decay, exact_angle)
    # The triples span a hundredth of the amplitude: fourteen digits become about ten.
    assert decay / np.hypot(decay, angle) == pytest.approx(exact, abs=1e-9)
    # As many digits as the percentage is given with.
    assert exact == pytest.approx(0.06254, abs=5e-6)
    # Half of Ω to first order; the period grows by Ω/arctan Ω − 1 = Ω²/3.
    assert exact == pytest.approx(omega_tau / 2, rel=0.01)
    assert omega_tau / angle - 1 == pytest.approx(omega_tau**2 / 3, abs=2e-4)


def test_order_of_convergence_is_one() -> None:
    omega = 7.0

    def error(tau: float) -> float:
        # At rest at time zero: u₋₁ = u₀ up to τ², which is beyond the first order.
        u = swung(oscillator(1.0, 0.0, omega**2, tau), (1.0, 1.0), round(1 / tau))
        return float(abs(u[-1] - np.cos(omega)))

    errors = [error(tau) for tau in (4e-4, 2e-4, 1e-4)]
    # The next term is ωτ of the first: some 3e-3, ten times that in the ratio.
    np.testing.assert_allclose(np.log2(np.divide(errors[:-1], errors[1:])), 1.0, atol=0.03)


def test_mass_on_a_rigid_floor_stays_there() -> None:
    """The floor takes the momentum of the fall, no energy appears, and nothing rebounds."""
    mass, height, tau = 16.0, 0.2, 1e-3
    weight = mass * GRAVITY
    start, floor = (height, height), np.ones((1, 1))
    steps = march(oscillator(mass, 0.0, 0.0, tau), start, -weight, floor, 400)
    u = np.array([step.u[0] for step in steps])
    force = np.array([step.force[0] for step in steps])
    hit = int(np.argmax(force > 0))
    # Velocity after i steps of free fall: −g i τ; height: h − g τ² i(i+1)/2.
    i = np.arange(1, hit + 2)
    fall = height - 0.5 * GRAVITY * tau**2 * i * (i + 1)
    # Rounding of up to 1e3 steps.
    np.testing.assert_allclose(u[:hit], fall[:-1], rtol=0, atol=1e-12)
    assert fall[-1] < 0, "no step earlier than the floor is reached"
    assert all(step.gap[0] == 0 for step in steps[hit:])
    assert np.abs(u[hit:]).max() < 1e-15
    # The weight remains; rounding of 1 over τ².
    np.testing.assert_allclose(force[hit + 2 :], weight, rtol=0, atol=1e-9)
    # Two steps take the momentum of the fall: to the floor, then to rest.
    assert (force[hit : hit + 2] > 0).all()
    impulse = tau * (force.sum() - weight * (len(steps) - hit))
    assert impulse == pytest.approx(weight * hit * tau, rel=1e-9)
    velocity = np.diff(u) / tau
    energy = np.append(weight * height, 0.5 * mass * velocity**2 + weight * u[1:])
    assert np.diff(energy).max() <= 1e-12 * weight * height


def test_friction_pulls_along() -> None:
    """A block on a floor is accelerated by f g, from the second step on."""
    mass, tau, C, tangent = 3.0, 1e-3, [[0.0], [1.0]], np.array([[1.0], [0.0]])
    zero = np.zeros((2, 2))
    block = lcp.PublishedStep(mass * np.eye(2), zero, zero, tau)
    u_1 = u_2 = np.zeros(2)
    force = np.zeros(1)
    for i in range(50):
        load = [0.0, -GRAVITY * mass] + tangent @ lcp.friction(0.3, force)
        step = block.step(u_1, u_2, load, C, [0.0])
        # Round-off of u below 1 divided by τ.
        assert (step.u - u_1)[0] / tau == pytest.approx(0.3 * GRAVITY * i * tau, abs=1e-12)
        u_1, u_2, force = step.u, u_1, step.force


def settled(
    system: lcp.PublishedStep, p: np.ndarray, C: np.ndarray, d0: np.ndarray, count: int
) -> lcp.Step:
    u_1 = u_2 = np.zeros(system.size)
    for _ in range(count):
        step = system.step(u_1, u_2, p, C, d0)
        u_1, u_2 = step.u, u_1
    return step


def test_rest_of_a_beam_is_the_static_solution() -> None:
    """The beam of the page on its three stops, as a flexibility and as a system in time."""
    length, bending, n = 6.0, 2.0e6, 7  # nodes at 0.75 m … 5.25 m
    x = length * np.arange(1, n + 1) / (n + 1)
    a, b = np.minimum.outer(x, x), np.maximum.outer(x, x)
    F = a * (length - b) * (length**2 - (length - b) ** 2 - a**2) / (6 * length * bending)
    K = np.linalg.inv(F)
    K = (K + K.T) / 2
    C = np.eye(n)[:, [1, 3, 5]]
    d0, p = np.array([0.010, 0.0, 0.0]), -60e3 * np.eye(n)[1]
    step = settled(lcp.PublishedStep(12.0 * np.eye(n), 1e-3 * K, K, 1e-3), p, C, d0, 3000)
    force, gap, _ = lcp.solve(C.T @ F @ C, d0 + C.T @ F @ p)
    # 3 s of some 3 1/s of decay or more, and the rounding of K, condition number 3e3.
    np.testing.assert_allclose(step.force, force, rtol=1e-6)
    np.testing.assert_allclose(step.gap, gap, rtol=0, atol=1e-9)
    assert (force > 0).tolist() == [True, True, False]


def test_rest_of_springs_is_the_static_solution() -> None:
    """A chain of springs between two walls over three stops, pressed down."""
    n = 6
    K = 1e4 * (2 * np.eye(n) - np.eye(n, k=1) - np.eye(n, k=-1))
    C = np.eye(n)[:, [0, 2, 5]]
    d0, p = np.array([1e-3, 4e-3, 10e-3]), np.full(n, -20.0)
    step = settled(lcp.PublishedStep(2 * np.eye(n), 50 * np.eye(n), K, 1e-3), p, C, d0, 4000)
    still = np.linalg.solve(K, p)
    force, gap, _ = lcp.solve(C.T @ np.linalg.solve(K, C), d0 + C.T @ still)
    assert force.max() > 0
    assert gap.max() > 0
    # Damped with some 12 1/s for 4 s: e⁻⁵⁰ of the start remains, so this is rounding over τ².
    np.testing.assert_allclose(step.force, force, rtol=0, atol=1e-8 * force.max())
    np.testing.assert_allclose(step.gap, gap, rtol=0, atol=1e-8 * gap.max())
