"""Share of test runs with noise that are put in the right place, on a line of equal spans.

The force is that of a run at 320 km/h, 93 % of whose variance repeats from span to span. A test run
is a part of it, at a random place and with a random error of position within half a span, and has
white noise in the band of the filter. `python -m tests.support.alignment_rates` prints the table of
the guide.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

import arcless
from arcless.assess.signals.filter import low_pass
from arcless.comparison.alignment import Search, Trace, aligned, repeated
from arcless.results import Result

SCENARIO = "en50318-ac-simple-320-planar"
HALF_SPAN_M, CUTOFF_HZ, RATE_HZ = 27.5, 20.0, 200.0
LENGTHS_M, NOISES = (300.0, 900.0), (0.5, 1.0, 2.0, 4.0)
COUNT = 100
# Nearer than this is the right place: half of the shortest wave. The next maximum is further.
RIGHT_M = 2.0
WAYS = ("half a span", "everywhere", "supports")


@dataclass
class Rate:
    """Of `COUNT` test runs: right ones, those said to be not sure, wrong ones that were not."""

    right: int = 0
    not_sure: int = 0
    untold: int = 0


def rates(run: Result, length_m: float, noise: float) -> dict[str, Rate]:
    """Return the rates for each way to align.

    Parameters
    ----------
    run
        The run.
    length_m
        Length of a test run in m.
    noise
        Deviation of the noise in the band, as a part of that of the force.
    """
    data = run.latest
    x, speed = data["position"].values[:, 0], float(data["speed"].values[0])
    force = low_pass(data["contact_force"].values[:, 0], 1000.0, CUTOFF_HZ)
    begin, end = run.assessment.section_m
    sigma = force[(x >= begin) & (x <= end)].std()
    line = Trace(x, force, np.ones(x.size, bool), speed / CUTOFF_HZ)
    near, anywhere = Search(-HALF_SPAN_M, HALF_SPAN_M), Search()
    asked = {
        "half a span": (line, near), "everywhere": (line, anywhere),
        "supports": (repeated(line, data["support_x"].values), near),
    }  # fmt: skip
    found = {way: Rate() for way in WAYS}
    random = np.random.default_rng([round(length_m), round(10 * noise)])
    for _ in range(COUNT):
        start = random.uniform(60.0, 1040.0 - length_m)
        time = np.arange(start / speed, (start + length_m) / speed, 1.0 / RATE_HZ)
        error = low_pass(random.standard_normal(time.size + 400), RATE_HZ, CUTOFF_HZ)[200:-200]
        values = np.interp(speed * time, x, force) + noise * sigma / error.std() * error
        offset = random.uniform(-25.0, 25.0)
        shown = Trace(speed * time - offset, values, np.ones(time.size, bool), line.shortest_m)
        for way, (reference, search) in asked.items():
            by = aligned(reference, shown, search)
            right = abs(by.offset_m - offset) < RIGHT_M
            found[way].right += right
            found[way].not_sure += by.ambiguous
            found[way].untold += not right and not by.ambiguous
    return found


def rows(run: Result) -> Iterator[str]:
    """Yield the rows of the guide's table."""
    for length in LENGTHS_M:
        for noise in NOISES:
            found = rates(run, length, noise)
            cells = [f"{one.right} / {one.not_sure} / {one.untold}" for one in found.values()]
            yield f"| {length:.0f} m | {noise:g} σ | {' | '.join(cells)} |"


if __name__ == "__main__":
    print("\n".join(rows(arcless.run(arcless.load(SCENARIO)))))  # noqa: T201
