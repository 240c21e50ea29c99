"""Waves under explicit steps: their speed, and how they decay

A wire of point masses, ℓ apart, steps explicitly by h (docs/theory/dynamics.md, explicit steps).
With K = 4 sin² (kℓ/2), C = ch/ℓ and the filter F = 1 + a K + b K² of all forces a wave obeys

    F (T/μℓ²)(K + ε* K²) = (4/h²) sin² (ωh/2)

and a, b are such that the wire's own T k² + EI k⁴ = μ ω² holds but for (kℓ)⁶: a wave is late by

    ½ (c₄ − b ε*) (kℓ)⁶/(1 + ε (kℓ)²) of k; of a string (1 − C²)(4 − C²)(9 − C²)(kℓ)⁶/40320

c₄ is the next term of sin² (ωh/2) over K (`crates/core/tests/explicit/waves.rs` derives it).
Damping of the wire, α M + β K, takes the velocity of the last increment of the place:

    F ((T/μℓ²)(K + ε* K²)(1 + βσ) + ασ) = (4/h²) sin² (ωh/2),    σ = (1 − e^{−iωh})/h

beside μ (ω² − iωα) = (1 + iωβ)(T k² + EI k⁴) of the wire. σ = iω + ω²h/2 + …: in first order of h
the lag makes the wire stiffer by the share βω²h/2, and lighter by αh/2, so the wave is ahead by
kd (α + βω²)h/4; what it decays by differs in second order, and by the filter, which α has as well.

The program is asked as for schemes with a matrix: a pulse on a straight wire (20 kN, 1.35 kg/m, EA
15 MN, without and with 200 N m²), masses 0.5 m apart, a little more than what `auto` takes, 1 ms;
spectra of two nodes 50 m apart, from 2 to 30 Hz. Closed forms are taken at ω itself. They are held
against the wire, and against the steps as the theory has them (`tests/support/explicit_waves.py`),
where nothing is left but the end of the record.
"""

from unittest.mock import patch

import numpy as np
import pytest

from tests.support import scattering, straight
from tests.support.evidence import Evidence
from tests.support.explicit_waves import Stepped, of_chain
from tests.support.faults import Fault, scaled, without
from tests.support.pushing import EXPLICIT
from tests.support.run_faults import prepared_with
from tests.support.waves import Complex, Floats, spectrum
from tests.verification.closed_forms import test_wave_decay as decay

DISTANCE, NEAR, FAR = 0.5, 100.0, 150.0  # m
# Nothing comes back from the ends before the record is over, not even the stiff, fast waves.
X = np.arange(-40.0, 280.25, DISTANCE)
OMEGA = 2.0 * np.pi * scattering.FREQUENCIES
ENDS = "the steps are what the program solves: the record ends {} of the pulse above zero{}"


def ratio(bending: float, sent: Floats | None = None, **damping: float) -> tuple[Complex, Stepped]:
    """Motion 50 m further on over that before, and the waves of the steps."""
    kind = straight.wire(20e3, 1.35, bending, 15e6, **damping)
    line = straight.Straight(X, kind, fitted=True)
    run = scattering.send(line, [line.node(x) for x in (NEAR, FAR)], EXPLICIT, sent)
    near, far = (spectrum(run.time, moved, OMEGA) for moved in run.nodes.T)
    return far / near, Stepped.of(kind, DISTANCE, scattering.STEP)


# Of k at 30 Hz: kℓ = 0.77, C = 0.24; ε = 0.04, ε* = 0.10.
LATE = {
    0.0: (
        2.1e-4,
        "(1 − C²)(4 − C²)(9 − C²)(kℓ)⁶/40320 = 1.7e-4, and a quarter more for what comes next,"
        " (kℓ)² times some tenths",
    ),
    200.0: (
        1.5e-4,
        "½ (c₄ − b ε*)(kℓ)⁶ = 1.2e-4, a quarter more for what comes next, less ½ (ε* − ε)(kℓ)²"
        " T/EA = 2e-5 as the filter measures elements without their stretch",
    ),
}


@pytest.mark.parametrize("bending", [0.0, 200.0])
def test_phase_speed(evidence: Evidence, bending: float) -> None:
    found, steps = ratio(bending)
    wire = of_chain(straight.wire(20e3, 1.35, bending, 15e6)).number(OMEGA)

    def off(expected: Floats) -> Floats:
        turned = np.angle(found * np.exp(1j * expected * (FAR - NEAR)))
        return np.asarray(1.0 / (1.0 - turned / (expected * (FAR - NEAR))) - 1.0)

    limit, reason = LATE[bending]
    evidence.below(
        f"|phase speed / closed form − 1|, EI {bending:g} N m², largest of 2 to 30 Hz",
        np.abs(off(wire)).max(), limit, unit="1", reason=reason,
    )  # fmt: skip
    evidence.below(
        f"|phase speed / that of the steps − 1|, EI {bending:g} N m², largest of 2 to 30 Hz",
        np.abs(off(steps.number(OMEGA).real)).max(), 1e-6, unit="1",
        reason=ENDS.format("1e-6", ", over a phase of 5 rad at 2 Hz"),
    )  # fmt: skip
    # Twice as long a wave is late by a 64th: read where it is above the end of the record.
    middle = slice(6, 15)  # 14 to 30 Hz
    if bending == 0.0:
        evidence.order(
            "order in kℓ of what a wave of a string is late by, 14 to 30 Hz",
            (steps.distance * wire)[middle], np.abs(off(wire))[middle], 6.0, tolerance=0.2,
            unit="kℓ", reason="the next term, of the order 8, has some tenths of (kℓ)² = 0.6: some"
            " hundredths of the order; the end of the record has 1e-8 of 2e-6 at 14 Hz",
        )  # fmt: skip


# How far off the share of 20 Hz may be (kℓ = 0.51, ωh = 0.126), and why.
LOUDER = (
    "the exponent βω²d/2c = 0.65 is too small by ¾ βω²h + (ωh)²/12 = 3.7e-3 of it, of second order"
)
FILTERED = "the filter makes the exponent αd/2c = 0.103 larger by a (kℓ)² + b (kℓ)⁴ = {} of it"
SHARES = {
    ("alpha", 0.0): (2.4e-3, FILTERED.format("2.1e-2")),
    ("alpha", 200.0): (6e-4, FILTERED.format("5.2e-3")),
    ("beta", 0.0): (2.5e-3, LOUDER),
    ("beta", 200.0): (2.5e-3, LOUDER),
}


@pytest.mark.parametrize("bending", [0.0, 200.0])
@pytest.mark.parametrize("which", ["alpha", "beta"])
def test_damping(evidence: Evidence, which: str, bending: float) -> None:
    alpha, beta = (decay.ALPHA, 0.0) if which == "alpha" else (0.0, decay.BETA)
    found, steps = ratio(bending, decay.PULSES, alpha=alpha, beta=beta)
    found, omega = found[1:], OMEGA[1:]  # three pulses in turn leave little of 2 Hz
    distance = FAR - NEAR
    name = f"α = {alpha:g} 1/s" if which == "alpha" else f"β = {beta:g} s"
    name += f", EI {bending:g} N m²"
    evidence.below(
        f"|ratio − e^(−ikd) of the steps|, {name}, largest of 4 to 30 Hz",
        np.abs(found - np.exp(-1j * steps.number(omega) * distance)).max(), 1e-5, unit="1",
        reason=ENDS.format("3e-7", ", and three pulses in turn leave a twentieth of 4 Hz"),
    )  # fmt: skip
    wire, at = of_chain(straight.wire(20e3, 1.35, bending, 15e6)), decay.SHOWN
    k = wire.number(np.sqrt((omega**2 - 1j * omega * alpha) / (1.0 + 1j * omega * beta)))
    exact = np.exp(-1j * k * distance)
    limit, reason = SHARES[which, bending]
    evidence.close(
        f"share of a wave of 20 Hz left after 50 m, {name}", 100.0 * abs(found[at]),
        100.0 * abs(exact[at]), unit="%", relative=limit, reason=reason,
    )  # fmt: skip
    lag = 0.25 * (alpha + beta * omega[at] ** 2) * scattering.STEP
    evidence.close(
        f"phase of 20 Hz ahead of the wire's after 50 m, {name}", np.angle(found[at] / exact[at]),
        k[at].real * distance * lag, unit="rad", absolute=1e-3,
        reason="the lag of damping in first order; the wave is late by"
        " (1 − C²)(4 − C²)(9 − C²)(kℓ)⁶/40320 of 51 rad = 8e-4, and by less with EI",
    )  # fmt: skip


FAULTS = [
    *(Fault(f"{column} of the chain 0.1 % too large", scaled("segments", column, 1.001),
            test_phase_speed, bending=0.0)
      for column in ("tension", "mass")),
    Fault("EI 1 % too large", scaled("bends", "EI", 1.01), test_phase_speed, bending=200.0),
    Fault("points yield as those of a chain", without("fitted_bends"), test_phase_speed,
          bending=200.0),
    Fault("masses 0.4 m apart in place of 0.5 m",
          patch.multiple(__name__, X=np.arange(-40.0, 280.2, 0.4)), test_phase_speed, bending=0.0),
    Fault("steps that are solved for", prepared_with(scheme=lambda _: ("trapezoidal", [])),
          test_phase_speed, bending=0.0),
    *(Fault(f"{column} {what}", scaled("segments", column, factor), test_damping, which=column,
            bending=0.0)
      for column in ("alpha", "beta")
      for factor, what in ((1.01, "1 % too large"), (0.0, "dropped"))),
]  # fmt: skip
