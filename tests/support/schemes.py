"""Time-stepping schemes as their papers give them, for steps z = u_{n+1}/u_n; not the program's.

Chung & Hulbert (1993), equations 12 to 15, for an acceleration that grows by z in every step:

    u (z - 1) = h v + h^2 (1/2 - beta + beta z) a        v (z - 1) = h (1 - gamma + gamma z) a
    M (alpha_m + (1 - alpha_m) z) a + (alpha_f + (1 - alpha_f) z) (C v + K u - F) = 0

so that K + s C + q M = F/u, with the s and q below: the scheme's own rate and its square.
"""

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import Polynomial
from numpy.typing import NDArray

Complex = NDArray[np.complex128]


@dataclass(frozen=True)
class Member:
    """Parameters of a member of the family; `published` are one-sided differences instead.

    `name` and `numbers` are what the core is asked for, `settings` what a scenario says.
    """

    name: str
    numbers: tuple[float, ...]
    beta: float = 0.0
    gamma: float = 0.0
    alpha_m: float = 0.0
    alpha_f: float = 0.0

    @property
    def published(self) -> bool:
        """True for the scheme of one-sided differences."""
        return self.name == "backward-difference"

    @property
    def label(self) -> str:
        """Name and parameters, as rows of the evidence call it."""
        return " ".join([self.name, *(f"{number:g}" for number in self.numbers)])

    @property
    def settings(self) -> dict[str, str | float]:
        """The scheme in the words of a scenario."""
        keys = {
            "generalised-alpha": ("spectral_radius",),
            "hht": ("alpha",),
            "newmark": ("beta", "gamma"),
        }.get(self.name, ())
        # A scenario counts alpha from −1/3 to 0, as Hilber, Hughes & Taylor do.
        sign = -1.0 if self.name == "hht" else 1.0
        given = {key: sign * number for key, number in zip(keys, self.numbers, strict=True)}
        return {"name": self.name, **given}

    def rates(self, z: Complex, h: float) -> tuple[Complex, Complex]:
        """Return s in 1/s and q in 1/s² for steps of length h in s."""
        if self.published:
            s = (1.0 - 1.0 / z) / h
            return s, s * s
        v = h * (1.0 - self.gamma + self.gamma * z) / (z - 1.0)
        u = (h * v + h * h * (0.5 - self.beta + self.beta * z)) / (z - 1.0)
        now = self.alpha_f + (1.0 - self.alpha_f) * z
        return v / u, (self.alpha_m + (1.0 - self.alpha_m) * z) / (now * u)

    def balanced(self, z: Complex) -> Complex:
        """Return the value at the time of balance, which is what is recorded, for 1 before."""
        return self.alpha_f + (1.0 - self.alpha_f) * z

    def roots(self, omega_h: float, zeta: float) -> Complex:
        """Return all z of an oscillator: those of q + 2 ζ ω s + ω² = 0 times its denominator."""
        damping = 2.0 * zeta * omega_h
        one, z = Polynomial([-1.0, 1.0]), Polynomial([0.0, 1.0])
        if self.published:
            return (one * one + damping * z * one + omega_h**2 * z * z).roots() + 0j
        v = Polynomial([1.0 - self.gamma, self.gamma])
        u = v + Polynomial([0.5 - self.beta, self.beta]) * one
        inertia = Polynomial([self.alpha_m, 1.0 - self.alpha_m])
        now = Polynomial([self.alpha_f, 1.0 - self.alpha_f])
        return (inertia * one * one + now * (damping * v * one + omega_h**2 * u)).roots() + 0j

    def oscillating(self, omega_h: float, zeta: float) -> complex:
        """Return the root that tends to the exact exp((-ζ + i√(1 − ζ²)) ωh)."""
        exact = np.exp((-zeta + 1j * np.sqrt(1.0 - zeta * zeta)) * omega_h)
        roots = self.roots(omega_h, zeta)
        return complex(roots[np.argmin(abs(roots - exact))])


def generalised_alpha(radius: float) -> Member:
    """Chung & Hulbert (1993), equations 17, 20 and 25."""
    alpha_m, alpha_f = (2.0 * radius - 1.0) / (radius + 1.0), radius / (radius + 1.0)
    gamma = 0.5 - alpha_m + alpha_f
    beta = 0.25 * (1.0 - alpha_m + alpha_f) ** 2
    return Member("generalised-alpha", (radius,), beta, gamma, alpha_m, alpha_f)


def hht(alpha: float) -> Member:
    """Hilber, Hughes & Taylor (1977), with alpha from 0 to 1/3 as in Chung & Hulbert."""
    return Member("hht", (alpha,), 0.25 * (1.0 + alpha) ** 2, 0.5 + alpha, 0.0, alpha)


def newmark(beta: float, gamma: float) -> Member:
    """Newmark (1959)."""
    return Member("newmark", (beta, gamma), beta, gamma)


TRAPEZOIDAL = Member("trapezoidal", (), 0.25, 0.5, 0.5, 0.5)
PUBLISHED = Member("backward-difference", ())
DEFAULT = generalised_alpha(0.9)
DAMPED = newmark(0.3025, 0.6)
SECOND_ORDER = (TRAPEZOIDAL, DEFAULT, generalised_alpha(0.0), hht(0.05), newmark(0.25, 0.5))
ALL = (*SECOND_ORDER, DAMPED, PUBLISHED)
BY_NAME = sorted(ALL, key=lambda member: member.name)
