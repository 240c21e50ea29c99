"""Decay of waves: damping of the wire, and what each scheme adds to it

A wire with proportional damping, C = α M + β K, under a scheme whose rates are s (velocity over
displacement) and q (acceleration over displacement) for a motion e^{iωt} in steps of h:

    μ (q + α s) + (1 + β s)(T k² + EI k⁴) = 0

For the exact motion s = iω and q = −ω². Over a distance d a wave turns and decays by e^{−ikd}. The
rates of the generalised-α family follow from its equations with z = e^{iωh} (Chung & Hulbert, J.
Appl. Mech. 60 (1993) 371), those of one-sided differences are s = (1 − 1/z)/h, q = s². Derived here
by putting the wave into wire and scheme; the program computes neither s, q nor k.

The program is asked as for the speed of waves: a pulse on a straight wire (20 kN, 1.35 kg/m,
200 N m²; elements of 0.25 m, or masses 0.5 m apart without EI), spectra of two nodes 50 m apart,
steps of 1 ms. Their ratio is held against e^{−ikd} in size and phase; the size at 20 Hz is shown.
"""

from dataclasses import replace

import numpy as np
import pytest

from tests.support import scattering, schemes, straight
from tests.support.evidence import Evidence
from tests.support.faults import Fault, scaled
from tests.support.waves import Complex, Lattice, Waves, pulse, spectrum

ALPHA, BETA = 0.5, 2e-4  # 1/s, s
DISTANCE, NEAR = 50.0, 100.0
HERTZ, SHOWN = scattering.FREQUENCIES[1:], 8  # 20 Hz
# Alone, each leaves a wake behind it on a wire damped by α: together they take it away.
PULSES = sum(
    size * pulse(scattering.TIMES, middle, width=0.012, size=1.0)
    for middle, size in ((0.08, 15.0), (0.1, -30.0), (0.12, 15.0))
)


def decay(
    member: schemes.Member, alpha: float, beta: float, *, lumped: bool = False
) -> tuple[Complex, Complex]:
    """Motion 50 m further on over that before, in a run and in closed form."""
    bending = 0.0 if lumped else 200.0
    kind = straight.wire(20e3, 1.35, bending, 15e6, alpha=alpha, beta=beta)
    line = straight.Straight(scattering.even(0.5 if lumped else 0.25), kind, lumped=lumped)
    watched = [line.node(NEAR), line.node(NEAR + DISTANCE)]
    run = scattering.send(line, watched, (member.name, list(member.numbers)), PULSES)
    omega = 2.0 * np.pi * HERTZ
    before, behind = (spectrum(run.time, moved, omega) for moved in run.nodes.T)
    s, q = member.rates(np.exp(1j * omega * scattering.STEP), scattering.STEP)
    waves = Lattice.of(kind, 0.5) if lumped else Waves.on(kind)
    k = waves.number(np.sqrt(-(q + alpha * s) / (1.0 + beta * s)))
    return behind / before, np.exp(-1j * k * DISTANCE)


CUBIC = (
    "cubic elements of 0.25 m, kh = 0.38 at 30 Hz: (kh)⁶/60480 + (EI k²/2T)(kh)⁴/720 = 4e-7 of k,"
    " over the 77 rad of 50 m"
)
CHAIN = "the lattice is what the program solves: the record ends 3e-6 of the pulse above zero"
SIZE = (
    "the error of k turns the wave, and changes its size by its share in the decay only, 1e-6 of"
    " up to 0.7; the record ends 1e-6 of the pulse above zero"
)
SMEARED = "the scheme smears the pulse out, and the record ends 1e-4 of what comes above zero"


def show(evidence: Evidence, name: str, found: Complex, exact: Complex, *, lumped: bool) -> None:
    smeared = name == schemes.PUBLISHED.name
    limit, reason = (1e-5, CHAIN) if lumped else (2e-4, SMEARED) if smeared else (6e-5, CUBIC)
    evidence.below(
        f"|ratio − e^(−ikd)|, {name}, largest of 4 to 30 Hz", np.abs(found - exact).max(), limit,
        unit="1", reason=reason,
    )  # fmt: skip
    evidence.close(
        f"share of a wave of 20 Hz left after 50 m, {name}", 100.0 * abs(found[SHOWN]),
        100.0 * abs(exact[SHOWN]), unit="%", relative=2e-4 if smeared else 1e-5,
        reason=SMEARED if smeared else SIZE,
    )  # fmt: skip


@pytest.mark.parametrize("member", schemes.ALL, ids=lambda member: member.label)
def test_scheme(evidence: Evidence, member: schemes.Member) -> None:
    show(evidence, member.label, *decay(member, 0.0, 0.0), lumped=False)


@pytest.mark.parametrize("lumped", [False, True], ids=["cubic", "chain"])
@pytest.mark.parametrize("which", ["alpha", "beta"])
def test_damping(evidence: Evidence, which: str, lumped: bool) -> None:
    alpha, beta = (ALPHA, 0.0) if which == "alpha" else (0.0, BETA)
    damped = f"α = {ALPHA:g} 1/s" if which == "alpha" else f"β = {BETA:g} s"
    name = f"{damped}, {'chain of masses' if lumped else 'cubic elements'}"
    show(evidence, name, *decay(schemes.DEFAULT, alpha, beta, lumped=lumped), lumped=lumped)


FAULTS = [
    *(Fault(f"{column} {what}", scaled(kind, column, factor), test_damping, which=column,
            lumped=kind == "segments")
      for column in ("alpha", "beta")
      for what, kind, factor in (
          ("of the wires 1 % too large", "wires", 1.01),
          ("of the segments 1 % too large", "segments", 1.01),
          ("dropped", "wires", 0.0),
      )),
    Fault("spectral radius 0.8 in place of 0.9", (), test_scheme,
          member=replace(schemes.DEFAULT, numbers=(0.8,))),
    Fault("γ = 0.601 in place of 0.6", (), test_scheme,
          member=replace(schemes.DAMPED, numbers=(0.3025, 0.601))),
]  # fmt: skip
