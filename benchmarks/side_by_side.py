"""Other programs on the same models, in one run: seconds simulated in a second, and the forces.

Exudyn: the line and the pantograph of tests/support, which docs/validation/other-programs.md
describes. Plain SciPy: `plain_scipy`. Only the steps are timed, not what comes before.
"""

import importlib.util
from collections.abc import Callable, Sequence
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
    from tests.support.exudyn_run import Run

    class Timed(Run):
        def _step(self) -> Any:
            steps: list[Any] = []
            step = super()._step
            self.taken = timed(lambda: steps.append(step()), 1).processor
            return steps[0]

    travel = one.job.travel
    run = Timed(scenario, one.job.found, travel.steps, travel.time_step)
    ends = run.record().force
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
    """Compare on two models; Exudyn only where it is installed."""
    return _ac_simple(progress) + _reference(progress)


def _short(name: str, start: float, end: float, changes: dict[str, Any]) -> Scenario:
    # The others have no correction of the period: the same equations are compared.
    short = {
        "travel": {"start": start, "end": end}, "analysis.spans": None,
        "solver.period_correction": False,
    }  # fmt: skip
    return load(name).with_(**{**short, **changes})


def _ac_simple(progress: Callable[[str], None]) -> list[list[str]]:
    given = {"pantographs.0.static_force": 172.0}
    shipped = _short("en50318-ac-simple-320-planar", 55.0, 233.0, given)  # 2 s
    scenario = shipped.with_(**SOLVED)
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
    scenario = _short("en50318-2002-250", 60.0, 130.0, ELEMENTS)  # 1 s
    progress("EN 50318:2002 in Arcless and in SciPy")
    own, one = of_arcless(scenario)
    rows = [
        row("EN 50318:2002, 10 spans, 1 s", "Arcless", one, own, own),
        row("", "plain SciPy", one, of_scipy(scenario, one), own),
    ]
    if importlib.util.find_spec("exudyn") is None:
        progress("Exudyn is not installed (`make peers`): left out")
        return rows
    progress("EN 50318:2002 in Exudyn")
    moved, _ = of_arcless(scenario.with_(**{"solver.kinematics": "updated"}), 3)
    rows.append(row("", "Arcless, updated kinematics", one, moved, own))
    rows.append(row("", "Exudyn (updates too)", one, of_exudyn(scenario, one), moved))
    return _beside_default(rows, own[0], one)


def _beside_default(rows: Sequence[list[str]], least: float, one: Stepping) -> list[list[str]]:
    """Say for Exudyn how much faster the default of Arcless is, not the updated run."""
    *others, last = rows
    last[5] = f"{float(last[3]) * 1e-6 * one.job.travel.steps / least:.3g}"
    return [*others, last]
