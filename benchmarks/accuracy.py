"""How far a discretisation is from one with a quarter of element length and time step.

Both runs have the same static force, that which gives the mean force asked for with the
discretisation of the scenario.
"""

from collections.abc import Sequence
from typing import Any

from arcless.model import Scenario, load
from arcless.results import Result
from arcless.simulate import run

CASES: Sequence[tuple[str, str, dict[str, Any]]] = (
    ("AC simple, planar, as shipped", "en50318-ac-simple-320", {}),
    (
        "the same, half the elements", "en50318-ac-simple-320",
        {"solver.contact_wire_element": 0.725, "solver.messenger_wire_element": 1.45},
    ),
    ("the same in three dimensions, as shipped", "ac-simple-3d-320", {}),
)  # fmt: skip
HEAD = ("run", "elements m", "step ms", "F_m", "σ", "max", "min", "uplift")
FINER = 4
FINEST = (
    "en50318-ac-simple-320", "ac-simple-3d-320",
)  # fmt: skip


def numbers(result: Result) -> list[float]:
    """F_m, σ, max, min in N, uplift in mm."""
    found = result.assessment
    first, uplift = found.pantographs[0], found.max_uplift_at_support_mm
    assert uplift is not None
    return [
        first.mean_force_N, first.std_force_N, first.max_force_N, first.min_force_N, uplift
    ]  # fmt: skip


def with_force(scenario: Scenario) -> Scenario:
    """Give the static force that the scenario's own discretisation finds."""
    if scenario.pantographs[0].mean_force is None:
        return scenario
    force = run(scenario).metadata["static_force_found"][scenario.pantographs[0].name]
    return scenario.with_(**{"pantographs.0.static_force": force})


def finer(scenario: Scenario, factor: int = FINER) -> Scenario:
    """Divide element lengths and the time step."""
    solver = scenario.solver
    return scenario.with_(**{
        "solver.contact_wire_element": solver.contact_wire_element / factor,
        "solver.messenger_wire_element": solver.messenger_wire_element / factor,
        "solver.time_step": scenario.time_step_s / factor,
    })  # fmt: skip


def rows() -> list[list[str]]:
    """Compare every case with the finer run of the shipped scenario."""
    found, forced, finest = [], {}, {}
    for name in dict.fromkeys(name for _, name, _ in CASES):
        forced[name] = with_force(load(name))
        finest[name] = numbers(run(finer(forced[name])))
        found.append(_row(f"{name}: reference", finer(forced[name]), finest[name], None))
    for title, name, changes in CASES:
        scenario = forced[name].with_(**changes)
        found.append(_row(title, scenario, numbers(run(scenario)), finest[name]))
    return found


def _row(
    title: str, scenario: Scenario, values: Sequence[float], least: Sequence[float] | None
) -> list[str]:
    solver = scenario.solver
    head = [
        title,
        f"{solver.contact_wire_element:g}, {solver.messenger_wire_element:g}",
        f"{1e3 * scenario.time_step_s:g}",
    ]
    if least is None:
        units = ["N"] * 4 + ["mm"]
        return head + [f"{value:.1f} {unit}" for value, unit in zip(values, units, strict=True)]
    return head + [
        f"{100.0 * (value / exact - 1.0):+.2f} %"
        for value, exact in zip(values, least, strict=True)
    ]
