"""Every shipped line that steps explicitly: time of a point in a step, beside AC simple in space.

Lines are compared in turn with the first, so that a slow moment of the machine hits both.
"""

from arcless.model import load
from arcless.model.settings.schemes import EXPLICIT
from arcless.model.shipped.library import shipped
from benchmarks.clock import interleaved
from benchmarks.whole_runs import Stepping

REFERENCE = "en50318-ac-simple-320"
HEAD = ("scenario", "points", "directions", "steps", "µs/step", "ns/point and step",
        "× AC simple in space")  # fmt: skip
# Turns in which a line and the reference are timed.
REPEATS = 3


def names() -> list[str]:
    """Return the shipped scenarios that step explicitly, AC simple in space first."""
    found = [
        name
        for name in shipped("scenario")
        if name != REFERENCE and load(name).stepping.scheme.name == EXPLICIT
    ]
    return [REFERENCE, *found]


def rows(chosen: list[str] | None = None) -> list[list[str]]:
    """Step each line in turn with the reference."""
    first = Stepping.of(load(REFERENCE))
    return [_row(name, first) for name in chosen or names()]


def _row(name: str, first: Stepping) -> list[str]:
    own = Stepping.of(load(name))
    taken = interleaved([first.run, own.run], REPEATS)
    each = [
        time.processor / one.job.travel.steps / _points(one)
        for one, time in zip((first, own), taken, strict=True)
    ]
    steps = own.job.travel.steps
    return [
        name,
        str(_points(own)),
        str(own.job.found.mesh.dimension),
        str(steps),
        f"{1e6 * taken[1].processor / steps:.1f}",
        f"{1e9 * each[1]:.2f}",
        f"{each[1] / each[0]:.2f}",
    ]


def _points(one: Stepping) -> int:
    return len(one.job.found.mesh.positions)
