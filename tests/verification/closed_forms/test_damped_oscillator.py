"""Damped oscillator under every time-stepping scheme

A mass m on a spring k and a damper c swings freely: `u'' + 2 ζ ω u' + ω² u = 0`, `ω² = k/m`. A
scheme turns it into `u(n+1) = z u(n)` with complex z; its frequency is `arg z / h`, its decay
`-ln|z| / h`. The exact z of a scheme is the root of the polynomial that follows from the equations
of its paper with `a(n) = zⁿ` (derived here):

    (α_m + (1 − α_m) z) (z − 1)² + (α_f + (1 − α_f) z) [2 ζ ωh (1 − γ + γ z)(z − 1)
        + (ωh)² ((1 − γ + γ z) + (½ − β + β z)(z − 1))] = 0

Sources: Chung & Hulbert (1993), equations 12 to 15, 17, 20 and 25 for generalised-alpha; Hilber,
Hughes & Taylor (1977) in the notation of Chung & Hulbert; Newmark (1959), all cited second hand, as
the core cites them. The trapezoidal rule gives `z = (1 + sh/2)/(1 − sh/2)`, one-sided differences
`z = 1/(1 − sh)`, with `s = ω(−ζ ± i √(1 − ζ²))`.

The program is asked twice: a node of a line with a spring and damper to the ground, and a
coordinate of a pantograph, each pushed for three steps. Two coefficients are fitted to 250 recorded
steps of the free motion, `u(n+2) = p u(n+1) + q u(n)`; z are the roots of `z² − p z − q`. Products
ωh of 0.05, 0.126 (20 Hz at 1 ms) and 0.4, ratios ζ of 0, 0.02 and 0.3.
"""

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from arcless.simulate.setup.core_data import LoadData
from tests.support import bare, schemes
from tests.support.faults import Fault, scaled
from tests.support.run_faults import pantograph_scaled, prepared_with, stepped_by
from tests.support.schemes import Member

Floats = NDArray[np.float64]

STEPS = 400
# The third root of the schemes, at most 0.73 in size, is then below rounding.
QUIET = 150
H = 1e-3
MASS = 2.0
PRODUCTS, RATIOS = (0.05, 2.0 * np.pi * 0.02, 0.4), (0.0, 0.02, 0.3)


def push() -> Floats:
    """Push for three steps; N."""
    force = np.zeros(STEPS + 1)
    force[1:4] = 1000.0
    return force


def on_line(scheme: Member, omega: float, zeta: float) -> Floats:
    """Motion of a node of a line."""
    line = bare.oscillator(MASS, 2.0 * zeta * omega * MASS, MASS * omega**2)
    head = bare.pantograph(np.eye(1), np.zeros((1, 1)), np.zeros((1, 1)), strip=[1.0], force=10.0)
    loads = [LoadData([(2, 1, 1.0)], push().tolist())]
    asked = bare.Asked(scheme, H, bare.stand(0.5, STEPS), nodes=[2], loads=loads)
    return np.asarray(bare.run(line, head, asked)["uplift"])


def on_pantograph(scheme: Member, omega: float, zeta: float) -> Floats:
    """Motion of a coordinate that is not joined to the one that carries the strip."""
    matrices = [np.diag([MASS * value, other]) for value, other in (
        (1.0, 1.0), (2.0 * zeta * omega, 0.0), (omega**2, 0.0)
    )]  # fmt: skip
    head = bare.pantograph(*matrices, strip=[0.0, 1.0], force=10.0, given=[([1.0, 0.0], push())])
    asked = bare.Asked(scheme, H, bare.stand(0.0, STEPS))
    return np.asarray(bare.run(bare.wall(), head, asked)["masses"]).reshape(-1, 2)[:, 0]


def fitted(motion: Floats) -> complex:
    """Return the root z of the free motion with positive frequency."""
    u = motion[QUIET:]
    size = np.hypot(u[1:-1], u[:-2])  # a decaying motion counts to its end
    rows = np.column_stack([u[1:-1], u[:-2]]) / size[:, None]
    (p, q), *_ = np.linalg.lstsq(rows, u[2:] / size, rcond=None)
    return complex(0.5 * p + 1j * np.sqrt(-q - 0.25 * p * p))


def exponent(z: complex, h: float) -> complex:
    """Return decay and frequency, s in exp(s t)."""
    return complex(np.log(z) / h)


def added_damping(scheme: Member, product: float) -> float:
    """Decay over frequency of an undamped oscillator, of which ωh is given."""
    s = exponent(fitted(on_line(scheme, product / H, 0.0)), H)
    return -s.real / s.imag


@pytest.mark.parametrize("scheme", schemes.ALL, ids=lambda scheme: scheme.label)
def test_frequency_and_damping(evidence: Any, scheme: Member) -> None:
    worst = 0.0
    for motion in (on_line, on_pantograph):
        for product in PRODUCTS:
            for zeta in RATIOS:
                omega = product / H
                found = exponent(fitted(motion(scheme, omega, zeta)), H)
                expected = exponent(scheme.oscillating(product, zeta), H)
                worst = max(worst, abs(found - expected) / omega)
    evidence.below(
        f"{scheme.label}: decay and frequency against its polynomial, worst of 18",
        worst,
        5e-12,
        unit="1",
        reason="rounding of 1e-16 in each step, over ωh = 0.05 and the curvature (ωh)² that tells u"
        " from a straight line: 1e-16/0.05³ = 1e-12, and five times that for another processor",
    )


def test_what_20_hz_at_1_ms_costs(evidence: Any) -> None:
    omega = 2.0 * np.pi * 20.0
    damping = {
        schemes.PUBLISHED: np.log(1.0 + (omega * H) ** 2) / (2.0 * np.arctan(omega * H)),
        schemes.DAMPED: 0.5 * (schemes.DAMPED.gamma - 0.5) * omega * H,
    }
    for scheme, reference in damping.items():
        evidence.close(
            f"{scheme.label}: damping ratio it adds at 20 Hz and 1 ms",
            added_damping(scheme, omega * H),
            float(reference),
            unit="1",
            relative=2e-12 if scheme.published else 0.5 * (omega * H) ** 2,
            reason="closed form ln(1 + (ωh)²)/(2 atan ωh); rounding as above"
            if scheme.published
            else "(γ − ½) ωh/2 (Hughes, section 9.3) is the first term; the next is (ωh)² of it",
        )
    products = np.geomspace(0.03, 0.6, 15)
    curves = {
        scheme.label: (products, [added_damping(scheme, product) for product in products])
        for scheme in (schemes.PUBLISHED, schemes.DAMPED, schemes.hht(0.05), schemes.DEFAULT)
    }
    evidence.figure(
        "damping", curves, x="ωh (20 Hz at 1 ms: 0.126)", y="damping ratio added",
        title="Numerical damping, as measured", log_x=True, log_y=True,
    )  # fmt: skip
    s = exponent(fitted(on_line(schemes.TRAPEZOIDAL, omega, 0.0)), H)
    evidence.close(
        "trapezoidal: frequency at 20 Hz and 1 ms, as a part of the exact one",
        s.imag / omega,
        float(2.0 * np.arctan(0.5 * omega * H) / (omega * H)),
        unit="1",
        absolute=2e-12,
        reason="tan(ω̄h/2) = ωh/2; rounding of 200 steps fitted",
    )


def more(asked: tuple[str, list[float]]) -> tuple[str, list[float]]:
    return asked[0], [number + 0.001 for number in asked[1]]


FAULTS = [
    *(Fault(f"{column} of the spring 1 % high", scaled("springs", column, 1.01),
            test_frequency_and_damping, scheme=schemes.ALL[0])
      for column in ("damping", "stiffness")),
    *(Fault(f"{matrix} of the pantograph 1 % high", pantograph_scaled(matrix, 1.01),
            test_frequency_and_damping, scheme=schemes.DEFAULT)
      for matrix in ("damping", "mass", "stiffness")),
    *(Fault(f"{scheme.label}: parameters 0.001 high", prepared_with(scheme=more),
            test_frequency_and_damping, scheme=scheme)
      for scheme in schemes.BY_NAME
      if scheme.numbers),
    Fault("step 1 % long", prepared_with(step=lambda h: 1.01 * h), test_what_20_hz_at_1_ms_costs),
    Fault("default scheme in place of the one asked for", stepped_by(schemes.DEFAULT),
          test_what_20_hz_at_1_ms_costs),
]  # fmt: skip
