"""Reflection and transmission of waves at a spring and at a damper, and what an end swallows

As at a mass, with the dynamic stiffness of what holds the wire to the ground:

    D = K + iωC − ω²M,   r = −D g/(1 + D (g + n)),   t = 1 + r

Without bending stiffness r = −D/(D + 2iω√(Tμ)). At √(K/M) a mass on a spring is invisible: D = 0.
At the end of a wire, free to move in height but for a damper C there,

    r = (√(Tμ) − C)/(√(Tμ) + C)

at any frequency: the damper √(Tμ) swallows every wave. Derived here, from the balance of forces at
the point; the end also as books on waves have it (from memory).

The program is asked as for the mass: pulse from a standing strip, runs with and without the
obstacle, spectra of the motion 20 m before and behind it (200 N m² on 20 kN; elements of 0.25 m,
0.05 m at the obstacle; 1 ms). For the end, the wire has no bending stiffness, the damper is 80 m
from the source, and a wire that goes on gives what comes in.
"""

import numpy as np
import pytest

from tests.support import scattering, straight
from tests.support.evidence import Evidence
from tests.support.faults import Fault, scaled
from tests.support.waves import Lattice, Waves, balanced, spectrum

CONTACT_WIRE = straight.wire(20e3, 1.35, 200.0, 15e6)
STRING = straight.wire(20e3, 1.35, 0.0, 15e6)
SPRING, DAMPER, MASS = 5e3, 300.0, 2.0
# Holds the end at rest, and returns 5e-7 of a wave of 2 Hz; in N/m.
WEAK = 1e-3
# With the mass, invisible at 10 Hz: the fifth of the frequencies.
TUNED = MASS * float(balanced(np.array(20.0 * np.pi), scattering.STEP)) ** 2
OBSTACLES = {
    "spring 5 kN/m": (SPRING, 0.0, 0.0),
    "damper 300 N s/m": (straight.NEARLY_NONE, DAMPER, 0.0),
    "2 kg on 7.9 kN/m and 100 N s/m": (TUNED, 100.0, MASS),
}


def scatter(
    stiffness: float, damping: float, mass: float, *, lumped: bool = False
) -> tuple[scattering.Scattered, np.ndarray]:
    """Ask the program, and return with its answer the r of the closed form."""

    def fasten(line: straight.Straight) -> None:
        line.add_spring(scattering.OBSTACLE, stiffness, damping)
        line.add_mass(scattering.OBSTACLE, mass)

    kind = STRING if lumped else CONTACT_WIRE
    waves = Lattice.of(kind, 0.5) if lumped else Waves.on(kind)
    x = scattering.even(0.5) if lumped else scattering.fine(0.25, 0.05)
    found = scattering.scatter(x, (kind,), (waves,), fasten, lumped=lumped)
    held = stiffness + 1j * found.omega * damping - mass * found.omega**2
    return found, waves.reflection(held, found.omega)


@pytest.mark.parametrize("name", OBSTACLES)
def test_obstacle_on_a_wire(evidence: Evidence, name: str) -> None:
    found, exact = scatter(*OBSTACLES[name])
    off = np.abs(np.array([found.back - exact, found.on - 1.0 - exact]))
    evidence.below(
        f"|r − closed form| and |t − closed form|, {name}, largest of 2 to 30 Hz",
        off.max(), 5e-5, unit="1",
        reason="over 40 m the wave of 30 Hz is out of phase by 2.4e-5 rad, (EI k²/2T)(kh)⁴/720 of"
        " k with h = 0.25 m; as much again for the field at the obstacle",
    )  # fmt: skip
    evidence.close(
        f"|r| at 2 Hz, {name}", abs(found.back[0]), abs(exact[0]), unit="1", relative=1e-5,
        reason="at 2 Hz no error of the elements is left: the record ends 1e-6 of the pulse above"
        " zero",
    )  # fmt: skip


def test_a_tuned_mass_on_a_spring_is_invisible(evidence: Evidence) -> None:
    found, exact = scatter(TUNED, 0.0, MASS)
    assert abs(exact[4]) < 1e-12 < abs(exact[3])
    evidence.below(
        "|r| at the natural frequency of 2 kg on 7.9 kN/m, 10 Hz", abs(found.back[4]), 1e-6,
        unit="1", reason="(EI k²/2T)(kh)⁴/720 of k over 40 m at 10 Hz is 2e-7 rad; the field at the"
        " obstacle is off by as much",
    )  # fmt: skip
    evidence.close(
        "|r| at 2 Hz, 2 kg on 7.9 kN/m", abs(found.back[0]), abs(exact[0]), unit="1",
        relative=1e-5, reason="as above",
    )  # fmt: skip


def test_spring_on_a_chain_of_point_masses(evidence: Evidence) -> None:
    found, exact = scatter(SPRING, 0.0, 0.0, lumped=True)
    evidence.below(
        "|r − closed form| on a chain of point masses, spring 5 kN/m, largest of 2 to 30 Hz",
        np.abs(found.back - exact).max(), 1e-5, unit="1",
        reason="the lattice is what the program solves: only the end of the record is left, cut at"
        " 1e-6 of the pulse",
    )  # fmt: skip


@pytest.mark.parametrize("share", [0.5, 1.0, 2.0])
def test_damper_at_the_end(evidence: Evidence, share: float) -> None:
    waves, end, watched = Waves.on(STRING), scattering.END, 40.0
    short = straight.Straight(np.arange(0.0, end + 0.125, 0.25), STRING, loose=True)
    short.add_spring(0.0, WEAK, share * waves.impedance)
    short.add_spring(end, 1e6)
    long = straight.Straight(np.arange(-end, end + 0.125, 0.25), STRING)
    ended, free = (scattering.send(line, [line.node(watched)]) for line in (short, long))
    omega = 2.0 * np.pi * scattering.FREQUENCIES
    came = spectrum(free.time, free.nodes[:, 0], omega)
    back = spectrum(free.time, ended.nodes[:, 0] - free.nodes[:, 0], omega)
    shown = balanced(omega, scattering.STEP)
    r = back / came * np.exp(2j * waves.number(shown) * watched)
    evidence.below(
        f"|r − closed form| at an end with a damper of {share:g} √(Tμ), largest of 2 to 30 Hz",
        np.abs(r - (1.0 - share) / (1.0 + share)).max(), 8e-6, unit="1",
        reason="over 80 m the wave of 30 Hz is out of phase by 7e-6 rad, (kh)⁶/60480 of k with h ="
        " 0.25 m; the record ends 1e-6 of the pulse above zero",
    )  # fmt: skip


STIFF, STRONG = (scaled("springs", column, 1.01) for column in ("stiffness", "damping"))
FAULTS = [
    Fault("spring 1 % too stiff", STIFF, test_obstacle_on_a_wire, name="spring 5 kN/m"),
    Fault("spring 1 % too stiff", STIFF, test_a_tuned_mass_on_a_spring_is_invisible),
    Fault("spring 1 % too stiff", STIFF, test_spring_on_a_chain_of_point_masses),
    Fault("damper 1 % too strong", STRONG, test_obstacle_on_a_wire, name="damper 300 N s/m"),
    Fault("damper 1 % too strong", STRONG, test_damper_at_the_end, share=1.0),
    Fault("damper forgotten", scaled("springs", "damping", 0.0), test_obstacle_on_a_wire,
          name="2 kg on 7.9 kN/m and 100 N s/m"),
    Fault("wire 1 % too heavy", scaled("wires", "mass", 1.01), test_damper_at_the_end, share=0.5),
]  # fmt: skip
