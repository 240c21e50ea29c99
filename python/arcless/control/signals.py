"""Signals that a controller sees, and what a real pantograph needs to measure each of them.

All follow from what a controller of `arcless.run` is given (`ControlInput`), so that a law made in
the environment is the same law in a run. They are sampled without noise and without delay.

Sensors below the strips show the contact force without the inertia of what is above them. With m
the last mass, z its displacement, k and c the joint below it and L the lift on it, Newton's law

    m z̈ = F_s + L − F_c,     F_s = F_s0 + k (u − z) + c (u̇ − ż)

has F_s0 = F_c0 − L at the start, in equilibrium; u is the displacement of the mass below. Lift that
does not change with time is in F_s0.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from arcless.errors import ModelError
from arcless.model import Pantograph
from arcless.units import show

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Sensor:
    """Force sensor below the strips: joint and lift of the last mass of a pantograph.

    Attributes
    ----------
    stiffness_N_m, damping_N_s_m
        Spring and damper below the last mass.
    lift_N
        Upward force of the air on the last mass, N.
    """

    stiffness_N_m: float  # noqa: N815 - units are spelt as in every result
    damping_N_s_m: float  # noqa: N815
    lift_N: float  # noqa: N815


@dataclass(frozen=True)
class Sample:
    """Samples of several pantographs side by side, a row for each.

    Attributes
    ----------
    contact_force_N
        Contact force of the step before, N.
    displacement_m, velocity_m_s
        Of the masses from base to head, since the start.
    displacement_before_m, velocity_before_m_s
        At the sample before; those of now where there was none.
    start_force_N
        Contact force at the start, N.
    asked_force_N
        Force asked for last, within the limits, N.
    speed_m_s
        Speed along the track.
    span_position
        Place within the span, from 0 at one support to 1 at the next.
    """

    contact_force_N: Floats  # noqa: N815
    displacement_m: Floats
    velocity_m_s: Floats
    displacement_before_m: Floats
    velocity_before_m_s: Floats
    start_force_N: Floats  # noqa: N815
    asked_force_N: Floats  # noqa: N815
    speed_m_s: float
    span_position: Floats


@dataclass(frozen=True)
class Reader:
    """Reader of samples: interval between two of them in s, and the force sensor."""

    sample_time_s: float
    sensor: Sensor | None


@dataclass(frozen=True)
class Signal:
    """Signal that a controller may see.

    Attributes
    ----------
    name
        Its name, which ends with the unit.
    unit
        Unit; 1 for none.
    low, high
        Range of the sensor. An episode ends where a signal leaves it.
    scale
        Size that is usual, in the unit.
    what
        Its meaning.
    measured_by
        What a real pantograph needs for it.
    masses
        True where it needs a pantograph of masses without a head of several strips.
    read
        Reads it from samples.
    """

    name: str
    unit: str
    low: float
    high: float
    scale: float
    what: str
    measured_by: str
    masses: bool
    read: Callable[[Sample, Reader], Floats]


def _strip_force(sample: Sample, reader: Reader) -> Floats:
    sensor = reader.sensor
    assert sensor is not None  # `chosen` asks for it
    u, v = sample.displacement_m, sample.velocity_m_s
    spring = sensor.stiffness_N_m * (u[:, -2] - u[:, -1])
    damper = sensor.damping_N_s_m * (v[:, -2] - v[:, -1])
    return np.asarray(sample.start_force_N - sensor.lift_N + spring + damper)


def _acceleration(sample: Sample, reader: Reader, mass: int) -> Floats:
    gained = sample.velocity_m_s[:, mass] - sample.velocity_before_m_s[:, mass]
    return np.asarray(gained / reader.sample_time_s)


def _rate(sample: Sample, reader: Reader, mass: int) -> Floats:
    moved = sample.displacement_m[:, mass] - sample.displacement_before_m[:, mass]
    return np.asarray(moved / reader.sample_time_s)


# Ranges are wide: a force of 5 kN or a frame 2 m off is no operation but a failure.
FORCE, ACCELERATION, WAY, SPEED = 5000.0, 2000.0, 2.0, 50.0
ALL = (
    Signal(
        "strip_force_N", "N", -FORCE, FORCE, 50.0,
        "force of the sensors below the strips, without the inertia of what is above them",
        "force sensors below the strips",
        True, _strip_force,
    ),
    Signal(
        "contact_force_N", "N", 0.0, FORCE, 50.0,
        "contact force of the time step before",
        "force sensors below the strips, corrected by accelerometers on the strips (EN 50317)",
        False, lambda sample, _: sample.contact_force_N,
    ),
    Signal(
        "head_acceleration_m_s2", "m/s²", -ACCELERATION, ACCELERATION, 20.0,
        "acceleration of the last mass, mean over the sample",
        "accelerometers on the strips",
        True, lambda sample, reader: _acceleration(sample, reader, -1),
    ),
    Signal(
        "frame_acceleration_m_s2", "m/s²", -ACCELERATION, ACCELERATION, 10.0,
        "acceleration of the first mass, mean over the sample",
        "an accelerometer on the frame",
        True, lambda sample, reader: _acceleration(sample, reader, 0),
    ),
    Signal(
        "frame_displacement_m", "m", -WAY, WAY, 0.05,
        "displacement of the first mass since the start, upwards positive",
        "an angle sensor at the lower arm",
        True, lambda sample, _: sample.displacement_m[:, 0],
    ),
    Signal(
        "frame_velocity_m_s", "m/s", -SPEED, SPEED, 0.3,
        "velocity of the first mass: displacement gained over the sample",
        "an angle sensor at the lower arm",
        True, lambda sample, reader: _rate(sample, reader, 0),
    ),
    Signal(
        "asked_force_N", "N", -10_000.0, 10_000.0, 50.0,
        "last force requested, within the limits of the actuator",
        "nothing: the controller knows it",
        False, lambda sample, _: sample.asked_force_N,
    ),
    Signal(
        "speed_m_s", "m/s", 0.0, 200.0, 50.0,
        "speed along the track",
        "the train's own",
        False, lambda sample, _: np.full(len(sample.contact_force_N), sample.speed_m_s),
    ),
    Signal(
        "span_position_1", "1", 0.0, 1.0, 0.5,
        "place within the span, from 0 at one support to 1 at the next",
        "a position true to a metre, and a map of the supports: no pantograph in service has both",
        False, lambda sample, _: sample.span_position,
    ),
)  # fmt: skip
SIGNALS = {signal.name: signal for signal in ALL}
# Signals that sensors of a pantograph give without a map and without a measuring head.
DEFAULT = (
    "strip_force_N", "frame_acceleration_m_s2", "frame_displacement_m", "frame_velocity_m_s",
    "asked_force_N",
)  # fmt: skip


def chosen(names: Sequence[str], pantograph: Pantograph) -> tuple[Signal, ...]:
    """Return signals by their names.

    Raises
    ------
    ModelError
        No name, an unknown one, one twice, or one that this pantograph has no sensor for.
    """
    if isinstance(names, str) or not names or len(set(names)) != len(names):
        raise ModelError(
            "signals to observe",
            where="observe",
            got=show(str(names)),
            expected="a list of different names",
        )
    for name in names:
        signal = SIGNALS.get(name)
        if signal is None:
            known = ", ".join(SIGNALS)
            raise ModelError(
                "unknown signal", where="observe", got=show(str(name)), expected=f"one of {known}"
            )
        if signal.masses and not _has_masses(pantograph):
            free = ", ".join(one.name for one in ALL if not one.masses)
            raise ModelError(
                f"{name} is not defined for the pantograph {pantograph.name}",
                where="observe",
                got="matrices, one mass, or a head of several strips",
                expected=f"a chain of masses without a head, or signals among {free}",
            )
    if "strip_force_N" in names:
        sensor_of(pantograph, 0.0)
    return tuple(SIGNALS[name] for name in names)


def sensor_of(pantograph: Pantograph, speed_m_s: float) -> Sensor | None:
    """Return the force sensor below the last mass; None where there is no chain of masses.

    Raises
    ------
    ModelError
        The joint below the last mass is no linear spring and damper, or its lift is a table.
    """
    if not _has_masses(pantograph):
        return None
    last = pantograph.masses[-1]
    linear = last.stiffness is not None and last.damping is not None
    if not linear or last.friction is not None or last.stops is not None or last.lift is not None:
        raise ModelError(
            f"strip_force_N is not defined for the pantograph {pantograph.name}",
            where="observe",
            got="a table, friction or stops at the joint below the last mass",
            expected="a linear spring and damper there, or contact_force_N",
        )
    assert last.stiffness is not None
    assert last.damping is not None
    return Sensor(last.stiffness, last.damping, last.aerodynamic * speed_m_s**2)


def observation(signals: Sequence[Signal], sample: Sample, reader: Reader) -> Floats:
    """Return the signals of samples, a row for each pantograph and a column for each signal."""
    return np.stack([signal.read(sample, reader) for signal in signals], axis=1)


def _has_masses(pantograph: Pantograph) -> bool:
    return len(pantograph.masses) > 1 and pantograph.head is None
