"""A wire of finite length under a force that moves: its series, and the run to be held against it.

Every mode φ = sin κx, κ = nπ/L, obeys q̈ + ω² q = p sin κ(x₀ + Vt), with p = 2F/(μL) and
μω² = Tκ² + EIκ⁴, from rest under the force at x₀:

    q = A sin(κx₀ + κVt) + a cos ωt + b sin ωt,   A = p/(ω² − κ²V²)
    a = (p/ω² − A) sin κx₀,   b = −A κV cos(κx₀)/ω

The trapezoidal rule balances at the middle of steps, where motion is the mean of both ends. With
W = (2/h) tan(κVh/2) in place of κV, ω' = (2/h) arctan(ωh/2) in place of ω, the answers there are

    A = p/(ω² − W²),   a = p sin κx₀/ω² − A sin κx₀/cos(κVh/2),   b = −A W cos κx₀/(ω cos(κVh/2))
    q = A sin(κx₀ + κVt) + cos(ω'h/2) (a cos ω't + b sin ω't)
"""

from dataclasses import dataclass

import numpy as np

from arcless.model.line.parts.components import Wire
from tests.support.pushing import Pressed, press
from tests.support.straight import Floats, Straight
from tests.support.waves import Waves

LENGTH, START, END = 60.0, 10.0, 55.0  # m
FORCE = 100.0  # N
STEP, ELEMENT = 1e-3, 0.05  # s, m
POINTS = (15.0, 30.0, 45.0)  # m
# The static series falls with 1/n²: what is left out is F L/(10 n T), without bending 2e-5 m.
MODES = 1600


@dataclass(frozen=True)
class Series:
    """Deflection at `POINTS` (time × place) and under the force, m."""

    points: Floats
    under: Floats


def series(kind: Wire, speed: float, time: Floats, *, stepped: bool) -> Series:
    """Sum the series at times t; with `stepped`, as the trapezoidal rule steps each mode."""
    wire = Waves.on(kind)
    kappa = np.arange(1, MODES + 1)[:, None] * np.pi / LENGTH
    omega = kappa * np.sqrt((wire.tension + wire.bending * kappa**2) / wire.density)
    load, driven, half = 2.0 * FORCE / (wire.density * LENGTH), kappa * speed, 0.5 * STEP
    sine, cosine = np.sin(kappa * START), np.cos(kappa * START)
    free, mean, mean_driven = omega, 1.0, 1.0
    shown = driven
    if stepped:
        free, shown = np.arctan(omega * half) / half, np.tan(driven * half) / half
        mean, mean_driven = np.cos(free * half), np.cos(driven * half)
    own = load / (omega**2 - shown**2)
    a = load * sine / omega**2 - own * sine / mean_driven
    b = -own * shown * cosine / (omega * mean_driven)
    q = own * np.sin(kappa * START + driven * time)
    q += mean * (a * np.cos(free * time) + b * np.sin(free * time))
    under = np.einsum("nt,nt->t", np.sin(kappa * (START + speed * time)), q)
    return Series((np.sin(np.outer(POINTS, kappa)) @ q).T, under)


def run(kind: Wire, speed: float) -> Pressed:
    """Run the force along the wire."""
    line = Straight(np.linspace(0.0, LENGTH, round(LENGTH / ELEMENT) + 1), kind)
    time = STEP * np.arange(int((END - START) / speed / STEP) + 1)
    return press(line.find(), FORCE, START + speed * time, speed, STEP, points=POINTS)


def furthest(found: Pressed, exact: Series) -> float:
    """Largest difference at all places and times, over the largest deflection."""
    apart = max(np.abs(found.points - exact.points).max(), np.abs(found.height - exact.under).max())
    return float(apart / exact.under.max())
