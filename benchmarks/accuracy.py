"""How far a discretisation is from one with a quarter of element length and time step.

All runs of a line have the same static force, that which gives the mean force asked for with cubic
elements. Finer cubic elements are the reference of explicit steps too.
"""

from collections.abc import Sequence
from typing import Any, NamedTuple

from arcless.model import Scenario, load
from arcless.results import Result
from arcless.simulate import run
from benchmarks.clock import timed
from benchmarks.whole_runs import SOLVED, SOLVED_IN_SPACE, Stepping

FINER = 4.0


class Line(NamedTuple):
    """A scenario with explicit steps, and what gives it a matrix.

    With the elements of contact and messenger wire in m that residual flexibility makes long
    enough.
    """

    name: str
    solved: dict[str, Any]
    flexible: tuple[float, float]


LINES = {
    "AC simple, planar": Line("en50318-ac-simple-320-planar", SOLVED, (0.96, 1.45)),
    "AC simple, three-dimensional": Line("en50318-ac-simple-320", SOLVED_IN_SPACE, (0.72, 1.45)),
}
HEAD = ("run", "elements m", "step ms", "× real time", "F_m", "σ", "max", "min", "uplift")
UNITS = ("N", "N", "N", "N", "mm")


def numbers(result: Result) -> list[float]:
    """F_m, σ, max, min in N, uplift in mm."""
    found = result.assessment
    first, uplift = found.pantographs[0], found.max_uplift_at_support_mm
    assert uplift is not None
    forces = [first.mean_force_N, first.std_force_N, first.max_force_N, first.min_force_N]
    return [*forces, uplift]


def with_force(scenario: Scenario) -> Scenario:
    """Give the static force that the scenario's own discretisation finds."""
    if scenario.pantographs[0].mean_force is None:
        return scenario
    force = run(scenario).metadata["static_force_found"][scenario.pantographs[0].name]
    return scenario.with_(**{"pantographs.0.static_force": force})


def finer(scenario: Scenario, elements: float = FINER, step: float = FINER) -> Scenario:
    """Divide element lengths and the time step."""
    solver = scenario.solver
    return scenario.with_(**{
        "solver.contact_wire_element": solver.contact_wire_element_m / elements,
        "solver.messenger_wire_element": solver.messenger_wire_element_m / elements,
        "solver.time_step": scenario.time_step_s / step,
    })  # fmt: skip


def flexible(scenario: Scenario, contact: float, messenger: float) -> Scenario:
    """Give elements, m, and add what they yield too little."""
    return scenario.with_(**{
        "solver.contact_wire_element": contact,
        "solver.messenger_wire_element": messenger,
        "solver.residual_flexibility": True,
    })  # fmt: skip


def rows() -> list[list[str]]:
    """Compare what is shipped, and some of it finer, with the finest."""
    return [row for title, line in LINES.items() for row in compared(title, line)]


def compared(title: str, line: Line) -> list[list[str]]:
    """Return rows for a line; the first one is the reference."""
    solved = with_force(load(line.name).with_(**line.solved))
    force = {"pantographs.0.static_force": solved.pantographs[0].static_force}
    finest = finer(solved)
    exact = numbers(run(finest))
    values = [f"{value:.1f} {unit}" for value, unit in zip(exact, UNITS, strict=True)]
    found = [_head(f"{title}, reference", finest) + values]
    for name, scenario in (
        ("cubic elements", solved),
        ("elements halved", finer(solved, 2.0, 1.0)),
        ("both halved", finer(solved, 2.0, 2.0)),
        ("with residual flexibility", flexible(solved, *line.flexible)),
        ("explicit steps, default", load(line.name).with_(**force)),
    ):
        found.append(_head(name, scenario) + apart(numbers(run(scenario)), exact))
    return found


def apart(values: Sequence[float], exact: Sequence[float]) -> list[str]:
    """Difference in per cent, and in N or mm."""
    pairs = zip(values, exact, UNITS, strict=True)
    return [f"{100.0 * (v / e - 1.0):+.2f} % ({v - e:+.1f} {unit})" for v, e, unit in pairs]


def _head(title: str, scenario: Scenario) -> list[str]:
    solver, one = scenario.stepping, Stepping.of(scenario)
    return [
        title,
        f"{solver.contact_wire_element_m:.3g}, {solver.messenger_wire_element_m:.3g}",
        f"{1e3 * scenario.time_step_s:g}",
        f"{one.job.travel.duration / timed(one.run, 3).processor:.2g}",
    ]
