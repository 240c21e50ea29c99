"""Scattering of waves at a dropper between two wires, taut and going slack

A wave on the lower wire meets a dropper (stiffness K, damper C, masses m₁ and m₂ at its ends with
clamps) that hangs on a second wire. With the answers gᵢ + nᵢ of the wires to a force (see the
reflection at a mass; g travels, n stays near) the motions u of both clamps and the forces f of the
dropper on the wires are

    u = (1, 0) + (g + n) f,   f = −D u,   D = [K' − ω²m₁, −K'; −K', K' − ω²m₂],   K' = K + iωC

so r = g₁f₁ comes back, t = 1 + g₁f₁ goes on, and s = g₂f₂ runs off to both sides on the other wire.

A dropper that pulls only, with the tension S at rest, between two strings: with the impedances
Zᵢ = √(Tᵢμᵢ) and the motion a(t) of the wave that comes in, its elongation e obeys

    ė = −ȧ − (1/2Z₁ + 1/2Z₂) max(K e, −S)

Both derived here; the second is solved to 1e-9 by the Runge–Kutta method of order 5 of scipy.

The program is asked as for the mass: two straight wires (20 kN, 1.35 kg/m, 200 N m²; 16 kN, 1.08
kg/m, 100 N m²), runs with and without the dropper, spectra of the motion 20 m from it on either
side and on both wires; elements of 0.25 m, 0.05 m at the dropper, 1 ms. Two loads give the dropper
its tension, 200 N. For the slack one the wires have no bending stiffness, S = 15 N, the wave has
3 mm; elements of 4 mm at the dropper, 0.25 ms.
"""

from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from arcless.model.line.parts.components import DropperType
from arcless.simulate.setup.core_data import LoadData
from tests.support import scattering, straight
from tests.support.evidence import Evidence
from tests.support.faults import Fault, scaled, spoiled
from tests.support.pushing import press
from tests.support.waves import Complex, Waves, pulse

WIRES = straight.wire(20e3, 1.35, 200.0, 15e6), straight.wire(16e3, 1.08, 100.0, 12e6)
STRINGS = straight.wire(20e3, 1.35, 0.0, 15e6), straight.wire(16e3, 1.08, 0.0, 12e6)
APART, LENGTH_MASS = 1.2, 0.4  # m, kg/m
CLAMPS = 0.3, 0.2  # kg, lower and upper
STIFF, DAMPER = 5e4, 50.0
SOFT, PULL, STEP, STEPS = 2e4, 15.0, 2.5e-4, 2800
# No wave reaches the strip here; in m.
ASIDE = 235.0


def hang(line: straight.Straight) -> None:
    kind = {"stiffness": STIFF, "damping": DAMPER, "mass": LENGTH_MASS}
    line.add_dropper(scattering.OBSTACLE, DropperType.model_validate(kind), 200.0)
    for which, clamp in enumerate(CLAMPS):
        line.add_mass(scattering.OBSTACLE, clamp, which)


def closed_form(omega: np.ndarray) -> tuple[Complex, Complex]:
    """Return g₁f₁ and g₂f₂."""
    waves = [Waves.on(kind) for kind in WIRES]
    far = np.array([wave.far(omega) for wave in waves])
    answer = far + np.array([wave.near(omega) for wave in waves])
    both = STIFF + 1j * omega * DAMPER
    held = np.array([both - omega**2 * (clamp + 0.5 * LENGTH_MASS * APART) for clamp in CLAMPS])
    stiffness = np.array([[held[0], -both], [-both, held[1]]]).transpose(2, 0, 1)
    flexible = np.eye(2) + answer.T[:, :, None] * stiffness
    u = np.linalg.solve(flexible, np.tile([[1.0], [0.0]], (len(omega), 1, 1)))
    f = -(stiffness @ u)[:, :, 0]
    return far[0] * f[:, 0], far[1] * f[:, 1]


def test_taut_dropper(evidence: Evidence) -> None:
    waves = tuple(Waves.on(kind) for kind in WIRES)
    x = scattering.fine(0.25, 0.05)
    found = scattering.scatter(x, WIRES, waves, hang, heights=(0.0, APART))
    back, across = closed_form(found.omega)
    reason = (
        "over 40 m the wave of 30 Hz is out of phase by 2.4e-5 rad, (EI k²/2T)(kh)⁴/720 of k with"
        " h = 0.25 m; as much again for the field at the dropper"
    )
    for name, value, exact in (
        ("r (back)", found.back, back),
        ("t (on)", found.on, 1.0 + back),
        ("s (other wire, left)", found.across[0], across),
        ("s (other wire, right)", found.across[1], across),
    ):
        evidence.below(
            f"|{name} − closed form|, largest of 2 to 30 Hz", np.abs(value - exact).max(), 5e-5,
            unit="1", reason=reason,
        )  # fmt: skip
    evidence.close(
        "|s| at 10 Hz", abs(found.across[0][4]), abs(across[4]), unit="1", relative=1e-5,
        reason="the phase of 10 Hz is off by 3e-7 rad, the record ends 1e-6 of the pulse high",
    )  # fmt: skip
    hertz = found.omega / (2.0 * np.pi)
    evidence.figure(
        "taut",
        {
            "|r|, closed form": (hertz, abs(back)), "|r|, run": (hertz, abs(found.back)),
            "|s|, closed form": (hertz, abs(across)), "|s|, run": (hertz, abs(found.across[0])),
        },
        x="frequency in Hz", y="amplitude", title="A wave of the lower wire at a dropper",
    )  # fmt: skip


def test_dropper_that_goes_slack(evidence: Evidence) -> None:
    x = scattering.fine(0.25, 0.004)
    line = straight.Straight(x, *STRINGS, heights=(0.0, APART))
    line.add_dropper(scattering.OBSTACLE, DropperType(stiffness=SOFT), PULL)
    time = STEP * np.arange(STEPS + 1)
    added = pulse(time, 0.08, 0.012, scattering.SIZE)
    source = LoadData([(line.node(scattering.SOURCE), straight.UP, 1.0)], added.tolist())
    run = press(line.find(), 1e-3, np.full(STEPS + 1, ASIDE), 0.0, STEP, loads=[source])
    lower, upper = (Waves.on(kind) for kind in STRINGS)
    delay = (scattering.OBSTACLE - scattering.SOURCE) / lower.speed
    soft = 0.5 / lower.impedance + 0.5 / upper.impedance

    def rate(t: float, e: np.ndarray) -> np.ndarray:
        coming = pulse(np.array([t - delay]), 0.08, 0.012, scattering.SIZE) / (2 * lower.impedance)
        return np.asarray(-coming - soft * np.maximum(SOFT * e, -PULL))

    # Far below the 0.08 N that are allowed: 1e-12 m are 2e-8 N.
    exact = solve_ivp(
        rate, (0.0, time[-1]), [0.0], "RK45", run.time, rtol=1e-9, atol=1e-12, max_step=1e-3
    )
    tension = np.maximum(PULL + SOFT * exact.y[0], 0.0)
    found = run.links[:, 0]
    assert np.count_nonzero(tension == 0.0) > 10
    evidence.below(
        "|tension − closed form| of a dropper that goes slack, largest of 0.7 s",
        np.abs(found - tension).max(), 0.08, unit="N",
        reason="in the step in which it tightens, the balance in the middle decides for all of it:"
        " up to 1/8 of 0.25 ms at 2.2 kN/s",
    )  # fmt: skip
    evidence.close(
        "time it is slack", 1e3 * STEP * np.count_nonzero(found == 0.0),
        1e3 * STEP * np.count_nonzero(tension == 0.0), unit="ms", absolute=1e3 * STEP,
        reason="one step",
    )  # fmt: skip
    part = slice(1400, 2100)
    evidence.figure(
        "slack",
        {"closed form": (run.time[part], tension[part]), "run": (run.time[part], found[part])},
        x="time in s", y="tension in N", title="A dropper that goes slack as a wave passes",
    )  # fmt: skip


def heavier(arguments: dict[str, Any]) -> bool:
    """Make the wire that is not pushed 1 % heavier."""
    mass = arguments["parts"]["wires"]["mass"]
    other = mass == WIRES[1].mass
    mass[other] *= 1.01
    return bool(other.any())


def pushing(arguments: dict[str, Any]) -> bool:
    """Let droppers push."""
    links = arguments["parts"]["links"]
    links["unilateral"] = False
    return len(links) > 0


FAULTS = [
    *(Fault(f"{column} of the dropper 1 % too large", scaled("links", column, 1.01),
            test_taut_dropper)
      for column in ("stiffness", "damping", "mass")),
    Fault("clamps forgotten", scaled("masses", "mass", 0.0), test_taut_dropper),
    Fault("other wire 1 % too heavy", spoiled(heavier), test_taut_dropper),
    Fault("other wire 1 % too heavy", spoiled(heavier), test_dropper_that_goes_slack),
    Fault("the dropper can push", spoiled(pushing), test_dropper_that_goes_slack),
    Fault("stiffness of the dropper 1 % too large", scaled("links", "stiffness", 1.01),
          test_dropper_that_goes_slack),
]  # fmt: skip
