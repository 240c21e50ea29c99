"""Bending of a wire under tension at a point force.

The deflection of a stiff string under the force P at x = 0 is

  EI w⁗ − T w″ = P δ(x),   w″(x) = −P/(2 √(T EI)) e^(−λ|x|),   λ = √(T/EI)

the corner P/T of a string, rounded over 1/λ, some 8 cm. The moment at the clamp is √(T EI) times
half of the corner, and the stress of the outer fibre

  σ = E r |w″|

Elements are several times as long as 1/λ, so that curvatures of a mesh miss this layer; it follows
from the force alone. What bends the wire between clamps, waves and its weight, is not in it.

Under a force that moves at the speed v the string has the tension T − μ v² in its place (steady
motion, v below the wave speed √(T/μ)).
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from arcless.errors import ModelError
from arcless.model.line.wire_section import WireSection

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class StiffString:
    """A wire under tension.

    Attributes
    ----------
    section
        Its cross-section.
    tension
        T in N.
    mass
        μ in kg/m.
    """

    section: WireSection
    tension: float
    mass: float

    @property
    def axial_stress(self) -> float:
        """Stress T/A in Pa."""
        return self.tension / self.section.area

    def moving_tension(self, speed: float) -> float:
        """Return T − μ v² in N, which a force at the speed v in m/s finds.

        Raises
        ------
        ModelError
            The speed is that of waves or above.
        """
        left = self.tension - self.mass * speed**2
        if left <= 0.0:
            wave = (self.tension / self.mass) ** 0.5
            raise ModelError(
                "wire stress", got=f"a speed of {3.6 * speed:.0f} km/h",
                expected=f"below the wave speed, {3.6 * wave:.0f} km/h",
                hint=f"the tension is {self.tension:g} N: one in kN needs its unit",
            )  # fmt: skip
        return left

    def stress_per_newton(self, speed: float = 0.0) -> float:
        """Return E r/(2 √(T EI)) in Pa/N, at a force that moves at a speed in m/s."""
        section = self.section
        root = np.sqrt(self.moving_tension(speed) * section.bending_stiffness)
        return float(section.modulus * section.half_height / (2.0 * root))

    def layer(self, speed: float = 0.0) -> float:
        """Return the length 1/λ in m over which the corner under a force is rounded."""
        return float(np.sqrt(self.section.bending_stiffness / self.moving_tension(speed)))
