"""The contact force of a run, put together from kinks and waves of a contact wire without ends.

A wire under tension that carries its weight is bent by what holds it: droppers, less their clamps,
and arms. Without a contact a pantograph that comes at the time t to x = Vt finds it at the height

    z = z₀(x) + Σ I_i(t − |x − x_i|/c)/Z,   I_i = ∫ (F_i − F_i0) dt,   Z = 2√(Tμ)

z₀ by the forces F_i0 at rest, kinks of F_i0/T, rounded by bending; the sum by what these forces
change by, each of which sends waves both ways (of a string: d'Alembert). What it presses with more
is, with the wire's answer H to a moving force (`tests/support/moving_wire.py`), the stiffness D of
the pantograph at its head, and the contact k,

    ΔP̂ = −D ẑ/(1 + D (1/k + H))

F_i0 is from the line at rest, F_i from the run. All that is left out are the masses of clamps, the
bending of waves that are sent, and the line beyond the droppers, which F_i contains.
"""

from dataclasses import dataclass

import numpy as np

from arcless.assess.statistics import force_bands
from arcless.model.line.parts.components import SteadyArmSpring
from arcless.model.pantograph.pantograph import Pantograph
from arcless.results import Result
from arcless.simulate import StaticsResult
from tests.support.explicit_waves import of_chain
from tests.support.moving_wire import MovingWire
from tests.support.waves import Complex, Floats, Waves

# Above, the filter of 20 Hz leaves 1e-5; harmonics of a span that are added.
HIGHEST = 60.0  # Hz
GRAVITY = 9.81


def held(pantograph: Pantograph, omega: Floats) -> Complex:
    """D of a chain of masses at its head, N/m."""
    below = np.full(omega.shape, np.inf + 0j)
    for one in pantograph.masses:
        joint = (one.stiffness or 0.0) + 1j * omega * (one.damping or 0.0)
        below = 1.0 / (1.0 / joint + 1.0 / below) - one.mass * omega**2
    return below


@dataclass(frozen=True)
class Parts:
    """Forces in N at 5 to 20 Hz, in the spans that are assessed, and places of the strip in m."""

    x: Floats
    run: Floats
    kinks: Floats
    droppers: Floats
    arms: Floats


@dataclass(frozen=True)
class Passing:
    """A pantograph that runs along the contact wire of a result; times in s, places in m."""

    result: Result
    rest: StaticsResult

    @property
    def time(self) -> Floats:
        """Times of the record."""
        return np.asarray(self.result.dataset["time"].values)

    @property
    def x(self) -> Floats:
        """Places of the strip at these times."""
        return np.asarray(self.result.dataset["position"].values[:, 0])

    @property
    def speed(self) -> float:
        """Speed in m/s."""
        return float((self.x[-1] - self.x[0]) / (self.time[-1] - self.time[0]))

    @property
    def wire(self) -> Waves:
        """Waves of the contact wire."""
        return of_chain(self.rest.scenario.line.contact_wire)

    def answer(self, omega: Floats) -> Complex:
        """Force per height of the wire, −D/(1 + D (1/k + H)), N/m."""
        scenario = self.rest.scenario
        own = held(scenario.pantographs[0].model, omega)
        yields = MovingWire(self.wire, self.speed).answer(omega + 0j)
        return np.asarray(-own / (1.0 + own * (1.0 / scenario.contact.stiffness + yields)))

    def kinks(self, span: int) -> Floats:
        """Force over a line whose spans are all like one, by its droppers and its arm at rest.

        The arm holds what the droppers leave of the weight. As a Fourier series over the span.
        """
        line, own = self.rest.scenario.line, self.rest.spans[span - 1]
        start, length = own["from_m"], own["to_m"] - own["from_m"]
        droppers = [one for one in self.rest.droppers if one["span"] == span]
        clamp, half = line.dropper.clamp_mass_contact_wire, 0.5 * line.dropper.mass
        forces = [one["force_N"] - GRAVITY * (clamp + half * one["length_m"]) for one in droppers]
        forces.append(GRAVITY * self.wire.density * length - sum(forces))
        places = np.array([*(one["x_m"] for one in droppers), start])
        count = int(HIGHEST * length / self.speed)
        k = 2.0 * np.pi / length * np.arange(1, count + 1)
        wire = self.wire
        bent = np.exp(-1j * np.outer(k, places)) @ np.array(forces)
        bent = bent / (length * (wire.tension * k**2 + wire.bending * k**4))
        waves = self.answer(k * self.speed) * bent
        return np.asarray(2.0 * (np.exp(1j * np.outer(self.x, k)) @ waves).real)

    def sent(self, places: Floats, changes: Floats) -> Floats:
        """Force by what forces at places change by (time × place), N."""
        step = self.time[1] - self.time[0]
        wire = self.wire
        pushes = np.cumsum(changes, axis=0) * step
        height = np.zeros_like(self.time)
        for place, push in zip(places, pushes.T, strict=True):
            sent = self.time - abs(self.x - place) / wire.speed
            height += np.interp(sent, self.time, push, left=0.0) / (2.0 * wire.impedance)
        omega = 2.0 * np.pi * np.fft.rfftfreq(len(height), step)
        low = (omega > 0.0) & (omega < 2.0 * np.pi * HIGHEST)
        answer = np.zeros(omega.shape, dtype=complex)
        answer[low] = self.answer(omega[low])
        return np.asarray(np.fft.irfft(answer * np.fft.rfft(height), len(height)))


def arm_stiffness(rest: StaticsResult, support: int) -> float:
    """Vertical stiffness of an arm, N/m: of a spring its own, of a hinged bar force over length."""
    arm = rest.scenario.line.steady_arm
    if isinstance(arm, SteadyArmSpring):
        return float(arm.vertical_stiffness)
    return float(rest.supports[support]["steady_arm_force_N"] / arm.length)


def arm_mass(rest: StaticsResult) -> float:
    """Mass of an arm that moves with the contact wire, kg: of a hinged bar a third."""
    arm = rest.scenario.line.steady_arm
    return 0.0 if isinstance(arm, SteadyArmSpring) else float(arm.mass * arm.length / 3.0)


def superposed(result: Result, rest: StaticsResult, span: int = 10) -> Parts:
    """Put the force together; the run must record droppers and supports at every step."""
    data, passing = result.dataset, Passing(result, rest)
    time, x = passing.time, passing.x
    assert np.allclose(data["line_time"].values, time)
    at_rest = np.array([one["force_N"] for one in rest.droppers])
    hung = passing.sent(data["dropper_x"].values, data["dropper_force"].values - at_rest)
    uplift = data["support_uplift"].values
    moved = np.gradient(np.gradient(uplift, time, axis=0), time, axis=0)
    stiffness, mass = arm_stiffness(rest, span - 1), arm_mass(rest)
    arms = passing.sent(data["support_x"].values, -stiffness * uplift - mass * moved)
    analysis = result.assessment
    inside = (x >= analysis.section_m[0]) & (x <= analysis.section_m[1])
    rate = 1.0 / (time[1] - time[0])

    def band(force: Floats) -> Floats:
        bands = force_bands(force[:, None], rate, analysis.low_pass_Hz, analysis.band_split_Hz)
        return np.asarray(bands.high[inside, 0])

    force = data["contact_force"].values[:, 0]
    return Parts(x[inside], *(band(own) for own in (force, passing.kinks(span), hung, arms)))
