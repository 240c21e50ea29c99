"""Harmonic waves on chains under explicit steps, as the steps have them.

With K = 4 sin² (kℓ/2), θ = ωh and the filter F = 1 + a K + b K² of all forces
(docs/theory/dynamics.md, explicit steps), a force on a point moves it by

    u = cos² (θ/2)/(2π μℓ) ∫ F/(F (T/μℓ²)(K + ε* K²) − (4/h²) sin² (θ/2)) d(kℓ)

cos² (θ/2) takes the predictor y to the end of the step, u = y + h²a/4. Partial fractions in K make
of it a sum over the four roots Kᵢ = 2 − 2 cos κᵢ of the denominator, each with e^{−iκ}/(2i sin κ)
for the point and κ in the half-plane of decay: one travels, the others stay.

Damping takes the velocity of the last increment, σ = (1 − e^{−iθ})/h: with it, waves obey

    F ((T/μℓ²)(K + ε* K²)(1 + βσ) + ασ) = (4/h²) sin² (θ/2)

A spring, damper and what else is implicit see places and velocities at the end of the step,
i (2/h) tan (θ/2) apart, `tests.support.waves.balanced`.

EI counts per unstretched length in a chain (docs/theory/wires.md): s³ EI per metre in space, s the
stretch.
"""

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import Polynomial

from arcless.mesh.division import wires
from arcless.model.line.parts.components import Wire
from tests.support.waves import Complex, Floats, Waves

# Largest b: docs/theory/dynamics.md.
MOST = 1.0 / 30.0


def of_chain(kind: Wire) -> Waves:
    """Waves of the continuum that a chain tends to as its elements shrink."""
    s = wires.chain_stretch(kind)
    return Waves(kind.tension, kind.mass / s, kind.bending_stiffness * s**3)


@dataclass(frozen=True)
class Stepped(Waves):
    """Waves on a chain under explicit steps.

    Attributes
    ----------
    distance, step : ℓ in m and h in s
    stretch : ℓ over the unstretched length, by which the filter measures bending: it sees ε and ε*
        too small by that share
    alpha, beta : damping, 1/s and s
    """

    distance: float
    step: float
    stretch: float
    alpha: float = 0.0
    beta: float = 0.0

    @classmethod
    def of(cls, kind: Wire, distance: float, step: float) -> "Stepped":
        """Take over a wire whose masses are so many m apart."""
        wire = of_chain(kind)
        damping = kind.damping.alpha, kind.damping.beta
        numbers = distance, step, wires.chain_stretch(kind)
        return cls(wire.tension, wire.density, wire.bending, *numbers, *damping)

    @property
    def shares(self) -> tuple[float, float, float]:
        """C², ε and ε*."""
        courant = (self.speed * self.step / self.distance) ** 2
        if self.bending == 0.0:
            return courant, 0.0, 0.0
        wire = self.bending / (self.tension * self.distance**2) / self.stretch
        x = 0.5 / np.sqrt(wire)
        return courant, wire, wire * float(x / np.tanh(x))

    @property
    def missing(self) -> float:
        """R of a point, m/N, by unstretched lengths: what the wire yields beyond the chain."""
        _, wire, chain = self.shares
        if chain == 0.0:
            return 0.0
        mu = 2.0 * np.arcsinh(0.5 / np.sqrt(chain))
        unstretched = self.distance / self.stretch
        return float(0.5 * unstretched * (1.0 / np.sinh(mu) - np.sqrt(wire)) / self.tension)

    def stiffened(self, stiffness: float) -> float:
        """Return k' in N/m of a spring k on a point: 1/k' = 1/k + R."""
        return stiffness / (1.0 + stiffness * self.missing)

    @property
    def filter(self) -> tuple[float, float]:
        """Return a and b."""
        courant, wire, chain = self.shares
        a = (1.0 - courant) / 12.0 - (chain - wire)
        b = (chain + a) / 6.0 - a * chain - (1.0 - courant**2) / 360.0 - courant * wire / 6.0
        return a, min(max(b, 0.0), MOST)

    def louder(self, omega: Floats) -> Floats:
        """Return the wave by a force on a point over the wave along the wire, up to (kℓ)⁴."""
        courant, wire, chain = self.shares
        more = (1.0 - 2.0 * courant) / 12.0 - (chain - wire)
        return np.asarray(1.0 + more * (self.distance * super().number(omega)) ** 2)

    def number(self, omega: Floats) -> Complex:
        """k, 1/m; complex where the wire is damped."""
        return np.array([self._roots(one)[1][0] for one in omega]) / self.distance

    def far(self, omega: Floats) -> Complex:
        """Share of the answer that travels, m/N."""
        return np.array([self._answers(one)[0] for one in omega])

    def near(self, omega: Floats) -> Complex:
        """Share of the answer that stays, m/N."""
        return np.array([self._answers(one)[1:].sum() for one in omega])

    def balance(self, omega: float) -> tuple[Polynomial, Polynomial]:
        """F, and the denominator, both in K."""
        _, _, chain = self.shares
        filtered = Polynomial([1.0, *self.filter])
        sigma = (1.0 - np.exp(-1j * omega * self.step)) / self.step
        unit = self.tension / (self.density * self.distance**2)
        forces = unit * Polynomial([0.0, 1.0, chain * self.stretch]) * (1.0 + self.beta * sigma)
        inertia = (2.0 / self.step * np.sin(0.5 * omega * self.step)) ** 2
        return filtered, filtered * (forces + self.alpha * sigma) - inertia

    def _roots(self, omega: float) -> tuple[Complex, Complex]:
        """K and κ, the wave first."""
        found = self.balance(omega)[1].trim(1e-9).roots() + 0j
        found = found[np.argsort(abs(found - (self.distance * omega / self.speed) ** 2))]
        kappa = 2.0 * np.arcsin(0.5 * np.sqrt(found))
        # The wave runs away from the force, the others fade.
        turned = np.where(kappa.imag > 0.0, -kappa, kappa)
        turned[0] = kappa[0] if kappa[0].real > 0.0 else -kappa[0]
        return found, turned

    def _answers(self, omega: float) -> Complex:
        """Shares of the four roots in the answer of a point."""
        filtered, below = self.balance(omega)
        found, kappa = self._roots(omega)
        at_end = np.cos(0.5 * omega * self.step) ** 2 / (self.density * self.distance)
        return np.asarray(at_end * filtered(found) / below.deriv()(found) / (2j * np.sin(kappa)))

    def reflection_of_mass(self, mass: float, omega: Floats) -> Complex:
        """Wave that comes back from a mass in kg on a point, over the one that comes in."""
        return np.array([self._from_mass(mass, one) for one in omega])

    def _from_mass(self, mass: float, omega: float) -> complex:
        filtered, below = self.balance(omega)
        found, kappa = self._roots(omega)
        answers = 1.0 / below.deriv()(found) / (2j * np.sin(kappa))
        own = self.density * self.distance
        heavier, more = mass / own, filtered(found) - 1.0
        inertia = (2.0 / self.step * np.sin(0.5 * omega * self.step)) ** 2
        forces = (below + inertia)(found) / filtered(found)
        # For y and w of the point, with the wave 1 that comes in.
        of_forces = (answers * forces).sum()
        filtered_forces = 1.0 + inertia * answers.sum() - of_forces
        equations = [
            [1.0 - heavier * inertia * answers.sum(), heavier * (answers * more).sum()],
            [heavier * inertia * of_forces, 1.0 + heavier - heavier * filtered_forces],
        ]
        y, w = np.linalg.solve(equations, [1.0, -forces[0]])
        return complex(-heavier * (more[0] * w - inertia * y) * answers[0])
