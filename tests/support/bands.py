"""A wire on equal springs, in closed form: its bands, and what a force on it moves.

Springs K stand L apart. With what a unit force moves a free wire by (`tests/support/waves.py`),
G = far e^{−ik|x|} + near e^{−κ|x|}, where near has ended long before the next spring, a wave
u_j = u₀ λʲ from spring to spring, λ = e^{−iqL}, needs

    cos qL = C = cos kL + i far sin kL/(1/K + near);   string: cos kL + K sin kL/(2kT)

|C| < 1 is a pass band, |C| > 1 a stop band. A unit force on a spring leaves on the wire there

    R_j = (δ_j + (cos kL − C) 2λ^{|j|}/(1/λ − λ))/(1 + K near)

and so moves any place by Σ R_j G(x − jL). By reciprocity that is what a force there moves the
spring by. Frequencies are taken below the real axis, Ω = ω − iσ: e^{−σt} weighs the record, whose
end then does not count, and |λ| < 1 says which root is which.
"""

from dataclasses import dataclass

import numpy as np

from tests.support.waves import Complex, Floats, Waves

# Springs on each side whose forces are added: λ of the slowest decay, e^{−σL/c}, to this power is
# 1e-13 with σ = 8 1/s, L = 7.2 m.
REACH = 70


@dataclass(frozen=True)
class OnSprings:
    """A wire on springs, N/m, at equal distances, m, along it."""

    wire: Waves
    spring: float
    apart: float

    def cosine(self, omega: Complex) -> Complex:
        """C of each Ω in 1/s."""
        turn = self.wire.number(omega) * self.apart
        far, near = self.wire.far(omega), self.wire.near(omega)
        return np.asarray(np.cos(turn) + 1j * far * np.sin(turn) / (1.0 / self.spring + near))

    def moved(self, omega: Complex, xi: Floats) -> Complex:
        """Motion of spring 0 by a unit force at ξ, m/N: Ω along rows, ξ in m along columns."""
        wire, omega = self.wire, np.asarray(omega)[:, None]
        far, near, k = wire.far(omega), wire.near(omega), wire.number(omega)
        stays = np.sqrt(k**2 + wire.tension / wire.bending)
        cosine, j = self.cosine(omega), np.arange(-REACH, REACH + 1)
        root = np.sqrt(cosine**2 - 1.0)
        wave = np.where(abs(cosine - root) < 1.0, cosine - root, cosine + root)
        on_wire = (np.cos(k * self.apart) - cosine) * 2.0 * wave ** abs(j) / (1.0 / wave - wave)
        on_wire = (on_wire + (j == 0)) / (1.0 + self.spring * near)
        away = abs(np.asarray(xi)[:, None] - self.apart * j)
        waves = far[..., None] * np.exp(-1j * k[..., None] * away)
        waves = waves + near[..., None] * np.exp(-stays[..., None] * away)
        return np.asarray(np.einsum("wxj,wj->wx", waves, on_wire))

    def edges(self, highest: float) -> list[float]:
        """Frequencies in Hz, up to the highest, at which bands begin and end."""
        hertz = np.linspace(0.2, highest, round(2000 * highest))
        beyond = abs(self.cosine(2.0 * np.pi * hertz + 0j).real) > 1.0
        at = np.flatnonzero(beyond[1:] != beyond[:-1])
        return [float(0.5 * (hertz[i] + hertz[i + 1])) for i in at]
