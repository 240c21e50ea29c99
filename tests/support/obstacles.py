"""A pulse that meets an obstacle on wires of either family: its transmission and reflection.

An obstacle at a point sends the same wave both ways, so r = t − 1, and t is what passes a place
behind it over what does without it: u/u₀, whatever the elements do to a wave on its way there.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from arcless.model.line.parts.components import Wire
from tests.support.families import Family
from tests.support.pushing import TRAPEZOIDAL, press
from tests.support.straight import Floats, Straight
from tests.support.waves import Complex, Waves, balanced, pulse, spectrum

# Multiples of these are nodes of all sizes of a family, m.
MULTIPLE = {"chain": 1.8, "cubic": 1.44}
# In m, or near it. Until the record ends, nothing comes back from the ends of the wire.
SOURCE, AT, BEHIND, END = 80.0, 120.0, 140.0, 240.0
STEP, STEPS = 5e-4, 2800  # s
PRESSED, SIZE = 10.0, 5.0  # N
HERTZ = np.array([5.0, 10.0, 20.0, 30.0])
OMEGA = 2.0 * np.pi * HERTZ


@dataclass(frozen=True)
class Obstacle:
    """Setting that a pulse meets: wires, and a function that fastens the obstacle at x in m."""

    kinds: tuple[Wire, ...]
    fasten: Callable[[Straight, float], object]
    heights: tuple[float, ...] = (0.0,)


def reflected(family: Family, size: float, obstacle: Obstacle) -> Complex:
    """Return r = t − 1 at `HERTZ`."""
    free, met = (_run(family, size, obstacle, fasten) for fasten in (False, True))
    return np.asarray(spectrum(*met, OMEGA) / spectrum(*free, OMEGA) - 1.0)


def _run(family: Family, size: float, obstacle: Obstacle, fasten: bool) -> tuple[Floats, Floats]:
    """Return times and the rise of the first wire behind the obstacle, m."""
    source, at, behind, end = places(family)
    x = family.even(end, size)
    line = family.line(x, *obstacle.kinds, heights=obstacle.heights)
    if fasten:
        obstacle.fasten(line, at)
    time = STEP * np.arange(STEPS + 1)
    added = pulse(time, middle=0.08, width=0.012, size=SIZE)
    run = press(
        line.find(), PRESSED, np.full(STEPS + 1, source), 0.0, STEP, added=added - added[0],
        nodes=[line.node(behind)], scheme=scheme(family),
    )  # fmt: skip
    return run.time, run.nodes[:, 0] - run.nodes[0, 0]


def places(family: Family) -> list[float]:
    """Return where the source, what is watched, the obstacle and the far end are, m."""
    unit = MULTIPLE[family.name]
    return [unit * round(x / unit) for x in (SOURCE, AT, BEHIND, END)]


def scheme(family: Family) -> tuple[str, list[float]]:
    """Return a scheme whose error in time is known: the trapezoidal rule, or that of the family."""
    return family.scheme if family.is_chain else TRAPEZOIDAL


def shown(family: Family) -> Floats:
    """Ω at which closed forms are taken, 1/s."""
    return OMEGA if family.is_chain else balanced(OMEGA, STEP)


def answers(family: Family, kind: Wire) -> tuple[Complex, Complex]:
    """Return G of a wire under a force at a point, and the share of it that travels, m/N."""
    wire: Waves = family.waves(kind)
    far = wire.far(shown(family))
    return far + wire.near(shown(family)), far
