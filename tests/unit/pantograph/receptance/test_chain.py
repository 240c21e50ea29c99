"""Receptance of a chain and its derivatives, poles, and chains that have given modes."""

import numpy as np
import pytest

from arcless.pantograph.receptance import start
from arcless.pantograph.receptance.chain import Chain, with_full_damping
from tests.support.receptances import FREQUENCIES, receptance

MASS, STIFFNESS = np.array([6.0, 9.0, 7.5]), np.array([160.0, 15500.0, 7000.0])
JOINTS = Chain(MASS, STIFFNESS, np.array([100.0, 0.1, 45.0]))
LOWER = np.array([[9.0, 0.0, 0.0], [1.0, 5.0, 0.0], [-0.5, -6.0, 2.0]])
FULL = Chain(MASS, STIFFNESS, LOWER)
F = np.array([0.3, 2.0, 5.6, 11.0, 24.0])


def moved(chain: Chain, place: int, share: float) -> tuple[Chain, float]:
    """Return a chain with one parameter changed by a share of it, and that change."""
    full = chain.kind == "full"
    damping = chain.damping[np.tril_indices(3)] if full else chain.damping
    values = np.concatenate([chain.mass, chain.stiffness, damping])
    step = share * values[place]
    values[place] += step
    lower = values[6:]
    if full:
        lower = np.zeros((3, 3))
        lower[np.tril_indices(3)] = values[6:]
    return Chain(values[:3], values[3:6], lower), float(step)


def test_it_is_the_shipped_pantograph() -> None:
    # Two ways of the same solution: rounding, of matrices that are far from singular.
    np.testing.assert_allclose(JOINTS.receptance(FREQUENCIES), receptance("ac-simple"), rtol=1e-12)


@pytest.mark.parametrize("chain", [JOINTS, FULL], ids=["joints", "full"])
def test_derivatives_are_those_of_differences(chain: Chain) -> None:
    values, changes = chain.receptance_changes(F)
    _, of_poles = chain.poles()
    assert changes.shape == (F.size, chain.parameters)
    for place in range(chain.parameters):
        (up, step), (down, _) = moved(chain, place, 1e-4), moved(chain, place, -1e-4)
        # Central differences with 1e-4: second order, 1e-8 of the value times what it bends by.
        np.testing.assert_allclose(
            (up.receptance(F) - down.receptance(F)) / (2 * step), changes[:, place],
            rtol=1e-5, atol=1e-6 * np.abs(values).min() / abs(step),
        )  # fmt: skip
        np.testing.assert_allclose(
            (up.poles()[0] - down.poles()[0]) / (2 * step), of_poles[:, place],
            rtol=1e-5, atol=1e-7 / abs(step),
        )  # fmt: skip


def test_a_full_matrix_may_be_that_of_dampers_in_joints() -> None:
    dampers = Chain(MASS, STIFFNESS, np.array([100.0, 0.0, 45.0]))
    # Rounding.
    np.testing.assert_allclose(
        with_full_damping(dampers).receptance(F), dampers.receptance(F), rtol=1e-12
    )


def test_modes_give_the_chain_back() -> None:
    parts = Chain(MASS, STIFFNESS, np.zeros(3)).matrices
    half = np.diag(1.0 / np.sqrt(MASS))
    squares, vectors = np.linalg.eigh(half @ parts.stiffness @ half)
    phi = np.abs((half @ vectors)[-1])
    found = start.of_modes(start.Modes(np.sqrt(squares), phi, np.array([0.02, 0.03, 0.04])))
    # Rounding, times the ratio of the squared frequencies.
    np.testing.assert_allclose(found.mass, MASS, rtol=1e-10)
    np.testing.assert_allclose(found.stiffness, STIFFNESS, rtol=1e-9)
    full = start.of_modes(start.Modes(np.sqrt(squares), phi, np.array([0.02, 0.03, 0.04])), "full")
    poles = full.poles()[0]
    np.testing.assert_allclose(-poles.real / np.abs(poles), [0.02, 0.03, 0.04], rtol=1e-9)


def test_vector_fitting_finds_modes_of_light_damping() -> None:
    chain = Chain(MASS, STIFFNESS, np.array([1.0, 1.0, 1.0]))
    poles = chain.poles()[0]
    values = chain.receptance(FREQUENCIES)
    found = start.modes(FREQUENCIES, values, 2 * np.pi * np.array([1.0, 4.0, 15.0]))
    # The receptance is rational with these poles: what is left is rounding of the linear problem.
    np.testing.assert_allclose(np.sort(found.omega), np.sort(np.abs(poles)), rtol=1e-7)
