"""Beam under tension on an elastic foundation under a moving force

A force F that has run with the speed V for ever carries its deflection along, w(ξ) with ξ = x − Vt:

    EI w'''' − (T − μV²) w'' − CV w' + K w = F δ(ξ)

K and C are stiffness and damping of the foundation per metre. Of the four roots p of
EI p⁴ − (T − μV²) p² − CV p + K = 0 two rise and two fall; with P' the derivative of that polynomial

    ahead w = Σ F e^{pξ}/P'(p) over Re p < 0,   behind w = −Σ F e^{pξ}/P'(p) over Re p > 0

Without damping w(0) = F/(2 √(K (T − μV² + 2√(EI K)))), which grows without bounds at the critical
speed V² = (T + 2√(EI K))/μ. Derived here by residues; as in books on moving loads (from memory:
Frýba, Vibration of solids and structures under moving loads, 1972).

The program is asked by a run: a strip of 1e-9 kg presses with 100 N and goes from 20 m to 130 m of
a straight wire of 160 m, a spring and a damper at each node; rigid contact, trapezoidal rule. Two
beams: a contact wire (20 kN, 1.35 kg/m, 200 N m²; K = 200 N/m², C = 30 N s/m²; elements 0.1 m,
0.5 ms) and a rail without tension (6 kg/m, 200 kN m²; K = 2 kN/m², C = 120 N s/m²; elements 0.5 m,
1 ms). From 100 m on nothing is left of the start; there, the deflection under the strip and at four
places is compared as the strip comes and goes.
"""

from dataclasses import dataclass
from math import sqrt

import numpy as np
import pytest

from arcless.model.line.parts.components import Wire
from tests.support import straight
from tests.support.evidence import Evidence
from tests.support.faults import Fault, scaled
from tests.support.pushing import press
from tests.support.waves import Complex, Floats, Waves

FORCE, LENGTH, START, END, SETTLED = 100.0, 160.0, 20.0, 130.0, 100.0
POINTS = (105.0, 110.0, 115.0, 120.0)


@dataclass(frozen=True)
class Beam:
    """A wire on a foundation: N/m² and N s/m²; elements in m, steps in s."""

    kind: Wire
    stiffness: float
    damping: float
    element: float
    step: float

    @property
    def critical(self) -> float:
        wire = Waves.on(self.kind)
        return sqrt((wire.tension + 2.0 * sqrt(wire.bending * self.stiffness)) / wire.density)

    def roots(self, speed: float) -> tuple[Complex, Complex]:
        """Return p and F/P'(p)."""
        wire = Waves.on(self.kind)
        left = wire.tension - wire.density * speed**2
        polynomial = [wire.bending, 0.0, -left, -self.damping * speed, self.stiffness]
        p = np.roots(polynomial).astype(np.complex128)
        return p, np.asarray(FORCE / np.polyval(np.polyder(polynomial), p))

    def carried(self, speed: float, ahead: Floats) -> Floats:
        """Deflection in m at distances ahead of the force in m."""
        w = np.zeros_like(ahead)
        for p, share in zip(*self.roots(speed), strict=True):
            here = ahead < 0.0 if p.real > 0.0 else ahead >= 0.0
            w[here] -= np.sign(p.real) * (share * np.exp(p * ahead[here])).real
        return w

    def stepped(self, speed: float) -> float:
        """Return the effect of the step over the deflection under the force: Σ |F/P'| |pVh|²/12."""
        p, share = self.roots(speed)
        off = np.abs(share) * np.abs(p * speed * self.step) ** 2 / 12.0
        return float(off.sum() / self.carried(speed, np.zeros(1))[0])


BEAMS = {
    "contact wire": Beam(straight.wire(20e3, 1.35, 200.0, 15e6), 200.0, 30.0, 0.1, 5e-4),
    "rail": Beam(straight.wire(1.0, 6.0, 2e5, 1e9), 2e3, 120.0, 0.5, 1e-3),
}
CASES = [("contact wire", 60.0), ("contact wire", 110.0), ("rail", 30.0), ("rail", 60.0)]


@pytest.mark.parametrize(("name", "speed"), CASES)
def test_steady_state(evidence: Evidence, name: str, speed: float) -> None:
    beam = BEAMS[name]
    x = np.linspace(0.0, LENGTH, round(LENGTH / beam.element) + 1)
    line = straight.Straight(x, beam.kind)
    for place in x[1:-1]:
        line.add_spring(place, beam.stiffness * beam.element, beam.damping * beam.element)
    time = beam.step * np.arange(int((END - START) / speed / beam.step) + 1)
    run = press(line.find(), FORCE, START + speed * time, speed, beam.step, points=POINTS)
    place = START + speed * run.time
    late = place > SETTLED
    ahead = np.array(POINTS) - place[late, None]
    exact = beam.carried(speed, ahead.ravel()).reshape(ahead.shape)
    largest = float(beam.carried(speed, np.zeros(1))[0])
    assert np.count_nonzero(late) > 200
    title = f"{name}, {speed / beam.critical:.2f} of the critical speed"
    allowed = 1.5 * beam.stepped(speed)
    reason = (
        "the time step moves each root p by (pVh)²/12 of it, and the deflection by the sum of that"
        " over the shares of the roots; half as much again for elements and springs at nodes"
    )
    evidence.close(
        f"deflection under the force, {title}", 1e3 * run.height[-1], 1e3 * largest, unit="mm",
        relative=allowed, reason=reason,
    )  # fmt: skip
    evidence.below(
        f"|w − closed form| / largest w, {title}, largest of all places and times",
        np.abs(run.points[late] - exact).max() / largest, allowed, unit="1", reason=reason,
    )  # fmt: skip
    across = np.linspace(-30.0, 15.0, 181)
    evidence.figure(
        f"{name}-{speed:.0f}".replace(" ", "-"),
        {
            "closed form": (across, 1e3 * beam.carried(speed, across)),
            "run": (ahead[::5, 1], 1e3 * run.points[late][::5, 1]),
        },
        x="distance ahead of the force in m", y="deflection in mm", title=title,
    )  # fmt: skip


FAULTS = [
    *(Fault(f"{column} of the foundation 1 % too large", scaled("springs", column, 1.01),
            test_steady_state, name="rail", speed=60.0)
      for column in ("stiffness", "damping")),
    *(Fault(f"{column} of the rail 1 % too large", scaled("wires", column, 1.01), test_steady_state,
            name="rail", speed=30.0)
      for column in ("EI", "mass")),
    Fault("tension of the wire 1 % too large", scaled("wires", "tension", 1.01), test_steady_state,
          name="contact wire", speed=60.0),
]  # fmt: skip
