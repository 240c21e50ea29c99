"""Whole runs: real-time factor of the stepping loop, median of five, and the counts behind it.

    make bench          (after the kernels of the core)

Wall times wobble with the machine; compare lines of one output only. Counts repeat exactly.
"""

import statistics
import time

from arcless.model import load
from arcless.simulate import equilibrium, motion, riders
from arcless.simulate.control import Controllers
from arcless.simulate.job import Job, prepare

REPEATS = 5
CASES = (
    ("AC simple, 20 spans, planar", "en50318-ac-simple-320", "never"),
    ("the same with energy ledger", "en50318-ac-simple-320", "always"),
    ("the same in three dimensions", "ac-simple-3d-320", "never"),
    ("two pantographs, planar", "ac-simple-320-two-pantographs", "never"),
    ("EN 50318:2002, 10 spans", "en50318-2002-300", "never"),
    ("PRAKS, 30 spans, 180 km/h, published method", "praks-180", "never"),
    ("PRAKS, 30 spans, 360 km/h, published method", "praks-360", "never"),
)
HEAD = ("run", "× real time", "µs/step", "nodes", "factor blocks", "pivots/step", "set-up ms")


def main() -> None:
    print(" | ".join(HEAD))
    print(" | ".join("---" for _ in HEAD))
    for title, name, energy in CASES:
        print(" | ".join([title, *measure(name, energy)]), flush=True)


def measure(name: str, energy: str) -> list[str]:
    """Step one scenario several times; the static force is the given or the mean force."""
    scenario = load(name).with_(**{"output.energy": energy})
    began = time.perf_counter()
    found = equilibrium.find(scenario)
    prepared = prepare(found, scenario)
    setup = time.perf_counter() - began
    travel = motion.motion(scenario)
    given = riders.given_motions(scenario, travel)
    nobody = Controllers(scenario)
    job = Job(scenario, found, prepared, travel, given, [], nobody, lambda _step: True)
    forces = [placement.start_force or 0.0 for placement in scenario.pantographs]
    times, raw = [], {}
    for _ in range(REPEATS):
        began = time.perf_counter()
        raw = job.step(forces, full=True)
        times.append(time.perf_counter() - began)
    median = statistics.median(times)
    nodes, blocks, _ = prepared.cost()
    return [
        f"{travel.duration / median:.1f}",
        f"{1e6 * median / travel.steps:.1f}",
        str(nodes),
        str(blocks),
        f"{raw['pivots'] / travel.steps:.2f}",
        f"{1e3 * setup:.0f}",
    ]


if __name__ == "__main__":
    main()
