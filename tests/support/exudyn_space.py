"""AC simple in space in both programs: at rest, and under one and two pantographs.

Every version of a run is recorded at places of the first pantograph, 0.1 m apart, filtered at
20 Hz at its own rate.
"""

from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

import arcless
from arcless.assess.signals.filter import low_pass
from arcless.equilibrium import equilibrium
from tests.support.exudyn_built import Built
from tests.support.exudyn_line import Coordinates, Line
from tests.support.exudyn_run import Run

SCENARIO = "en50318-ac-simple-275"
CUBIC = {"solver.scheme": "generalised-alpha"}
# What the other program has not: waves as late as the scheme makes them, wires as stiff at a
# clamp as their elements are.
BARE = {**CUBIC, "solver.residual_flexibility": False, "solver.period_correction": False}
FAMILIES: dict[str, dict[str, Any]] = {"chains": {}, "cubic elements": CUBIC}
FORCE = 140.0  # at the start: some 139 N in the mean of the run
SPACING = 100.0
START, END = 137.5, 302.5
# Two spans of the first pantograph, one span after the start and 5 m before the end.
FIRST, LAST = 187.5, 297.5
# 20 Hz are 3.8 m.
GRID = np.arange(FIRST, LAST, 0.1)


def of_elements(contact: float, messenger: float) -> dict[str, Any]:
    """Return the changes that ask for elements of these lengths, m."""
    return {"solver.contact_wire_element": contact, "solver.messenger_wire_element": messenger}


def line_of(spans: int, **changes: Any) -> arcless.Scenario:
    """Load the line with so many spans."""
    fewer = {"line.spans": [{"type": "standard", "count": spans}], "analysis.spans": None}
    return arcless.load(SCENARIO).with_(**fewer, **changes)


def settled(
    design: arcless.Scenario, division: arcless.Scenario | None = None
) -> tuple[equilibrium.Equilibrium, Line, Coordinates]:
    """Let the line of a design hang in Exudyn, on the elements of another scenario if given."""
    found = equilibrium.find(design)
    other = None if division is None else equilibrium.find(division)
    line = Line(design, Built.of(design, found, other))
    return found, line, line.settle()


@dataclass(frozen=True)
class Passage:
    """A run on the grid: filtered forces, N (columns are pantographs), uplift of supports, m."""

    force: Any
    uplift: Any

    @classmethod
    def of(cls, time: Any, force: Any, uplift: Any, speed: float) -> "Passage":
        """Filter and interpolate what was recorded at equal steps."""
        slow = low_pass(force, 1.0 / float(time[1] - time[0]), 20.0)
        x = START + speed * time
        columns = [np.interp(GRID, x, column) for column in slow.T]
        return cls(np.column_stack(columns), uplift)


def extrapolated(coarse: Passage, fine: Passage) -> Passage:
    """Continue two runs, the second at half of length and step, by an error of second order."""
    return Passage(
        fine.force + (fine.force - coarse.force) / 3.0,
        fine.uplift + (fine.uplift - coarse.uplift) / 3.0,
    )


def statistics(force: Any) -> dict[str, float]:
    """Return what is assessed, N."""
    return {
        "mean force": float(force.mean()), "standard deviation": float(force.std()),
        "maximum": float(force.max()), "minimum": float(force.min()),
    }  # fmt: skip


def moving(pantographs: int, **changes: Any) -> arcless.Scenario:
    """Return the run: six spans, the first pantograph from 137.5 to 302.5 m."""
    placed = [
        {"model": "ac-simple", "static_force": FORCE, "distance": SPACING * number}
        for number in range(pantographs)
    ]
    given = {"pantographs": placed, "travel": {"start": START, "end": END}}
    return line_of(6, **given, **changes)


def of_arcless(pantographs: int, **changes: Any) -> Passage:
    """Run in Arcless."""
    scenario = moving(pantographs, **changes)
    data = arcless.run(scenario).dataset
    uplift = data.support_uplift_max.values
    return Passage.of(data.time.values, data.contact_force.values, uplift, scenario.speed)


@cache
def of_exudyn(pantographs: int, contact: float, messenger: float, step: float) -> Passage:
    """Run in Exudyn, the line built as chains, the default of Arcless, design it."""
    elements = of_elements(contact, messenger)
    scenario = moving(pantographs, **BARE, **elements, **{"solver.time_step": step})
    design, division = moving(pantographs), equilibrium.find(scenario)
    built = Built.of(design, equilibrium.find(design), division)
    steps = int((END - START) / scenario.speed / step)
    record = Run(scenario, built, steps, step).record()
    time = step * np.arange(steps + 1)
    return Passage.of(time, record.force, record.uplift.max(axis=0), scenario.speed)
