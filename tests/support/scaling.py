"""Runs in other units: what goes to the core times powers of units of length, mass and time."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from arcless.equilibrium import equilibrium
from arcless.simulate.runs.job import Job
from arcless.simulate.setup import pantographs, trajectory
from arcless.simulate.setup.core_data import PantographData

# Powers of (length, mass, time).
Powers = tuple[int, int, int]
NUMBER, LENGTH, MASS, TIME = (0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)
SPEED, FORCE, ENERGY = (1, 0, -1), (1, 1, -2), (2, 1, -2)
STIFFNESS, DAMPING, BENDING = (0, 1, -2), (0, 1, -1), (3, 1, -2)
LINE_MASS, RATE, ACCELERATION = (-1, 1, 0), (0, 0, -1), (1, 0, -2)

# Float columns of the tables in `arcless.mesh.tables.columns`.
WIRE: dict[str, Powers] = {
    "rest_length": LENGTH, "axial_stiffness": FORCE, "mass": LINE_MASS, "alpha": RATE,
    "beta": TIME, "design_tension": FORCE,
}  # fmt: skip
COLUMNS: dict[str, dict[str, Powers]] = {
    "wires": WIRE | {"bending_stiffness": BENDING},
    "segments": WIRE,
    "bends": {"bending_stiffness": BENDING, "beta": TIME},
    "links": {
        "rest_length": LENGTH, "stiffness": STIFFNESS, "viscosity": DAMPING, "alpha": RATE,
        "beta": TIME, "mass": LINE_MASS,
    },
    "struts": {
        "direction": NUMBER, "anchor": LENGTH, "rest_length": LENGTH, "stiffness": STIFFNESS,
        "moving_mass": MASS, "hanging_mass": MASS,
    },
    "springs": {"stiffness": STIFFNESS, "viscosity": DAMPING, "rest": LENGTH},
    "masses": {"mass": MASS, "alpha": RATE},
    "ends": {"force": FORCE},
    "loads": {"force": FORCE},
    "wire_loads": {"force": STIFFNESS},
}  # fmt: skip
# What comes back.
RECORDED: dict[str, Powers] = {
    "time": TIME, "force": FORCE, "gap": LENGTH, "height": LENGTH, "lateral": LENGTH,
    "masses": LENGTH, "link_force": FORCE, "uplift": LENGTH, "slack": NUMBER,
}  # fmt: skip


@dataclass(frozen=True)
class Units:
    """One metre, kilogram and second are so many of the units: powers of two keep every bit."""

    length: float
    mass: float
    time: float

    def of(self, powers: Powers) -> float:
        """Return the factor of a quantity."""
        a, b, c = powers
        return self.length**a * self.mass**b * self.time**c


def run(job: Job, force: float, units: Units) -> dict[str, Any]:
    """Run a laid-out job with one chain of masses in other units; returns SI again."""
    of, mesh, scenario = units.of, job.found.mesh, job.scenario
    parts = {kind: table.copy() for kind, table in mesh.parts.items()}
    for kind, columns in COLUMNS.items():
        for name, powers in columns.items():
            parts[kind][name] *= of(powers)
    core = equilibrium._core.Equilibrium(
        dimension=mesh.dimension, positions=mesh.positions * of(LENGTH), slopes=mesh.slopes,
        parts=parts, gravity=mesh.gravity * of(ACCELERATION), design=True,
    )  # fmt: skip
    prepared = core.prepare(
        lanes=mesh.lanes, scheme=trajectory.scheme_numbers(scenario.stepping.scheme),
        step=scenario.time_step_s * of(TIME),
        contact_stiffness=scenario.contact.stiffness * of(STIFFNESS), updated=False,
    )  # fmt: skip
    raw = prepared.run(
        pantographs=[_pantograph(job, force, units)], distances=[0.0],
        positions=job.travel.positions * of(LENGTH), speeds=job.travel.speeds * of(SPEED),
        friction=scenario.contact.friction_coefficient, loads=[],
        plan=job._plan(full=True)._replace(ledger=True), observe=lambda _step: True,
    )  # fmt: skip
    found = {name: raw[name] / of(powers) for name, powers in RECORDED.items()}
    energies = {f"energy {k}": values / of(ENERGY) for k, values in raw["energy"].items()}
    return found | energies


def _pantograph(job: Job, force: float, units: Units) -> PantographData:
    made = pantographs.data(job.scenario.pantographs[0].model, force)
    (strip,) = made.strips
    assert (strip.half_width, strip.knots) == (np.inf, [0.0]), "a plain strip"

    def times(values: Sequence[float], powers: Powers) -> list[float]:
        return [value * units.of(powers) for value in values]

    return made._replace(
        mass=times(made.mass, MASS),
        damping=times(made.damping, DAMPING),
        stiffness=times(made.stiffness, STIFFNESS),
        lift=times(made.lift, LINE_MASS),
        start_force=made.start_force * units.of(FORCE),
    )
