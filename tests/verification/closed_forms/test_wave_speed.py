"""Speed of waves along a wire

Long waves run with c = √(T/μ), μ the mass per metre of the wire under its tension. Bending makes
short waves faster, the distance h between the masses of a chain makes them slower:

    wire    T k² + EI k⁴ = μ ω²
    chain   (2T/h) (1 − cos kh) = μ h ω²
    along   c = s √(EA (3s² − 1)/(2μ₀)) (cubic elements, T = EA ½ (s² − 1) s),
            c = s √(EA/μ₀) (chain, T = EA (s − 1)); μ₀ = sμ, s the stretch

Books have c, the bending and the chain (from memory: Graff, Wave motion in elastic solids, 1975;
Brillouin, Wave propagation in periodic structures, 1946); the speed along follows from the energy
of the elements, dT/ds over the mass.

The program is asked by a run on a straight wire (20 kN, 1.35 kg/m, EA 15 MN, no gravity): a
standing strip without mass sends a pulse, two nodes 50 m apart record it. The centres ∫tu dt/∫u dt
of the two records are d/c apart, whatever the frequencies do. The phase between their spectra is
kd, at each frequency; the trapezoidal rule (1 ms) moves a wave of ω as one of (2/h) tan(ωh/2)
should, and the closed form is taken there; with `period_correction`, at ω itself. Along the wire a
force on a node sends the pulse, with steps of 20 µs.
"""

from math import pi, sqrt
from operator import itemgetter

import numpy as np
import pytest

from arcless.mesh.division import wires
from arcless.model.line.parts.components import Wire
from arcless.simulate.setup.core_data import LoadData
from tests.support import scattering, straight
from tests.support.evidence import Evidence
from tests.support.faults import Fault, scaled
from tests.support.pushing import TRAPEZOIDAL, Pressed, press
from tests.support.waves import Complex, Floats, Lattice, Waves, balanced, pulse, spectrum

TENSION, MASS, AXIAL = 20e3, 1.35, 15e6
STRING = straight.wire(TENSION, MASS, 0.0, AXIAL)
CONTACT_WIRE = straight.wire(TENSION, MASS, 200.0, AXIAL)
NEAR, FAR = 100.0, 150.0  # m
OMEGA = 2.0 * pi * scattering.FREQUENCIES


def send(kind: Wire, *, lumped: bool = False) -> Pressed:
    line = straight.Straight(scattering.even(0.5), kind, lumped=lumped)
    return scattering.send(line, [line.node(x) for x in (NEAR, FAR)])


def numbers(time: Floats, moved: Floats, omega: Floats, expected: Floats) -> Floats:
    """Measured k: the phase between both places, whole turns taken from what is expected."""
    near, far = (spectrum(time, moved[:, i], omega) for i in (0, 1))
    turned: Complex = near / far * np.exp(-1j * expected * (FAR - NEAR))
    return np.asarray(expected + np.angle(turned) / (FAR - NEAR))


def speed(time: Floats, moved: Floats, reach: int) -> float:
    """Of the centre of a pulse, over so many steps to either side of its largest value."""
    centres = []
    for one in moved.T:
        part = slice(int(np.argmax(one)) - reach, int(np.argmax(one)) + reach + 1)
        centres.append(time[part] @ one[part] / one[part].sum())
    return float((FAR - NEAR) / (centres[1] - centres[0]))


def test_centre_of_a_pulse(evidence: Evidence) -> None:
    run = send(STRING)
    measured = speed(run.time, run.nodes, 100)
    stretched = MASS / wires.stretch(STRING)
    evidence.close(
        "speed of the centre of a pulse, no bending stiffness", measured,
        sqrt(TENSION / stretched), unit="m/s", relative=5e-9,
        reason="long waves have no error in h and none in the step; rounding moves the wire slowly"
        " by 1e-7 of the pulse, which within 0.1 s of its top moves the centre by some 1e-9 s",
    )  # fmt: skip
    line = straight.Straight(scattering.even(0.5), STRING)
    evidence.close(
        "wave speed that the program states, against the measured one", line.find().wave_speed(),
        measured, unit="m/s", relative=7e-4,
        reason="the statement is √(T/μ₀) with the mass per metre without tension: low by half of"
        " the strain T/EA = 1.3e-3",
    )  # fmt: skip


@pytest.mark.parametrize("bending", [0.0, 200.0])
def test_phase_speed(evidence: Evidence, bending: float) -> None:
    kind = CONTACT_WIRE if bending else STRING
    run = send(kind)
    shown = balanced(OMEGA, scattering.STEP)
    k = Waves.on(kind).number(shown)
    found = numbers(run.time, run.nodes, OMEGA, k)
    evidence.below(
        f"|phase speed / closed form − 1|, EI {bending:g} N m², largest of 2 to 30 Hz",
        np.abs(k / found - 1.0).max(), 1.2e-5 if bending else 6e-6, unit="1",
        reason="cubic elements, h = 0.5 m, kh = 0.77: (kh)⁶/60480 = 3.6e-6 of the string, and"
        " (EI k²/2T)(kh)⁴/720 = 6e-6 of the bending",
    )  # fmt: skip
    if bending:
        hertz = shown / (2.0 * pi)
        evidence.figure(
            "dispersion", {"closed form": (hertz, shown / k), "run": (hertz, shown / found)},
            x="frequency in Hz", y="phase speed in m/s", title="Bending makes short waves faster",
        )  # fmt: skip


@pytest.mark.parametrize("scheme", [TRAPEZOIDAL, ("generalised-alpha", [0.9])], ids=itemgetter(0))
def test_phase_speed_with_period_correction(
    evidence: Evidence, scheme: tuple[str, list[float]]
) -> None:
    line = straight.Straight(scattering.even(5.0 / 6.0), STRING)
    watched = [line.node(x) for x in (NEAR, FAR)]
    run = scattering.send(line, watched, scheme, period_correction=True)
    k = Waves.on(STRING).number(OMEGA)
    found = numbers(run.time, run.nodes, OMEGA, k)
    evidence.below(
        f"|phase speed / closed form − 1|, {scheme[0]}, period corrected, largest of 2 to 30 Hz",
        np.abs(k / found - 1.0).max(), 1e-4, unit="1",
        reason="cubic elements, ℓ = 0.83 m, kℓ = 1.29: (kℓ)⁶/60480 = 8e-5 at 30 Hz; (ωh)⁴ = 1.3e-3"
        " has a factor below a hundredth; without the correction 3e-3 would be left",
    )  # fmt: skip


def test_phase_speed_on_a_chain_of_point_masses(evidence: Evidence) -> None:
    run = send(STRING, lumped=True)
    k = Lattice.of(STRING, 0.5).number(balanced(OMEGA, scattering.STEP))
    found = numbers(run.time, run.nodes, OMEGA, k)
    evidence.below(
        "|phase speed / closed form − 1|, chain of masses 0.5 m apart, largest of 2 to 30 Hz",
        np.abs(k / found - 1.0).max(), 1e-6, unit="1",
        reason="the lattice is what the program solves: only the end of the record is left, cut at"
        " 1e-6 of the pulse, over a phase of 5 rad at 2 Hz",
    )  # fmt: skip


@pytest.mark.parametrize("lumped", [False, True], ids=["cubic", "chain"])
def test_speed_along_the_wire(evidence: Evidence, lumped: bool) -> None:
    line = straight.Straight(scattering.even(0.5), STRING, lumped=lumped)
    time = 2e-5 * np.arange(2001)
    pushed = pulse(time, middle=5e-3, width=8e-4, size=1e3).tolist()
    load = LoadData([(line.node(scattering.SOURCE), straight.ALONG, 1.0)], pushed)
    run = press(line.find(), 1.0, np.full(2001, 200.0), 0.0, 2e-5, points=[NEAR, FAR], loads=[load])
    s = wires.chain_stretch(STRING) if lumped else wires.stretch(STRING)
    firm = AXIAL if lumped else AXIAL * (3.0 * s * s - 1.0) / 2.0
    evidence.close(
        f"speed of a pulse along the wire, {'chain of masses' if lumped else 'cubic elements'}",
        speed(run.time, run.along, 400), s * sqrt(firm / MASS), unit="m/s",
        relative=5e-9, reason="as for the wave across: long waves have no error, rounding is left",
    )  # fmt: skip


FAULTS = [
    *(fault
      for column in ("tension", "mass")
      for fault in (
          Fault(f"{column} of the wire 1 % too large", scaled("wires", column, 1.01),
                test_centre_of_a_pulse),
          Fault(f"{column} of the chain 1 % too large", scaled("segments", column, 1.01),
                test_phase_speed_on_a_chain_of_point_masses),
      )),
    Fault("tension of the wire 1 % too large", scaled("wires", "tension", 1.01),
          test_phase_speed_with_period_correction, scheme=("generalised-alpha", [0.9])),
    Fault("EI 1 % too large", scaled("wires", "EI", 1.01), test_phase_speed, bending=200.0),
    Fault("EA of the wire 1 % too small", scaled("wires", "EA", 0.99), test_speed_along_the_wire,
          lumped=False),
    Fault("EA of the wire 1 % too small", scaled("wires", "EA", 0.99), test_centre_of_a_pulse),
    Fault("EA of the chain 1 % too small", scaled("segments", "EA", 0.99),
          test_speed_along_the_wire, lumped=True),
]  # fmt: skip
