"""Poles and residues of a measured receptance → a chain of masses to begin a fit with.

Vector fitting (B. Gustavsen & A. Semlyen, IEEE Trans. Power Delivery 14 (1999) 1052): with poles
a_q the linear problem

    Σ r_q/(s − a_q) − H(s) Σ d_q/(s − a_q) = H(s)

is solved in real numbers, weighted by 1/|H|; the zeros of 1 + Σ d_q/(s − a_q), eigenvalues of
A − b dᵀ, are better poles, with signs turned so that they are stable. Each pair of poles is then
read as a mode,

    φ_k²/(ω_k² + 2 ζ_k ω_k s + s²)

and the modes as a chain without damping. The chain of n masses whose head has the frequencies ω_k
and amplitudes φ_k is unique (G. M. L. Gladwell: Inverse Problems in Vibration, 2nd ed., Kluwer
2004, chapter 4): with α, β of the Lanczos process that begins with φ on diag(ω²), from head to base

    m_n = 1/Σφ²,   k_n = α_1 m_n,   m_{i−1} = k_i²/(β² m_i),   k_{i−1} = α m_{i−1} − k_i

Its dampers are those, not negative, that give the modes nearly the measured damping ratios.
"""

from dataclasses import dataclass
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.pantograph.receptance.chain import Chain, Damping, elongations

Floats = NDArray[np.float64]
Complex = NDArray[np.complexfloating[Any, Any]]

# Relocations of the poles: they settle within ten, and more change nothing.
RELOCATIONS = 20
# Damping ratio of the first poles, as recommended by Gustavsen and Semlyen.
FIRST_DAMPING = 0.01
# Least share of the largest φ² that a mode is given: with none it would not be felt at the head,
# and the chain would have no mass for it.
LEAST_SHARE = 1e-3
# Least squared frequency of a mode over the largest: with 0 twice the chain would fall apart.
LEAST_SQUARE = 1e-7
# Damping ratio of a mode without damping at the start, so that its entry of L is not 0, where the
# sum of squares does not change with it.
LEAST_DAMPING = 1e-3
# Shares of a mass that is split, and damping ratios of its two parts against one another.
SPLIT_SHARES, SPLIT_DAMPING = (0.3, 0.7), (0.02, 0.3)


@dataclass(frozen=True, eq=False)
class Modes:
    """Modes as real numbers: ω in rad/s, φ in 1/√kg at the head, damping ratio ζ."""

    omega: Floats
    phi: Floats
    zeta: Floats


def chains(
    frequency: Floats, values: Complex, order: int, damping: Damping = "joints"
) -> list[Chain]:
    """Return chains to begin with, by poles that were first spread evenly and in equal ratios.

    Parameters
    ----------
    frequency, values
        In Hz, and H in m/N.
    order
        Number of masses.
    damping
        ``"full"`` for the damping matrix that gives each mode its damping ratio.
    """
    low, high = float(frequency[0]), float(frequency[-1])
    spread = [np.geomspace(low, high, order + 2)[1:-1], np.linspace(low, high, order + 2)[1:-1]]
    found = [modes(frequency, values, 2.0 * np.pi * omega) for omega in spread]
    return [of_modes(one, damping) for one in found]


def modes(frequency: Floats, values: Complex, omega: Floats) -> Modes:
    """Return the modes of a receptance by vector fitting, begun at ω in rad/s."""
    s, size = 2j * np.pi * frequency, float(2.0 * np.pi * frequency[-1])
    s, poles = s / size, (-FIRST_DAMPING + 1j) * omega / size  # of about 1, for the linear problem
    poles = np.sort_complex(np.concatenate([poles, poles.conj()]))
    weight = 1.0 / np.abs(values)
    for _ in range(RELOCATIONS):
        poles = _relocated(s, values, poles, weight)
    residues = _solved(_terms(s, poles), values, weight)
    return _read(poles, _as_complex(poles, residues), size)


def _pairs(poles: Complex) -> list[int]:
    """Return the places of poles above the real axis; each one's conjugate stands next to it."""
    return [int(place) for place in np.flatnonzero(poles.imag > 0.0)]


def _ordered(poles: Complex) -> Complex:
    """Return poles with those above the real axis directly before their conjugates."""
    upper, real = poles[poles.imag > 0.0], poles[poles.imag == 0.0]
    upper = upper[np.argsort(np.abs(upper))]
    both = np.stack([upper, upper.conj()], axis=1).ravel()
    return np.concatenate([both, np.sort(real)])


def _terms(s: Complex, poles: Complex) -> Complex:
    """Return the functions whose real sums are all real rational functions with these poles."""
    terms = 1.0 / (s[:, None] - poles)
    for place in _pairs(poles):
        one, other = terms[:, place].copy(), terms[:, place + 1].copy()
        terms[:, place], terms[:, place + 1] = one + other, 1j * (one - other)
    return terms


def _solved(terms: Complex, values: Complex, weight: Floats) -> Floats:
    """Return the real coefficients of the weighted least-squares problem."""
    left = np.concatenate([(weight[:, None] * terms).real, (weight[:, None] * terms).imag])
    right = np.concatenate([(weight * values).real, (weight * values).imag])
    length = np.linalg.norm(left, axis=0)
    length[length == 0.0] = 1.0
    found = np.linalg.lstsq(left / length, right, rcond=None)[0]
    scaled: Floats = found / length
    return scaled


def _relocated(s: Complex, values: Complex, poles: Complex, weight: Floats) -> Complex:
    poles = _ordered(poles)
    terms, count = _terms(s, poles), poles.size
    both = np.concatenate([terms, -values[:, None] * terms], axis=1)
    d = _solved(both, values, weight)[count:]
    a, b = np.diag(poles.real), np.ones(count)
    for place in _pairs(poles):
        a[place, place + 1], a[place + 1, place] = poles[place].imag, -poles[place].imag
        b[place], b[place + 1] = 2.0, 0.0
    found = np.linalg.eigvals(a - np.outer(b, d)).astype(np.complex128)
    return _ordered(-np.abs(found.real) + 1j * found.imag)


def _as_complex(poles: Complex, coefficients: Floats) -> Complex:
    residues = coefficients.astype(np.complex128)
    for place in _pairs(poles):
        real, imaginary = coefficients[place], coefficients[place + 1]
        residues[place] = real + 1j * imaginary
        residues[place + 1] = real - 1j * imaginary
    return residues


def _read(poles: Complex, residues: Complex, size: float) -> Modes:
    """Return pairs of poles as modes; real poles are paired in the order of their size."""
    upper = _pairs(poles)
    pairs = [(place, place + 1) for place in upper]
    real = [int(place) for place in np.flatnonzero(poles.imag == 0.0)]
    real.sort(key=lambda place: -poles[place].real)
    pairs += list(zip(real[0::2], real[1::2], strict=True))
    omega, phi, zeta = [], [], []
    for one, other in pairs:
        p, q, r, t = poles[one], poles[other], residues[one], residues[other]
        square = max((p * q).real, 0.0)
        omega.append(square**0.5)
        phi.append(-(r * q + t * p).real)  # numerator of the pair at s = 0
        zeta.append(-(p + q).real / 2.0)  # ζω, as ω may be 0
    w = size * np.maximum(omega, LEAST_SQUARE**0.5 * max(omega))
    share = size * size * np.array(phi)
    share = np.maximum(share, LEAST_SHARE * np.max(np.abs(share)))
    return Modes(w, np.sqrt(share), size * np.array(zeta) / w)


def of_modes(found: Modes, damping: Damping = "joints") -> Chain:
    """Return the chain with the modes' frequencies and amplitudes at its head."""
    order = np.argsort(found.omega)
    omega, phi, zeta = found.omega[order], found.phi[order], found.zeta[order]
    alpha, beta, vectors = _lanczos(omega**2, phi)
    count = omega.size
    mass, stiffness = np.zeros(count), np.zeros(count)
    mass[-1] = 1.0 / float(phi @ phi)
    above = 0.0
    for step, place in enumerate(range(count - 1, -1, -1)):
        stiffness[place] = max(alpha[step] * mass[place] - above, 0.0)
        above = stiffness[place]
        if place > 0:
            mass[place - 1] = above**2 / (beta[step] ** 2 * mass[place])
    # Shapes of the modes in heights of the masses, with φᵀMφ = 1. β > 0 stands for −k/√(m m'), so
    # that every second vector is turned.
    signs = (-1.0) ** np.arange(count)
    shapes = (vectors * signs)[:, ::-1] / np.sqrt(mass)
    if damping == "joints":
        return Chain(mass, stiffness, _dampers(shapes, omega, zeta))
    # C = Σ 2 ζ_k ω_k Mφ_k (Mφ_k)ᵀ, which leaves the modes apart from one another.
    rows = np.sqrt(2.0 * np.maximum(zeta, LEAST_DAMPING) * omega)[:, None] * shapes * mass
    upper: Floats = np.linalg.qr(rows)[1]
    return Chain(mass, stiffness, upper.T)


def _lanczos(squares: Floats, start: Floats) -> tuple[Floats, Floats, Floats]:
    """Return α, β and vectors of the Lanczos process on a diagonal matrix."""
    count = squares.size
    vectors = np.zeros((count, count))
    alpha, beta = np.zeros(count), np.zeros(max(count - 1, 0))
    vectors[:, 0] = start / np.linalg.norm(start)
    for step in range(count):
        new = squares * vectors[:, step]
        alpha[step] = vectors[:, step] @ new
        if step + 1 == count:
            break
        for _ in range(2):  # twice is enough (Parlett: The Symmetric Eigenvalue Problem, 6.9)
            new -= vectors[:, : step + 1] @ (vectors[:, : step + 1].T @ new)
        beta[step] = np.linalg.norm(new)
        vectors[:, step + 1] = new / beta[step]
    return alpha, beta, vectors


def _dampers(shapes: Floats, omega: Floats, zeta: Floats) -> Floats:
    """Return dampers c ≥ 0 in the joints with Σ c_j (e_jᵀφ_k)² nearly 2 ζ_k ω_k for each mode."""
    from scipy.optimize import nnls

    stretched = (shapes @ elongations(omega.size).T) ** 2
    wanted = 2.0 * zeta * omega
    size = np.maximum(wanted, 1e-6 * omega)  # each mode counts by its own damping
    found: Floats = nnls(stretched / size[:, None], wanted / size)[0]
    return found


def split(chain: Chain, frequencies: Floats) -> list[Chain]:
    """Return chains of one mass more: each mass in two parts that swing at each frequency in Hz.

    A stiff spring between them would be the same chain, so that from these starts no order fits
    worse than the one below.
    """
    ways = product(range(chain.order), SPLIT_SHARES, SPLIT_DAMPING, 2.0 * np.pi * frequencies)
    return [_split_at(chain, *way) for way in ways]


def _split_at(chain: Chain, place: int, share: float, ratio: float, omega: float) -> Chain:
    whole = chain.mass[place]
    parts = np.array([1.0 - share, share]) * whole
    reduced = parts[0] * parts[1] / whole
    return Chain(
        np.insert(np.delete(chain.mass, place), place, parts),
        np.insert(chain.stiffness, place + 1, reduced * omega**2),
        np.insert(chain.damping, place + 1, 2.0 * ratio * reduced * omega),
    )
