"""Wake of one pantograph, and the force of a second one that follows from it.

A run of one pantograph gives the displacement u(x, t) of the wire. A second one d behind comes to
the place x when the first is at x + d, and meets there

    w(x; d) = u(x, (x + d)/v)

so that, to first order, its force is that of the first one less what the moved wire takes away:

    F₂ = F₁ − K w,   1/K(Ω) = 1/K_p(Ω) + 1/(iΩZ) + 1/k_c,   Z = 2√(Tμ)

at the frequency Ω that the pantograph meets w with: dynamic stiffness K_p of the pantograph at its
strip, iΩZ of a wire without supports at any speed below that of its waves (closed-forms.md), and
k_c of the contact. Second order, and what the second one sends ahead and gets back, are left out.

On a line of equal spans the wake repeats at the same place of the next span L/v later, so a wave of
frequency f = ω/2π and wave number k in it fulfils ω = v k + 2πn v/L. One that runs back at the
phase speed c has k = −ω/c, and

    f = n v/(L (1 + v/c))

which is the delay d/(c + v): over d the part of w with n waves in a span turns by 2πf d/v. Waves
that the second one sends ahead reach the first after d/(c − v), and turn by n d/(L (1 − v/c)).
"""

from dataclasses import dataclass
from functools import cached_property
from math import ceil, pi, sqrt

import numpy as np
from numpy.typing import NDArray

from arcless.assess.signals.filter import low_pass
from arcless.model import Scenario
from arcless.pantograph.equation_of_motion import matrices
from arcless.pantograph.natural_modes import raising_the_strips
from arcless.results import Result

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]

CUTOFF_HZ = 20.0
# Points in a span at which the motion is recorded, and rate in Hz at which forces are taken: five
# times what the low-pass needs. Spans before and after the section keep the ends of signals away.
RECORDED, RATE_HZ = 20, 200.0
MARGIN = 1
# Frequencies that are tried for a part of the wake, in Hz: finer than 1 % of the lowest.
TRIED = np.arange(0.2, 8.0, 0.01)


def recorded_points(first: float, last: float, length: float) -> list[float]:
    """Return the places in m whose motion is recorded for a section of spans of a length in m."""
    spans = round((last - first) / length) + 2 * MARGIN
    start = first - MARGIN * length
    return [start + length * i / RECORDED for i in range(spans * RECORDED + 1)]


@dataclass(frozen=True)
class Wake:
    """Displacement behind one pantograph, over section and margins.

    Attributes
    ----------
    scenario
        The scenario that was run, with one pantograph at one speed.
    x
        Places in m, evenly spaced.
    force
        Contact force of the pantograph at each place in N.
    inside
        Places in the section.
    """

    scenario: Scenario
    x: Floats
    force: Floats
    inside: slice
    _time: Floats
    _places: Floats
    _uplift: Floats
    _start: float

    @classmethod
    def of(cls, result: Result, length: float) -> "Wake":
        """Return the wake in a result with the motion of `recorded_points`, spans in m long."""
        data, scenario = result.dataset, result.scenario
        places = np.array(scenario.output.points)
        assert scenario.speed is not None, "a wake is that of one speed"
        taken = ceil(length / scenario.speed * RATE_HZ)
        count = round((places[-1] - places[0]) / length) * taken
        x = np.linspace(places[0], places[-1], count + 1)
        inside = slice(MARGIN * taken, len(x) - 1 - MARGIN * taken)
        position, force = (np.asarray(data[n])[:, 0] for n in ("position", "contact_force"))
        start = float(position[0] - scenario.speed * float(data["time"][0]))
        return cls(
            scenario,
            x,
            np.interp(x, position, force),
            inside,
            np.asarray(data["line_time"]),
            places,
            np.asarray(data["point_uplift"]),
            start,
        )

    @property
    def speed(self) -> float:
        """Speed v in m/s."""
        assert self.scenario.speed is not None
        return self.scenario.speed

    def displacement(self, distance: float) -> Floats:
        """Return w(x; d) in m at a distance d in m behind the pantograph."""
        from scipy.interpolate import RegularGridInterpolator

        moving = RegularGridInterpolator((self._time, self._places), self._uplift)
        arrival = (self.x + distance - self._start) / self.speed
        return np.asarray(moving(np.column_stack([arrival, self.x])))

    def second_force(self, distance: float) -> Floats:
        """Return the force F₂ in N of a second pantograph, to first order."""
        w = self.displacement(distance)
        change = np.fft.irfft(np.fft.rfft(w - w.mean()) * self.stiffness, len(w))
        return self.force - change

    def deviation(self, force: Floats) -> float:
        """Return σ in N of a force over the section, after the 20 Hz low-pass."""
        rate = self.speed / (self.x[1] - self.x[0])
        return float(np.std(low_pass(force, rate, CUTOFF_HZ)[self.inside]))

    @cached_property
    def stiffness(self) -> Complex:
        """K in N/m at the frequencies of a Fourier series over all places; 0 at the first."""
        placed, line = self.scenario.pantographs[0].model, self.scenario.line
        parts, strip = matrices(placed), raising_the_strips(placed)
        wires = 1 if line.twin_contact_wires is None else 2
        z = 2.0 * wires * sqrt(line.contact_wire.tension * line.contact_wire.mass)
        contact = 1.0 / self.scenario.contact.stiffness
        omega = 2.0 * pi * np.fft.rfftfreq(len(self.x), self.x[1] - self.x[0])[1:] * self.speed
        each = omega[:, None, None]
        dynamic = parts.stiffness + 1j * each * parts.damping - each**2 * parts.mass
        yields = np.linalg.solve(dynamic, strip[None, :, None].astype(complex))[:, :, 0] @ strip
        return np.concatenate([[0.0], 1.0 / (yields + 1.0 / (1j * omega * z) + contact)])

    def frequency(self, order: int, distances: Floats, length: float) -> float:
        """Return the frequency in Hz of the part with so many waves in a span in the wake."""
        waves = np.exp(-2j * pi * order * self.x[self.inside] / length)
        part = np.array([(self.displacement(d)[self.inside] * waves).mean() for d in distances])
        part *= np.hanning(len(distances))
        turning = np.exp(-2j * pi * np.outer(TRIED, distances) / self.speed)
        return float(TRIED[np.argmax(np.abs(turning @ part))])
