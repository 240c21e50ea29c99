"""A pulse that meets an obstacle on a straight wire: its reflection and transmission."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from arcless.model.line.parts.components import Wire
from tests.support.pushing import EXPLICIT, TRAPEZOIDAL, Pressed, press
from tests.support.straight import Floats, Straight, stations
from tests.support.waves import Complex, Waves, balanced, pulse, spectrum

# In m. Until the record ends, nothing comes back from the ends of the wire.
SOURCE, BEFORE, OBSTACLE, BEHIND, END = 80.0, 100.0, 120.0, 140.0, 240.0
STEP, STEPS = 1e-3, 1400  # s
TIMES = STEP * np.arange(STEPS + 1)
PRESSED, SIZE = 100.0, 50.0  # N
# The pulse holds enough of these for them to be read: at 30 Hz a thirteenth of its largest.
FREQUENCIES = np.arange(2.0, 31.0, 2.0)  # Hz
Fasten = Callable[[Straight], object]


@dataclass(frozen=True)
class Scattered:
    """Amplitudes at the obstacle over that of the wave that comes in, at each of `FREQUENCIES`.

    Attributes
    ----------
    omega : at which closed forms are to be taken, 1/s (see `tests.support.waves`)
    back, on : of the reflected and of the transmitted wave, on the first wire
    across : of what goes to either side on each further wire
    """

    omega: Floats
    back: Complex
    on: Complex
    across: list[Complex]


def fine(coarse: float, finest: float) -> Floats:
    """Places of nodes: short elements at the obstacle.

    A force at a node kinks a string. Cubic elements cannot kink, as their slope is continuous: they
    yield too little, by a share of ℓ/T with ℓ their length there. So strings need 4 mm, where 50 mm
    do for a wire that resists bending.
    """
    watched = dict.fromkeys((SOURCE, BEFORE, BEHIND), coarse)
    return stations(0.0, END, coarse, {**watched, OBSTACLE: finest})


def even(element: float) -> Floats:
    """Places of nodes at equal distances."""
    return np.linspace(0.0, END, round(END / element) + 1)


def scatter(
    x: Floats,
    kinds: tuple[Wire, ...],
    waves: Sequence[Waves],
    fasten: Fasten,
    scheme: tuple[str, list[float]] = TRAPEZOIDAL,
    **options: object,
) -> Scattered:
    """Run with and without the obstacle; what differs was scattered.

    Parameters
    ----------
    x
        Places of nodes, m.
    kinds, waves
        The wires, and the waves on each of them.
    fasten
        Puts the obstacle there.
    scheme
        Name and numbers of the scheme. Explicit steps move waves at ω itself.
    options
        Of `Straight`.
    """
    free, met = (
        _run(Straight(x, *kinds, **options), obstacle, scheme)  # type: ignore[arg-type]
        for obstacle in (lambda _line: None, fasten)
    )
    omega = 2.0 * np.pi * FREQUENCIES
    shown = omega if scheme == EXPLICIT else balanced(omega, STEP)

    def amplitude(values: Floats, wave: Waves, distance: float) -> Complex:
        """At the obstacle, of a wave seen that far behind it on its way."""
        seen = spectrum(met.time, values, omega)
        return np.asarray(seen * np.exp(1j * wave.number(shown) * distance))

    first, away = waves[0], BEHIND - OBSTACLE
    came = amplitude(free.nodes[:, 0], first, BEFORE - OBSTACLE)
    back = amplitude(met.nodes[:, 0] - free.nodes[:, 0], first, away) / came
    on = amplitude(met.nodes[:, 1], first, away) / came
    across = [
        amplitude(met.nodes[:, 2 * which + side], waves[which], away) / came
        for which in range(1, len(kinds))
        for side in (0, 1)
    ]
    return Scattered(shown, back, on, across)


def _run(line: Straight, fasten: Fasten, scheme: tuple[str, list[float]]) -> Pressed:
    fasten(line)
    watched = [line.node(x, which) for which in range(len(line.kinds)) for x in (BEFORE, BEHIND)]
    run = send(line, watched, scheme)
    # Otherwise a spectrum of the record says nothing.
    assert np.abs(run.nodes[-1]).max() < 3e-6 * np.abs(run.nodes).max()
    return run


def send(
    line: Straight,
    watched: list[int],
    scheme: tuple[str, list[float]] = TRAPEZOIDAL,
    added: Floats | None = None,
    *,
    period_correction: bool = False,
) -> Pressed:
    """Send a pulse from `SOURCE`; uplift counts from the wire under the constant force."""
    if added is None:
        added = pulse(TIMES, middle=0.08, width=0.012, size=SIZE)
    stand = np.full(STEPS + 1, SOURCE)
    run = press(
        line.find(), PRESSED, stand, 0.0, STEP,
        added=added - added[0], nodes=watched, scheme=scheme, period_correction=period_correction,
    )  # fmt: skip
    run.nodes[:] -= run.nodes[0]
    return run
