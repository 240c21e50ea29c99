"""Harmonic waves on wires in closed form, and how they are read from a run.

A wire under the tension T, as the equations of the elements have it (x in space, s the stretch, μ
and EI per metre without tension):

    (μ/s) ü + (EI/s) u'''' − T u'' = f,   T k² + (EI/s) k⁴ = (μ/s) ω²,   κ² = k² + T s/EI

A unit force e^{iωt} at x = 0 of a wire without ends moves it by

    G(x) = (e^{−ik|x|}/(2ik) − e^{−κ|x|}/(2κ)) s/(EI (k² + κ²)),   without EI: e^{−ik|x|}/(2ikT)

which has no kink (G' = 0 at both sides of the force) and jumps by 1 in (EI/s) G'''.

The trapezoidal rule replaces d/dt by (2/h)(z − 1)/(z + 1), z = e^{iωh}. All it does to a wave is to
move it as one of Ω = (2/h) tan(ωh/2) should: so closed forms are taken at Ω, and what is left is
the error of the elements.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from arcless.mesh.division import wires
from arcless.model.line.parts.components import Wire

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]


def balanced(omega: Floats, step: float) -> Floats:
    """Ω = (2/h) tan(ωh/2), 1/s."""
    return np.asarray(2.0 / step * np.tan(0.5 * omega * step))


def spectrum(time: Floats, values: Floats, omega: Floats) -> Complex:
    """∫ u e^{−iωt} dt of a motion that begins and ends at rest: by the trapezoidal rule, which is
    exact to rounding for what is smooth."""
    step = time[1] - time[0]
    return np.asarray(step * np.exp(-1j * np.outer(omega, time)) @ values)


def pulse(time: Floats, middle: float, width: float, size: float) -> Floats:
    """Force whose integral is a bell of the given width in s (standard deviation)."""
    t = (time - middle) / width
    return np.asarray(-size * t * np.exp(0.5 - 0.5 * t * t))


@dataclass(frozen=True)
class Waves:
    """Waves on a wire of cubic elements, which is a continuum where the elements are short.

    Attributes
    ----------
    tension, density, bending : T in N, μ/s in kg/m, EI/s in N·m²
    """

    tension: float
    density: float
    bending: float

    @classmethod
    def on(cls, kind: Wire) -> "Waves":
        """Take over a wire, whose mass and bending stiffness are those without tension."""
        s = wires.stretch(kind)
        return cls(kind.tension, kind.mass / s, kind.bending_stiffness / s)

    @property
    def speed(self) -> float:
        """Speed of long waves, m/s."""
        return float(np.sqrt(self.tension / self.density))

    @property
    def impedance(self) -> float:
        """√(Tμ) of long waves, N·s/m."""
        return float(np.sqrt(self.tension * self.density))

    def number(self, omega: Floats) -> Floats:
        """k, 1/m."""
        if self.bending == 0.0:
            return np.asarray(omega / self.speed)
        root = np.sqrt(self.tension**2 + 4.0 * self.bending * self.density * omega**2)
        # As a quotient: the difference root − T would lose digits.
        return np.asarray(omega * np.sqrt(2.0 * self.density / (self.tension + root)))

    def far(self, omega: Floats) -> Complex:
        """Share of G that travels, at x = 0, m/N."""
        k = self.number(omega)
        if self.bending == 0.0:
            return np.asarray(1.0 / (2j * k * self.tension))
        return np.asarray(1.0 / (2j * k * (2.0 * self.bending * k**2 + self.tension)))

    def near(self, omega: Floats) -> Complex:
        """Share of G that stays, at x = 0, m/N."""
        k = self.number(omega)
        if self.bending == 0.0:
            return np.zeros_like(k, dtype=np.complex128)
        kappa = np.sqrt(k**2 + self.tension / self.bending)
        stiff = 2.0 * self.bending * k**2 + self.tension
        return np.asarray(-1.0 / (2.0 * kappa * stiff) + 0j)

    def power(self, omega: Floats) -> Floats:
        """Power that a wave of the amplitude 1 m carries, W/m²: ½ ω (T k + 2 EI k³)."""
        k = self.number(omega)
        return np.asarray(0.5 * omega * (self.tension * k + 2.0 * self.bending * k**3))

    def reflection(self, stiffness: Complex, omega: Floats) -> Complex:
        """Wave that comes back from a point held by a force −D u, over the one that comes in.

        The wire gives the force D u, so u = 1/(1 + D G(0)): r = −D far/(1 + D (far + near)). What
        goes on is 1 + r.
        """
        far, near = self.far(omega), self.near(omega)
        return np.asarray(-stiffness * far / (1.0 + stiffness * (far + near)))


@dataclass(frozen=True)
class Lattice(Waves):
    """Waves on a chain of point masses at equal distances, without bending stiffness.

    T (2 − 2 cos kh)/h = (μ/s) h Ω², h the distance: short waves are slow (from memory: Brillouin,
    Wave propagation in periodic structures, 1946). A unit force moves its mass by h/(2iT sin kh).
    """

    distance: float

    @classmethod
    def of(cls, kind: Wire, distance: float) -> "Lattice":
        """Take over a wire whose masses are so many m apart."""
        assert kind.bending_stiffness == 0.0
        density = kind.mass / wires.chain_stretch(kind)
        return cls(kind.tension, density, 0.0, distance)

    def number(self, omega: Floats) -> Floats:
        """k, 1/m."""
        half = 0.5 * self.distance * omega / self.speed
        return np.asarray(2.0 / self.distance * np.arcsin(half))

    def far(self, omega: Floats) -> Complex:
        """Share of G that travels, at x = 0, m/N."""
        kh = self.number(omega) * self.distance
        return np.asarray(self.distance / (2j * self.tension * np.sin(kh)))

    def power(self, omega: Floats) -> Floats:
        """Power that a wave of the amplitude 1 m carries, W/m²."""
        kh = self.number(omega) * self.distance
        return np.asarray(0.5 * omega * self.tension * np.sin(kh) / self.distance)
