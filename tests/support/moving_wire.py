"""A wire without ends under a force that runs along it, in closed form, and what rides on it.

With ξ = x − Vt from the force, a wire under tension that resists bending, on springs κ per metre:

    EI w'''' − T w'' + μ (∂t − V ∂ξ)² w + κ w = e^{iΩt} δ(ξ)
    D(k) = EI k⁴ + T k² − μ (Ω + Vk)² + κ = 0,   w = e^{i(Ωt − kξ)}
    H(ξ) = −i Σ e^{−ikξ}/D'(k),   k in the lower half-plane for ξ ≥ 0 (+i Σ, upper, for ξ < 0)

with Ω − i0, which lets waves run away from the force. Without EI

    1/H(0) = 2 √(κ (T − μV²) − μTΩ²),   without κ as well iΩZ, Z = 2√(Tμ), at any V < c

A mass M that a force f lifts, on a spring K and a damper C to a roof, with a contact of k N/m:

    P = (f − D_M z_w)/(1 + D_M (1/k + H))   with D_M = K + iΩC − MΩ²,   z_w the wire without contact

Derived here. Times are found by a sum over Ω on a line below the real axis, on which H has no pole.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from tests.support.waves import Complex, Floats, Waves

# Distance of the line from the real axis, 1/s: what goes round in a record of 4 s has e⁻³² of it.
BELOW = 8.0
SAMPLES, FINE = 1 << 15, 1.25e-4  # s
LINE = 2.0 * np.pi * np.fft.rfftfreq(SAMPLES, FINE) - 1j * BELOW


@dataclass(frozen=True)
class MovingWire:
    """A wire under a force at some m/s; κ is in N/m²."""

    wire: Waves
    speed: float
    foundation: float = 0.0

    def answer(self, omega: Complex, xi: float = 0.0) -> Complex:
        """H at ξ in m for each Ω in 1/s, m/N."""
        return _on_line(self, xi) if omega is LINE else self._answer(omega, xi)

    def _answer(self, omega: Complex, xi: float) -> Complex:
        w, v = self.wire, self.speed
        # Ω on the real axis is taken for Ω − i0.
        omega = np.atleast_1d(omega).astype(complex)
        omega = np.where(omega.imag == 0.0, omega * (1.0 - 1e-9j), omega)
        below = [w.bending, 0.0, w.tension - w.density * v * v, -2.0 * w.density * v * omega,
                 self.foundation - w.density * omega**2]  # fmt: skip
        below = below if w.bending else below[2:]
        roots = _roots(below)
        slopes = sum(
            (len(below) - 1 - n) * np.asarray(own)[..., None] * roots ** (len(below) - 2 - n)
            for n, own in enumerate(below[:-1])
        )
        behind = xi >= 0.0
        kept = roots.imag < 0.0 if behind else roots.imag > 0.0
        shares = np.where(kept, np.exp(np.where(kept, -1j * roots * xi, 0.0)) / slopes, 0.0)
        return np.asarray((-1j if behind else 1j) * shares.sum(axis=1))

    def stiffness(self, omega: Floats) -> Complex:
        """1/H(0) of a wire without bending stiffness, N/m."""
        w, v = self.wire, self.speed
        held = self.foundation * (w.tension - w.density * v * v)
        return np.asarray(2.0 * np.sqrt(held - w.tension * w.density * omega**2 + 0j))

    def kink(self, omega: Complex, force: float) -> Complex:
        """Spectrum of the height, over time, of a wire pulled up by a force at x = 0, m s."""
        k = omega / self.speed
        w = self.wire
        return np.asarray(force / (w.tension * k**2 + w.bending * k**4) / self.speed)


@dataclass(frozen=True)
class Head:
    """A mass, kg, on a contact (N/m); a spring and a damper to the roof, N/m and N s/m."""

    mass: float
    contact: float = np.inf
    spring: float = 0.0
    damper: float = 0.0

    def held(self, omega: Complex) -> Complex:
        """D of the head, N/m."""
        return np.asarray(self.spring + 1j * omega * self.damper - self.mass * omega**2)

    def pressed(
        self, line: MovingWire, omega: Complex, *, force: Complex, wire: Complex
    ) -> Complex:
        """Spectrum of the contact force under a force on the head and over a wire that is bent."""
        own = self.held(omega)
        yields = 1.0 / self.contact + line.answer(omega)
        return np.asarray((force - own * wire) / (1.0 + own * yields))

    def roots(self, impedance: float) -> Complex:
        """s of s² + (k/Z) s + k/M = 0: of a string, the slower one first; rigid, −Z/M alone."""
        if np.isinf(self.contact):
            return np.array([-impedance / self.mass + 0j])
        half, own = 0.5 * self.contact / impedance, self.contact / self.mass
        root = np.sqrt(half**2 - own + 0j)
        return np.array([-half + root, -half - root])


@lru_cache
def _on_line(wire: MovingWire, xi: float) -> Complex:
    """H on the line, which many sizes of elements ask for."""
    return wire._answer(LINE, xi)


def over_time(spectrum: Callable[[Complex], Complex], time: Floats, before: float = 1.0) -> Floats:
    """Bring a spectrum to the given times, s; nothing has happened `before` time zero, s.

    The spectrum must hold on the line Ω − iσ, and fall with 1/Ω² at least.
    """
    values = np.fft.irfft(spectrum(LINE) * np.exp(-1j * LINE * before), SAMPLES) / FINE
    fine = FINE * np.arange(SAMPLES)
    values *= np.exp(BELOW * fine)
    return np.asarray(np.interp(time + before, fine, values))


def _roots(below: list[Complex]) -> Complex:
    """Roots of many polynomials at once, highest power first."""
    size = len(below) - 1
    shape = np.broadcast_shapes(*(np.shape(own) for own in below))
    companion = np.zeros((*shape, size, size), dtype=complex)
    for n, own in enumerate(below[1:]):
        companion[..., 0, n] = -own / below[0]
    companion[..., np.arange(1, size), np.arange(size - 1)] = 1.0
    return np.asarray(np.linalg.eigvals(companion))
