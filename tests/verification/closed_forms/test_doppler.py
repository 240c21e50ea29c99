"""Doppler factor: waves from a moving force, their echo, and waves thrown back by a moving mass

A force f(t) that runs along a string with the speed V sends waves ahead and behind. With Z = √(Tμ)
and I the integral of f they are I(τ)/(2Z), τ the time at which they left: frequencies become

    ahead ω/(1 − V/c),   behind ω/(1 + V/c),   behind/ahead = α = (c − V)/(c + V)

An echo from a fixed end comes back to the force with ω/α. A wave e^{i(ωt + kx)} from ahead meets a
strip of the dynamic stiffness D, which sees ω' = ω (1 + V/c); what it throws back ahead has

    ω'/(1 − V/c) = ω/α,   r = −D/(D + 2iω'Z),   1/D = 1/(−Mω'²) + 1/k

M is its mass, k the stiffness of the contact. All derived here: by the characteristics of the
string, the force enters the motion of its own place as I/(2Z) at any speed. α and 1/α are in books
on contact lines (from memory: Kießling, Puschmann, Schmieder, Contact lines for electric railways).

The program is asked by runs at 40 m/s on a straight string (20 kN, 1.35 kg/m, trapezoidal rule,
0.5 ms): a strip of 1e-9 kg presses with 100 N, its force sounds a tone of 8 Hz that swells and
fades; the run without the tone is taken away. Spectra of the motion at places, or of the height
under the strip, have their centre at the frequency. For the mass (8 kg, contact of 50 kN/m) a pulse
starts 70 m ahead; the run without it is taken away, and the wave that comes in, which is known.
The trapezoidal rule moves a wave of ω as one of Ω = (2/h) tan(ωh/2) should; closed forms of spectra
have k = Ω/c, and so ω − kV = ω' in place of the above.
"""

from math import pi

import numpy as np

from arcless.simulate.setup.core_data import LoadData
from tests.support import straight
from tests.support.evidence import Evidence
from tests.support.faults import Fault, scaled
from tests.support.moving_mass import MovingMass
from tests.support.pushing import mass, press
from tests.support.python_faults import misled, press_late
from tests.support.waves import Floats, Waves, balanced, pulse, spectrum

STRING = straight.wire(20e3, 1.35, 0.0, 15e6)
WAVES = Waves.on(STRING)
SPEED, START, STEP, PRESSED = 40.0, 100.0, 5e-4, 100.0
ALPHA = (WAVES.speed - SPEED) / (WAVES.speed + SPEED)
TONE, MIDDLE, WIDTH = 8.0, 0.6, 0.1  # Hz, s, s
MASS, CONTACT = 8.0, 5e4
MET = MovingMass(WAVES, SPEED, STEP, MASS, CONTACT)


def tone(time: Floats) -> Floats:
    return np.asarray(
        20.0
        * np.exp(-0.5 * ((time - MIDDLE) / WIDTH) ** 2)
        * np.cos(2 * pi * TONE * (time - MIDDLE))
    )


def sound(end: float, points: tuple[float, ...] = ()) -> tuple[Floats, Floats, Floats]:
    """Times, motion of the places, and motion under the strip, all of the tone alone."""
    line = straight.Straight(np.arange(-100.0, end + 0.25, 0.5), STRING).find()
    time = STEP * np.arange(3801)
    place = START + SPEED * time
    added = tone(time)
    loud, quiet = (
        press(line, PRESSED, place, SPEED, STEP, added=one, points=points)
        for one in (added - added[0], None)
    )
    return loud.time, loud.points - quiet.points, loud.height - quiet.height


def frequency(time: Floats, moved: Floats, around: float) -> float:
    """Centre of the power spectrum of the velocity, Hz, over half of a frequency to either side."""
    hertz = around * np.linspace(0.5, 1.5, 401)
    power = np.abs(hertz * spectrum(time, moved, 2.0 * pi * hertz)) ** 2
    return float(hertz @ power / power.sum())


def test_tone_of_a_moving_force(evidence: Evidence) -> None:
    time, moved, _ = sound(400.0, (80.0, 180.0))
    ratio = SPEED / WAVES.speed
    behind, ahead = TONE / (1.0 + ratio), TONE / (1.0 - ratio)
    found = [
        frequency(time, own, hertz) for own, hertz in zip(moved.T, (behind, ahead), strict=True)
    ]
    reason = "the time step slows waves by (ωh)²/12 = 1.2e-4 at 12 Hz, of which V/(c − V) counts"
    for what, value, reference in (
        ("frequency ahead of the force", found[1], ahead),
        ("frequency behind it", found[0], behind),
    ):
        evidence.close(what, value, reference, unit="Hz", relative=1e-4, reason=reason)
    evidence.close(
        "behind over ahead, α", found[0] / found[1], ALPHA, unit="1", relative=1e-4, reason=reason
    )
    evidence.figure(
        "tone",
        {
            "20 m behind the start": (time[::5], 1e3 * moved[::5, 0]),
            "80 m ahead of it": (time[::5], 1e3 * moved[::5, 1]),
        },
        x="time in s", y="motion in mm", title="A tone of 8 Hz from a force at 40 m/s",
    )  # fmt: skip
    omega = 2.0 * pi * np.linspace(3.0, 18.0, 301)
    k = WAVES.number(balanced(omega, STEP))
    middles = STEP * (np.arange(3800) + 0.5)
    force = 0.5 * (tone(middles - 0.5 * STEP) + tone(middles + 0.5 * STEP))
    for name, own, way, side in (
        ("behind", moved[:, 0], 20.0, -1),
        ("ahead", moved[:, 1], 80.0, 1),
    ):
        sent = spectrum(middles, force, omega - side * k * SPEED)
        exact = sent * WAVES.far(balanced(omega, STEP)) * np.exp(-1j * k * way)
        evidence.below(
            f"|spectrum − closed form| {name}, 3 to 18 Hz, over its largest",
            np.abs(spectrum(time, own, omega) - exact).max() / np.abs(exact).max(), 5e-5, unit="1",
            reason="over 80 m the waves of 18 Hz, kh = 0.46 in elements of 0.5 m, are out of phase"
            " by (kh)⁶/60480 of k, 1e-5 rad; as much again for the kink that runs with the force",
        )  # fmt: skip


def test_echo_under_the_force(evidence: Evidence) -> None:
    time, _, under = sound(200.0)
    late = time > 1.2  # the force has faded, and comes back
    found = frequency(time[late], under[late], TONE / ALPHA)
    evidence.close(
        "frequency of the echo under the force, 1/α", found, TONE / ALPHA, unit="Hz",
        relative=2e-4, reason="the time step slows waves by (ωh)²/12 = 2e-4 at 16 Hz",
    )  # fmt: skip


def test_wave_thrown_back_by_a_moving_mass(evidence: Evidence) -> None:
    source, watched = 170.0, 150.0
    fine = 112.0 + 0.05 * np.arange(360)
    x = np.concatenate([np.arange(-100.0, 112.0, 0.5), fine, np.arange(130.0, 400.25, 0.5)])
    built = straight.Straight(x, STRING)
    line, time = built.find(), STEP * np.arange(2401)
    added = pulse(time, 0.1, 0.012, 20.0)
    load = LoadData([(built.node(source), straight.UP, 1.0)], added.tolist())
    options = {"strip": mass(MASS), "points": [watched], "contact": CONTACT}
    place = START + SPEED * time
    met = press(line, PRESSED, place, SPEED, STEP, loads=[load], **options)
    calm = press(line, PRESSED, place, SPEED, STEP, **options)
    assert min(met.force.min(), calm.force.min()) > 0.0
    omega = 2.0 * pi * np.arange(2.0, 40.0, 0.25)
    force = 0.5 * (added[1:] + added[:-1])
    all_of_it = spectrum(met.time, met.points[:, 0] - calm.points[:, 0], omega)
    far, k = WAVES.far(balanced(omega, STEP)), WAVES.number(balanced(omega, STEP))
    came = spectrum(met.time, force, omega) * far * np.exp(-1j * k * (source - watched))
    exact = MET.thrown_back(omega, met.time, force, source - START, watched - START)
    evidence.below(
        "|spectrum of what a moving mass throws back − closed form|, 2 to 40 Hz, over its largest",
        np.abs(all_of_it - came - exact).max() / np.abs(exact).max(), 5e-3, unit="1",
        reason="cubic elements have no kink, which the string has at the mass: it is spread over"
        " elements of 0.05 m, 1/50 of the shortest wave",
    )  # fmt: skip


TENSION = scaled("wires", "tension", 1.01)
FAULTS = [
    Fault("tension 1 % too large", TENSION, test_tone_of_a_moving_force),
    Fault("tension 1 % too large", TENSION, test_echo_under_the_force),
    Fault("tension 1 % too large", TENSION, test_wave_thrown_back_by_a_moving_mass),
    Fault("force half a step behind its place", press_late(__name__), test_tone_of_a_moving_force),
    Fault("moving mass 1 % too heavy",
          misled(__name__, "mass", lambda kilograms: [1.01 * kilograms]),
          test_wave_thrown_back_by_a_moving_mass),
]  # fmt: skip
