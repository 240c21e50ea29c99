"""Runs in other units: what goes to the core times powers of units of length, mass and time."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from arcless.equilibrium import equilibrium
from arcless.simulate.runs.job import Job
from arcless.simulate.setup import pantographs, trajectory

# Powers of (length, mass, time).
Powers = tuple[int, int, int]
NUMBER, LENGTH, MASS, TIME = (0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)
SPEED, FORCE, ENERGY = (1, 0, -1), (1, 1, -2), (2, 1, -2)
STIFFNESS, DAMPING, BENDING = (0, 1, -2), (0, 1, -1), (3, 1, -2)
LINE_MASS, RATE, ACCELERATION = (-1, 1, 0), (0, 0, -1), (1, 0, -2)

# Columns of the tables in `arcless.mesh.tables.mesh_types.Mesh`.
COLUMNS: dict[str, tuple[Powers, ...]] = {
    "wires": (LENGTH, FORCE, BENDING, LINE_MASS, RATE, TIME, FORCE),
    "segments": (LENGTH, FORCE, LINE_MASS, RATE, TIME, FORCE),
    "bends": (BENDING, TIME),
    "links": (LENGTH, STIFFNESS, DAMPING, RATE, TIME, LINE_MASS),
    "struts": (*3 * (NUMBER,), *3 * (LENGTH,), LENGTH, STIFFNESS, MASS, MASS),
    "springs": (STIFFNESS, DAMPING, LENGTH),
    "masses": (MASS, RATE),
    "fixed": (),
    "ends": (FORCE,),
    "loads": (FORCE,),
    "wire_loads": 3 * (STIFFNESS,),
}
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
    parts = {
        kind: (integers, floats * [of(powers) for powers in COLUMNS[kind]])
        for kind, (integers, floats) in mesh.parts.items()
        if floats.size or integers.size
    }
    core = equilibrium._core.Equilibrium(
        mesh.dimension, mesh.positions * of(LENGTH), mesh.slopes,
        mesh.parts | parts,
        mesh.gravity * of(ACCELERATION), design=True,
    )  # fmt: skip
    prepared = core.prepare(
        mesh.lanes, trajectory.scheme_numbers(scenario.stepping.scheme),
        scenario.time_step_s * of(TIME), scenario.contact.stiffness * of(STIFFNESS), False,
    )  # fmt: skip
    raw = prepared.run(
        [_rider(job, force, units)], [0.0], (job.travel.positions * of(LENGTH)).tolist(),
        (job.travel.speeds * of(SPEED)).tolist(), scenario.contact.friction_coefficient, [],
        job._plan(full=True) | {"ledger": True}, lambda _step: True,
    )  # fmt: skip
    found = {name: raw[name] / of(powers) for name, powers in RECORDED.items()}
    energies = {f"energy {k}": values / of(ENERGY) for k, values in raw["energy"].items()}
    return found | energies


def _rider(job: Job, force: float, units: Units) -> tuple[Any, ...]:
    made = pantographs.rider(job.scenario.pantographs[0].model, force)
    assert made[3][0][1:] == (np.inf, [0.0], made[3][0][3]), "a plain strip"
    mass, damping, stiffness, strips, preload, lift, start, *rest = made

    def times(values: list[float], powers: Powers) -> list[float]:
        return [value * units.of(powers) for value in values]

    return (
        times(mass, MASS), times(damping, DAMPING), times(stiffness, STIFFNESS), strips, preload,
        times(lift, LINE_MASS), start * units.of(FORCE), *rest,
    )  # fmt: skip
