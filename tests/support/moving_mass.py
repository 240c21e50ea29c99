"""Wave that a mass moving along a string throws back ahead, in closed form.

A wave e^{i(ωt + kx)} that comes from ahead moves the place of the mass with ω' = ω + kV. The string
gives a force f there f/(2iω'Z), so the mass pushes with −D y/(1 + D/(2iω'Z)), and what goes ahead
has the ω for which ω − kV = ω'. Derived here.
"""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq

from tests.support.waves import Complex, Floats, Waves, balanced, spectrum


@dataclass(frozen=True)
class MovingMass:
    """A mass in kg behind a contact of some N/m, at some m/s; time steps in s."""

    waves: Waves
    speed: float
    step: float
    mass: float
    contact: float

    def number(self, omega: Floats) -> Floats:
        """k of a wave in the run, 1/m."""
        return self.waves.number(balanced(omega, self.step))

    def came(self, seen: Floats) -> Floats:
        """ω of the waves that the mass meets as ω'."""

        def off(omega: float, one: float) -> float:
            return omega + float(self.number(np.array(omega))) * self.speed - one

        return np.array([brentq(off, 0.0, one, args=(one,)) for one in seen])

    def thrown_back(
        self, omega: Floats, time: Floats, force: Floats, source: float, watched: float
    ) -> Complex:
        """Spectrum at a place of what is thrown back of a wave that a force sends.

        Source and place are so many m ahead of where the mass starts.
        """
        k, step = self.number(omega), self.step
        seen = omega - k * self.speed
        came = self.came(seen)
        # dω'/dω of the wave that comes in: 1 + V/c but for the time step.
        denser = 1.0 + self.speed / self.waves.speed / np.cos(0.5 * came * step) ** 2
        sent = spectrum(time, force, came) * self.waves.far(balanced(came, step))
        moved = sent * np.exp(-1j * self.number(came) * source) / denser
        own = balanced(seen, step)
        stiff = 1.0 / (1.0 / self.contact - 1.0 / (self.mass * own**2))
        answer = -stiff * moved / (1.0 + stiff / (2j * own * self.waves.impedance))
        ahead = self.waves.far(balanced(omega, step)) * np.exp(-1j * k * watched)
        return np.asarray(answer * ahead)
