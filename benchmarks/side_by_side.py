"""Other programs on the same models, in one run: seconds simulated in a second, and the forces.

Exudyn: the line and the pantograph of tests/support, which docs/validation/other-programs.md
describes. Plain SciPy: `plain_scipy`. Only the steps are timed, not what comes before.
"""

import importlib.util
from collections.abc import Callable
from typing import Any

import numpy as np

from arcless.model import Scenario, load
from benchmarks.clock import timed
from benchmarks.plain_scipy import Plain
from benchmarks.whole_runs import SOLVED, Stepping

HEAD = (
    "model", "program", "unknowns", "µs/step", "× real time", "Arcless is faster by",
    "force differs, root mean square",
)  # fmt: skip
ELEMENTS = {"solver.contact_wire_element": 1.5, "solver.messenger_wire_element": 3.0}
# The others have neither a correction of the period nor residual flexibility.
SAME = {**SOLVED, "solver.period_correction": False}
Found = tuple[float, Any]  # processor time in s, contact force in N


def of_arcless(scenario: Scenario, repeats: int = 5) -> tuple[Found, Stepping]:
    """Time the steps."""
    one = Stepping.of(scenario)
    force = one.run()["force"]
    return (timed(one.run, repeats).processor, force), one


def of_scipy(scenario: Scenario, one: Stepping, repeats: int = 3) -> Found:
    """The same by `plain_scipy`."""
    plain, steps = Plain(scenario, one.job.found), one.job.travel.steps
    force = plain.run(one.forces[0], steps).force
    return timed(lambda: plain.run(one.forces[0], steps), repeats).processor, force


def of_exudyn(scenario: Scenario, one: Stepping) -> Found:
    """The same by Exudyn, once: it takes longest."""
    from tests.support.exudyn_built import Built
    from tests.support.exudyn_run import Run

    class Timed(Run):
        def _step(self) -> Any:
            steps: list[Any] = []
            step = super()._step
            self.taken = timed(lambda: steps.append(step()), 1).processor
            return steps[0]

    travel = one.job.travel
    built = Built.of(scenario, one.job.found)
    run = Timed(scenario, built, travel.steps, travel.time_step)
    ends = run.record().force[:, 0]
    # Exudyn records at the ends of steps, Arcless at the times of balance.
    ends_at = np.arange(travel.steps + 1)
    balance = ends_at[1:] - one.job.scenario.stepping.scheme.spectral_radius / (
        1.0 + one.job.scenario.stepping.scheme.spectral_radius
    )
    return run.taken, np.interp(balance, ends_at, ends)


def row(title: str, program: str, one: Stepping, found: Found, fastest: Found) -> list[str]:
    """Speed of a program beside Arcless's, and the difference of the forces."""
    travel = one.job.travel
    (taken, force), (least, own) = found, fastest
    apart = float(np.sqrt(np.mean((np.asarray(force) - np.asarray(own)) ** 2)))
    return [
        title, program, str(one.floor().unknowns), f"{1e6 * taken / travel.steps:.1f}",
        f"{travel.duration / taken:.3g}", f"{taken / least:.3g}",
        "" if force is own else f"{apart:.1g} N of {np.std(own):.0f} N",
    ]  # fmt: skip


def rows(progress: Callable[[str], None] = lambda _text: None) -> list[list[str]]:
    """Compare on three models; Exudyn only where it is installed."""
    return _ac_simple(progress) + _reference(progress) + _in_space(progress)


def _short(name: str, start: float, end: float, changes: dict[str, Any]) -> Scenario:
    short = {"travel": {"start": start, "end": end}, "analysis.spans": None}
    return load(name).with_(**{**short, **changes})


def _ac_simple(progress: Callable[[str], None]) -> list[list[str]]:
    given = {"pantographs.0.static_force": 172.0}
    shipped = _short("en50318-ac-simple-320-planar", 55.0, 233.0, given)  # 2 s
    scenario = shipped.with_(**SAME)
    progress("AC simple in Arcless and in SciPy")
    own, one = of_arcless(scenario)
    explicit, chains = of_arcless(shipped)
    title = "AC simple, 20 spans, planar, 2 s"
    plain = of_scipy(scenario, one)
    return [
        row(title, "Arcless, with a matrix", one, own, own),
        # Other elements, so other forces: the guide on explicit steps compares them.
        row("", "Arcless, explicit steps, default", chains, explicit, (own[0], explicit[1])),
        row("", "plain SciPy", one, plain, own),
    ]


def _reference(progress: Callable[[str], None]) -> list[list[str]]:
    scenario = _short("en50318-2002-250", 60.0, 130.0, {**SAME, **ELEMENTS})  # 1 s
    progress("EN 50318:2002 in Arcless and in SciPy")
    own, one = of_arcless(scenario)
    rows = [
        row("EN 50318:2002, 10 spans, 1 s", "Arcless", one, own, own),
        row("", "plain SciPy", one, of_scipy(scenario, one), own),
    ]
    return rows + _beside_exudyn("EN 50318:2002", scenario, one, own, progress)


def _in_space(progress: Callable[[str], None]) -> list[list[str]]:
    given = {
        "pantographs.0.static_force": 140.0,
        "line.spans": [{"type": "standard", "count": 10}],
    }
    shipped = _short("en50318-ac-simple-275", 110.0, 187.0, given)  # 1 s
    scenario = shipped.with_(**{**SAME, **ELEMENTS})
    progress("AC simple in space in Arcless")
    own, one = of_arcless(scenario)
    explicit, chains = of_arcless(shipped)
    rows = [
        row("AC simple in space, 10 spans, 1 s", "Arcless, with a matrix", one, own, own),
        # Other elements, so other forces.
        row("", "Arcless, explicit steps, default", chains, explicit, (own[0], explicit[1])),
    ]
    return rows + _beside_exudyn("AC simple in space", scenario, one, own, progress)


def _beside_exudyn(
    title: str, scenario: Scenario, one: Stepping, own: Found, progress: Callable[[str], None]
) -> list[list[str]]:
    """Rows of the updated run and of Exudyn, whose forces are compared.

    How much faster Arcless is, is said of the linearised run for both.
    """
    if importlib.util.find_spec("exudyn") is None:
        progress("Exudyn is not installed (`make peers`): left out")
        return []
    progress(f"{title} in Exudyn")
    moved, _ = of_arcless(scenario.with_(**{"solver.kinematics": "updated"}), 3)
    last = row("", "Exudyn (updates too)", one, of_exudyn(scenario, one), moved)
    last[5] = f"{float(last[3]) * 1e-6 * one.job.travel.steps / own[0]:.3g}"
    return [row("", "Arcless, updated kinematics", one, moved, own), last]
