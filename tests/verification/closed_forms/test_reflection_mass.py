"""Reflection and transmission of waves at a mass

A wave e^{iω(t − x/c)} on a wire under tension T meets a mass m at x = 0, on which the force −D u
of the mass acts with D = −ω² m. The share r comes back, t = 1 + r goes on:

    r = −D g/(1 + D (g + n)),   g = 1/(2ik (T + 2 EI k²)),   n = −1/(2κ (T + 2 EI k²))
    T k² + EI k⁴ = μ ω²,   κ² = k² + T/EI

g is the share of the wire's answer to a force that travels, n the share that stays near. Derived
here with the Green's function of the wire. Without bending stiffness r = −iωm/(2√(Tμ) + iωm), as
books on waves have it (from memory: Graff, Wave motion in elastic solids, 1975, ch. 1).

The program is asked by a run. A strip without mass presses on a straight wire (20 kN, 1.35 kg/m,
EI 200 N m², EA 15 MN, no gravity), its force changes by a pulse, and 40 m further on is the mass.
Two runs, with and without it; spectra of the motions 20 m before and behind it give r and t from 2
to 30 Hz. Elements of 0.25 m, 0.05 m at the mass; trapezoidal rule, 1 ms. Its error in time is known
exactly: a wave of ω moves as one of (2/h) tan(ωh/2) should; the closed form is taken there.

The second wire model, a chain of point masses, has its own closed form (a lattice without EI):
T (2 − 2 cos ka)/a = μ a ω², g = a/(2iT sin ka), masses a = 0.5 m apart.

A third way asks the model of a line with `point_masses` for natural frequencies: with the mass at
distances a and b from fixed ends, ωm/√(Tμ) = sin k(a + b)/(sin ka sin kb) =: 2q and
|r| = q/√(1 + q²).
"""

from math import pi

import numpy as np
import pytest

import arcless
from arcless.model import load
from tests.support import scattering, straight
from tests.support.evidence import Evidence
from tests.support.faults import Fault, scaled
from tests.support.line_types import scenario_data
from tests.support.simple_lines import trolley_data
from tests.support.waves import Lattice, Waves

MASSES = [2.0, 8.0]
CONTACT_WIRE = straight.wire(20e3, 1.35, 200.0, 15e6)
STRING = straight.wire(20e3, 1.35, 0.0, 15e6)


def at_mass(mass: float) -> scattering.Fasten:
    return lambda line: line.add_mass(scattering.OBSTACLE, mass)


@pytest.mark.parametrize("mass", MASSES)
def test_mass_on_a_wire(evidence: Evidence, mass: float) -> None:
    waves, x = Waves.on(CONTACT_WIRE), scattering.fine(0.25, 0.05)
    found = scattering.scatter(x, (CONTACT_WIRE,), (waves,), at_mass(mass))
    exact = waves.reflection(-mass * found.omega**2 + 0j, found.omega)
    reason = (
        "over 40 m the wave of 30 Hz is out of phase by 2.4e-5 rad, (EI k²/2T)(kh)⁴/720 of k with"
        " h = 0.25 m; as much again for the field at the mass"
    )
    evidence.below(
        f"|r − closed form|, {mass:g} kg, largest of 2 to 30 Hz",
        np.abs(found.back - exact).max(), 5e-5, unit="1", reason=reason,
    )  # fmt: skip
    evidence.below(
        f"|t − closed form|, {mass:g} kg, largest of 2 to 30 Hz",
        np.abs(found.on - 1.0 - exact).max(), 5e-5, unit="1", reason=reason,
    )  # fmt: skip
    at = list(scattering.FREQUENCIES).index(10.0)
    evidence.close(
        f"|r| at 10 Hz, {mass:g} kg", abs(found.back[at]), abs(exact[at]), unit="1",
        relative=2e-5, reason="the same at 10 Hz: 3e-7 from the phase, and the record ends 1e-6"
        " of the pulse above zero",
    )  # fmt: skip
    energy = np.abs(found.back) ** 2 + np.abs(found.on) ** 2
    evidence.below(
        f"| |r|² + |t|² − 1 |, {mass:g} kg, largest of 2 to 30 Hz",
        np.abs(energy - 1.0).max(), 1e-5, unit="1",
        reason="a mass keeps energy, in any mesh: what is left is the end of the record, which is"
        " cut at 1e-6 of the pulse",
    )  # fmt: skip
    evidence.figure(
        f"{mass:g}-kg",
        {
            "closed form": (found.omega / (2.0 * pi), np.abs(exact)),
            "run": (found.omega / (2.0 * pi), np.abs(found.back)),
        },
        x="frequency in Hz", y="|r|", title=f"Reflection at {mass:g} kg on the contact wire",
    )  # fmt: skip


def test_mass_on_a_chain_of_point_masses(evidence: Evidence) -> None:
    distance, mass = 0.5, 8.0
    waves, x = Lattice.of(STRING, distance), scattering.even(distance)
    found = scattering.scatter(x, (STRING,), (waves,), at_mass(mass), lumped=True)
    exact = waves.reflection(-mass * found.omega**2 + 0j, found.omega)
    evidence.below(
        "|r − closed form| on a chain of point masses, 8 kg, largest of 2 to 30 Hz",
        np.abs(found.back - exact).max(), 5e-6, unit="1",
        reason="the lattice is what the program solves: only the end of the record is left, cut at"
        " 1e-6 of the pulse",
    )  # fmt: skip


def test_standing_waves_of_a_line_with_a_mass(evidence: Evidence) -> None:
    a, b, tension, density, mass = 26.0, 34.0, 12e3, 1.1, 8.0
    line = trolley_data(
        contact_wire__bending_stiffness=0.0,
        contact_wire__ends="fixed",
        contact_wire__axial_stiffness=1e9,
        span_types__span__length=a + b,
        spans=[{"type": "span"}],
        point_masses=[{"position": a, "mass": mass}],
    )
    travel = {"travel": {"start": 10.0, "end": 50.0}, "analysis": {"from": 20.0, "to": 40.0}}
    fine = {"solver__contact_wire_element": 0.1, "solver__gravity": 1e-3, "speed": 10.0}
    found = arcless.statics(load(scenario_data(line, **travel, **fine)))
    omega = 2.0 * pi * np.array(found.natural_frequencies_Hz[:12])
    k = omega * np.sqrt(density / tension)
    q = 0.5 * np.sin(k * (a + b)) / (np.sin(k * a) * np.sin(k * b))
    impedance = 0.5 * omega * mass / np.sqrt(tension * density)
    # Where a node of the wave is near the mass, sin ka is small and says little.
    clear = (abs(np.sin(k * a)) > 0.2) & (abs(np.sin(k * b)) > 0.2)
    assert np.count_nonzero(clear) >= 5
    off = abs(q) / np.sqrt(1 + q**2) / (impedance / np.sqrt(1 + impedance**2)) - 1.0
    evidence.below(
        f"|r| / closed form − 1 from {np.count_nonzero(clear)} natural frequencies below 13 Hz",
        np.abs(off[clear]).max(), 4e-3, unit="1",
        reason="cubic elements have no kink at a node, which a wire without bending stiffness has"
        " at a mass: it is spread over elements of 0.1 m, 1 % of the shortest wave",
    )  # fmt: skip


HEAVY = scaled("masses", "mass", 1.01)
FAULTS = [
    Fault("mass 1 % too heavy", HEAVY, test_mass_on_a_wire, mass=2.0),
    Fault("mass 1 % too heavy", HEAVY, test_mass_on_a_chain_of_point_masses),
    Fault("mass 1 % too heavy", HEAVY, test_standing_waves_of_a_line_with_a_mass),
    *(Fault(f"{column} of the wire 1 % too large", scaled("wires", column, 1.01),
            test_mass_on_a_wire, mass=8.0)
      for column in ("tension", "mass", "EI")),
    *(Fault(f"{column} of the chain 1 % too large", scaled("segments", column, 1.01),
            test_mass_on_a_chain_of_point_masses)
      for column in ("tension", "mass")),
]  # fmt: skip
