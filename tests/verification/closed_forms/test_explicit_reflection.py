"""Reflection and transmission under explicit steps: spring, damper, mass, dropper

A wave on a wire meets what holds it with the dynamic stiffness D. As with other schemes

    r = −D g/(1 + D (g + n)),   t = 1 + r,   D = K + iωC − ω²m

with the shares g and n of the wire's answer to a force (see the reflection at a mass). Explicit
steps filter all forces, and their answers to a force on a point are sums over the roots of a
polynomial (`tests/support/explicit_waves.py`, from docs/theory/dynamics.md). Springs and droppers
are implicit: they meet the place and velocity at the end of a step, as if at (2/h) tan (ωh/2). A
mass is part of the filter M⁻¹ + M⁻¹ E M⁻¹: with S the forces of the wire per mass, μ' = μℓ,

    (F S − (4/h²) sin² (ωh/2)) y = −(m/μ') ((F − 1) w + a),   w = −(S y)/(1 + m/μ'), a of the point

One point alone yields more than the wire: its corner is rounded by ℓ/(2 sinh μ), 4 sinh² (μ/2) =
1/ε*, in the place of λ/2 = ½ √(EI/T), which is 0.36 µm/N, and 0.50 µm/N at 30 Hz. Springs and
droppers have that as residual flexibility, 1/k' = 1/k + R with R = (ℓ/(2 sinh μ) − λ/2)/T, and of
the 0.50 µm/N 0.14 are left; dampers and masses have not. A force on a point sends more than along
the wire as well, by 1.1 % at 30 Hz: in second order by ((1 − 2C²)/12 − (ε* − ε))(kℓ)². A share x of
D (g + n) changes r by |r u| x, with u = 1/(1 + D (g + n)).

The program is asked as for the mass: pulse, runs with and without the obstacle, spectra 20 m before
and behind it (20 kN, 1.35 kg/m, 200 N m²; the other wire of the dropper 16 kN, 1.08 kg/m, 100
N m²), masses 0.5 m apart everywhere, 1 ms, 2 to 30 Hz.
"""

from unittest.mock import patch

import numpy as np
import pytest

from arcless.model.line.parts.components import DropperType
from tests.support import scattering, straight
from tests.support.evidence import Evidence
from tests.support.explicit_waves import Stepped, of_chain
from tests.support.faults import Fault, scaled, without
from tests.support.pushing import EXPLICIT
from tests.support.waves import Complex, Waves, balanced
from tests.verification.closed_forms import test_reflection_dropper as dropper

DISTANCE = 0.5  # m
X = np.arange(-40.0, 280.25, DISTANCE)
WIRES = dropper.WIRES
OMEGA = 2.0 * np.pi * scattering.FREQUENCIES
BALANCED = balanced(OMEGA, scattering.STEP)
CONTINUUM = [of_chain(kind) for kind in WIRES]
STEPS = [Stepped.of(kind, DISTANCE, scattering.STEP) for kind in WIRES]
RECORD = (
    "the steps are what the program solves: the record ends 1e-6 of the pulse above zero,"
    " which is three times as much of the little that it has of 2 Hz"
)


def scatter(fasten: scattering.Fasten, wires: int = 1, **options: object) -> scattering.Scattered:
    return scattering.scatter(
        X, WIRES[:wires], STEPS[:wires], fasten, EXPLICIT, fitted=True, **options
    )


def show(
    evidence: Evidence, name: str, found: scattering.Scattered, exact: tuple[Complex, Complex],
    allowed: tuple[float, str],
) -> None:  # fmt: skip
    """Hold r and t against the wire, and against the steps."""
    wire, steps = exact
    for what, r, most, why in (
        ("closed form", wire, *allowed),
        ("that of the steps", steps, 1e-5, RECORD),
    ):
        off = np.abs(np.array([found.back - r, found.on - 1.0 - r]))
        evidence.below(
            f"|r − {what}| and |t − {what}|, {name}, largest of 2 to 30 Hz", off.max(), most,
            unit="1", reason=why,
        )  # fmt: skip


OBSTACLES = {
    "spring 5 kN/m": (
        5e3, 0.0, 1.0e-3,
        "at 30 Hz |r u| = 0.08 of 1.1 % and of D 0.14 µm/N = 0.07 %; at 2 Hz, ½ of that, 2e-5",
    ),
    "damper 300 N s/m": (
        straight.NEARLY_NONE, 300.0, 1.1e-2,
        "at 30 Hz |r u| = 0.25 of 1.1 %, ωC 0.50 µm/N = 2.8 %, and (ωh)²/12 = 0.3 % as its velocity"
        " is that of the end of the step",
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", OBSTACLES)
def test_spring_and_damper(evidence: Evidence, name: str) -> None:
    stiffness, damping, limit, reason = OBSTACLES[name]
    found = scatter(lambda line: line.add_spring(scattering.OBSTACLE, stiffness, damping))
    exact = (
        CONTINUUM[0].reflection(stiffness + 1j * OMEGA * damping, OMEGA),
        STEPS[0].reflection(STEPS[0].stiffened(stiffness) + 1j * BALANCED * damping, OMEGA),
    )
    show(evidence, name, found, exact, (limit, reason))


MASSES = {
    2.0: (
        2.6e-2,
        "at 30 Hz |r u| = ½ of 1.1 %, ω²m 0.50 µm/N = 3.6 %, and (ωh)²/6 = 0.6 % as a mass meets"
        " accelerations, not places at the end of the step",
    ),
    8.0: (
        3.5e-2,
        "at 30 Hz |r u| = 0.19 of 1.1 %, ω²m 0.50 µm/N = 14 % and (ωh)²/6 = 0.6 %; and of the"
        " square of their sum",
    ),
}


@pytest.mark.parametrize("mass", MASSES)
def test_mass(evidence: Evidence, mass: float) -> None:
    found = scatter(lambda line: line.add_mass(scattering.OBSTACLE, mass))
    exact = (
        CONTINUUM[0].reflection(-mass * OMEGA**2 + 0j, OMEGA),
        STEPS[0].reflection_of_mass(mass, OMEGA),
    )
    show(evidence, f"{mass:g} kg", found, exact, MASSES[mass])
    energy = np.abs(found.back) ** 2 + np.abs(found.on) ** 2
    evidence.below(
        f"| |r|² + |t|² − 1 |, {mass:g} kg, largest of 2 to 30 Hz",
        np.abs(energy - 1.0).max(), 1e-5, unit="1",
        reason="a mass keeps energy, in any mesh: what is left is the end of the record,"
        " which is cut at 1e-6 of the pulse",
    )  # fmt: skip
    hertz = scattering.FREQUENCIES
    evidence.figure(
        f"explicit-{mass:g}-kg",
        {"closed form": (hertz, np.abs(exact[0])), "run": (hertz, np.abs(found.back))},
        x="frequency in Hz", y="|r|", title=f"{mass:g} kg on the contact wire, explicit steps",
    )  # fmt: skip


def hang(line: straight.Straight) -> None:
    kind = {"stiffness": dropper.STIFF, "damping": dropper.DAMPER}
    line.add_dropper(scattering.OBSTACLE, DropperType.model_validate(kind), 200.0)


def pulled(waves: list[Waves], stiffness: float, omega: np.ndarray) -> tuple[Complex, Complex]:
    """Return r and s: g₁f and g₂f of a dropper without mass, f = K'/(1 + K' Σ (g + n))."""
    (g1, n1), (g2, n2) = ((wire.far(OMEGA), wire.near(OMEGA)) for wire in waves)
    both = stiffness + 1j * omega * dropper.DAMPER
    force = both / (1.0 + both * (g1 + n1 + g2 + n2))
    return -g1 * force, g2 * force


def test_taut_dropper(evidence: Evidence) -> None:
    found = scatter(hang, 2, heights=(0.0, dropper.APART))
    stiffness = dropper.STIFF / (1.0 + dropper.STIFF * sum(wire.missing for wire in STEPS))
    wire, steps = pulled(CONTINUUM, dropper.STIFF, OMEGA), pulled(STEPS, stiffness, BALANCED)
    reason = (
        "at 30 Hz both wires send 1.1 % and 1.5 % more, of which r and s, ½ each, are off by 0.6;"
        " their points yield 0.3 µm/N more than with R at rest, K' of which is 1.5 %, and half of"
        " that: ½ (½ 1.5 % + 0.6 (1.1 % + 1.5 %))"
    )
    show(evidence, "dropper", found, (wire[0], steps[0]), (1.2e-2, reason))
    for what, s, most, why in (
        ("closed form", wire[1], 1.2e-2, reason),
        ("that of the steps", steps[1], 1e-5, RECORD),
    ):
        evidence.below(
            f"|s − {what}| of the other wire, both ways, largest of 2 to 30 Hz",
            np.abs(np.array(found.across) - s).max(), most, unit="1", reason=why,
        )  # fmt: skip


SPRING, DAMPER = OBSTACLES
FAULTS = [
    Fault("spring 1 % too stiff", scaled("springs", "stiffness", 1.01), test_spring_and_damper,
          name=SPRING),
    Fault("damper 1 % too strong", scaled("springs", "damping", 1.01), test_spring_and_damper,
          name=DAMPER),
    Fault("mass 1 % too heavy", scaled("masses", "mass", 1.01), test_mass, mass=2.0),
    *(Fault(f"{column} of the dropper 1 % too large", scaled("links", column, 1.01),
            test_taut_dropper)
      for column in ("stiffness", "damping")),
    *(Fault(f"{column} of the chain 0.1 % too large", scaled("segments", column, 1.001), test_mass,
            mass=8.0)
      for column in ("tension", "mass")),
    Fault("EI 1 % too large", scaled("bends", "EI", 1.01), test_taut_dropper),
    Fault("points yield as those of a chain", without("fitted_bends"), test_spring_and_damper,
          name=SPRING),
    Fault("masses 0.4 m apart in place of 0.5 m",
          patch.multiple(__name__, X=np.arange(-40.0, 280.2, 0.4)), test_taut_dropper),
]  # fmt: skip
