"""Least squares on the logarithm of a receptance: the chain that fits measured values best.

    minimise  Σ_j |ln H(iω_j) − ln H_j|²/ε_j²,   ln H = ln|H| + i arg H

so that 1 % of amplitude counts as much as 0.01 rad of phase, at resonances as between them (F. M.
Sidman, F. E. DeAngelis & G. C. Verghese, IEEE Trans. Automatic Control 36 (1991) 1065). The error
of a measured response is a part of it, and the logarithm makes that an error of equal size
everywhere; an error in H itself would let the highest peak decide. The phases of two passive
receptances both lie in −180° to 0, so their difference has no jump.

Unknowns are ln m, ln k of the springs between masses, and k_1 ≥ 0, c ≥ 0 or L: everything that
they can say is a pantograph. Trust-region steps within bounds: M. A. Branch, T. F. Coleman & Y. Li,
SIAM J. Sci. Comput. 21 (1999) 1, as in SciPy.
"""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.pantograph.receptance.chain import Chain, Damping, with_full_damping

Floats = NDArray[np.float64]
Complex = NDArray[np.complexfloating[Any, Any]]

# Evaluations of the receptance in each of two parts of a search.
MOST_EVALUATIONS = 150
# Evaluations after which only the best starts are followed to their end, and how many those are.
FIRST_EVALUATIONS, FOLLOWED = 20, 2
# Frequencies, evenly out of all, by which starts are told apart.
FIRST_FREQUENCIES = 80
# Relative change of the sum, of the unknowns, and size of the gradient at which a search ends. The
# sum is flat at its minimum: its last digits would cost most of the steps, and change parameters by
# nothing near their ±. Data without noise have a sum that falls until rounding.
ENDS_SUM, ENDS_UNKNOWNS, ENDS_GRADIENT = 1e-9, 1e-12, 1e-14
# Damping ratio of each mass on its spring that a full matrix begins with in addition, as a triangle
# with a column of zeros is a point where the sum of squares is stationary.
EXTRA_DAMPING = 1e-3
# Masses in kg, springs between masses in N/m and dampers in N s/m that a search may come to. A
# strip of carbon has 1 kg, and a whole pantograph 100; on the stiffest spring 1 kg swings at
# 1.6 kHz, which is a rigid joint, and the strongest damper is one from 0.1 Hz on. Wider, and
# a mass that the data do not have would be one that no run can step; tighter, and what is there
# would be cut.
LEAST_MASS, MOST_MASS = 0.05, 1e4
LEAST_STIFFNESS, MOST_STIFFNESS, MOST_DAMPING = 1e-2, 1e8, 1e6


@dataclass(frozen=True, eq=False)
class Target:
    """Measured values.

    Attributes
    ----------
    frequency
        In Hz.
    logarithm
        ln H with phases in rad from −3π/2 to π/2, H in m/N.
    error
        Relative standard deviation of each value, or 1 each where none is known.
    """

    frequency: Floats
    logarithm: Complex
    error: Floats


@dataclass(frozen=True, eq=False)
class Found:
    """A minimum: the chain, half of the sum of squares, and derivatives (residuals × parameters).

    Attributes
    ----------
    chain
        The chain.
    residual
        ln H(iω_j) − ln H_j, not divided by its error: misfit of amplitude, and phase in rad.
    cost
        Σ of the squares with their errors.
    changes
        Derivatives of the residuals over their errors by the parameters of the chain: real parts
        of all frequencies, then imaginary ones.
    ended
        True where the search ended by itself.
    """

    chain: Chain
    residual: Complex
    cost: float
    changes: Floats
    ended: bool


def logarithm(values: Complex) -> Complex:
    """Return ln H with a phase from −3π/2 to π/2, so that −180° has no jump."""
    phase = np.angle(values)
    return np.log(np.abs(values)) + 1j * np.where(phase > np.pi / 2.0, phase - 2.0 * np.pi, phase)


def best(target: Target, starts: Iterable[Chain]) -> Found:
    """Return the best of the minima that are reached from several starts.

    All starts take a few steps by some of the frequencies, and the best of them are followed to
    their end.
    """
    usable = [start for start in starts if np.all(np.isfinite(_residual(start, target)))]
    thin = _thinned(target)
    first = [search(thin, start, FIRST_EVALUATIONS) for start in usable]
    first.sort(key=lambda found: found.cost)
    return min(
        (_to_end(target, found.chain) for found in first[:FOLLOWED]),
        key=lambda found: found.cost,
    )


def _thinned(target: Target) -> Target:
    count = target.frequency.size
    kept = np.unique(np.linspace(0, count - 1, min(count, FIRST_FREQUENCIES)).round().astype(int))
    return Target(target.frequency[kept], target.logarithm[kept], target.error[kept])


def _to_end(target: Target, start: Chain) -> Found:
    """Return the minimum reached from one start.

    A search along a direction that the data hardly determine is slow. It has ended, too, where its
    second part lowers the sum of N squares by less than 1/N of it: a parameter that says nothing
    lowers it by as much on average.
    """
    found = search(target, start, MOST_EVALUATIONS)
    if found.ended:
        return found
    second = search(target, found.chain, MOST_EVALUATIONS)
    still = found.cost - second.cost < second.cost / (2 * target.frequency.size)
    return replace(second, ended=second.ended or still)


def search(target: Target, start: Chain, evaluations: int) -> Found:
    """Return the minimum that is reached from one start."""
    from scipy.optimize import least_squares

    kind, order = start.kind, start.order

    def residuals(x: Floats) -> Floats:
        return _stacked(_residual(_chain(x, order), target) / target.error)

    def changes(x: Floats) -> Floats:
        chain = _chain(x, order)
        return _changes(chain, target) * _inner(chain)

    x = _unknowns(start)
    bounds = _bounds(x, order, kind)
    found = least_squares(
        residuals, np.clip(x, *bounds), changes, bounds=bounds, x_scale="jac",
        ftol=ENDS_SUM, xtol=ENDS_UNKNOWNS, gtol=ENDS_GRADIENT, max_nfev=evaluations,
    )  # fmt: skip
    chain = _chain(found.x, order)
    return Found(
        chain=chain,
        residual=_residual(chain, target),
        cost=2.0 * float(found.cost),
        changes=_changes(chain, target),
        ended=bool(found.status > 0),
    )


def _bounds(x: Floats, order: int, kind: Damping) -> tuple[Floats, Floats]:
    """Return the least and the largest value of each unknown."""
    damper = MOST_DAMPING if kind == "joints" else (MOST_DAMPING / order) ** 0.5
    dampers = np.full(x.size - 2 * order, damper)
    low = np.concatenate([
        np.log(np.repeat([LEAST_MASS, LEAST_STIFFNESS], order)),
        0.0 * dampers if kind == "joints" else -dampers,
    ])  # fmt: skip
    high = np.concatenate([np.log(np.repeat([MOST_MASS, MOST_STIFFNESS], order)), dampers])
    low[order], high[order] = 0.0, MOST_STIFFNESS
    return low, high


def begun_full(chain: Chain) -> Chain:
    """Return a chain with a full damping matrix to begin a search with."""
    full = with_full_damping(chain)
    if chain.kind == "full":
        return full
    own = 2.0 * EXTRA_DAMPING * np.sqrt(chain.mass * np.diag(chain.matrices.stiffness))
    lower = np.linalg.cholesky(full.matrices.damping + np.diag(own)).astype(np.float64)
    return Chain(chain.mass, chain.stiffness, lower)


def _unknowns(chain: Chain) -> Floats:
    springs = np.concatenate([chain.stiffness[:1], np.log(chain.stiffness[1:])])
    lower = chain.damping
    damping = lower if chain.kind == "joints" else lower[np.tril_indices(chain.order)]
    return np.concatenate([np.log(chain.mass), springs, damping])


def _chain(x: Floats, order: int) -> Chain:
    mass, damping = np.exp(x[:order]), x[2 * order :]
    stiffness = np.concatenate([x[order : order + 1], np.exp(x[order + 1 : 2 * order])])
    if order > 1 and damping.size > order:
        lower = np.zeros((order, order))
        lower[np.tril_indices(order)] = damping
        damping = lower
    return Chain(mass, stiffness, damping)


def _inner(chain: Chain) -> Floats:
    """Return the derivatives of the parameters by the unknowns, each of which has its own."""
    factors = np.ones(chain.parameters)
    factors[: chain.order] = chain.mass
    factors[chain.order + 1 : 2 * chain.order] = chain.stiffness[1:]
    return factors


def _residual(chain: Chain, target: Target) -> Complex:
    """Return the misfit of a chain; infinite where a step has led to one without receptance."""
    try:
        found: Complex = logarithm(chain.receptance(target.frequency)) - target.logarithm
    except np.linalg.LinAlgError:
        return np.full(target.frequency.size, np.inf, np.complex128)
    return found


def _changes(chain: Chain, target: Target) -> Floats:
    values, changes = chain.receptance_changes(target.frequency)
    scaled = changes / (values * target.error)[:, None]
    return np.concatenate([scaled.real, scaled.imag])


def _stacked(values: Complex) -> Floats:
    return np.concatenate([values.real, values.imag])
