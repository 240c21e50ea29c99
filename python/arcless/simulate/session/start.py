"""Scenario → a loop of the core, standing at its start."""

import hashlib
import json
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from arcless import _core
from arcless.equilibrium import equilibrium
from arcless.errors import ModelError
from arcless.mesh import Mesh
from arcless.model import Scenario
from arcless.model.pantograph.placement import PantographPlacement
from arcless.simulate.recording import contacts
from arcless.simulate.runs.failures import stepping, translated
from arcless.simulate.runs.job import prepare
from arcless.simulate.setup import pantographs, trajectory
from arcless.simulate.setup.controllers import acts_on
from arcless.simulate.setup.core_data import (
    ActuatorData,
    CollectorData,
    PantographData,
    SessionStart,
)


@dataclass(frozen=True)
class Start:
    """A loop of the core that stands at its start.

    Attributes
    ----------
    core, mesh, simulated
        The loop, names of its parts, its kind.
    inputs
        Names of the parts that take a force.
    pantographs
        Their names.
    first
        Number of the first contact of each pantograph.
    line
        Fingerprint of the line at rest.
    """

    core: _core.Session
    mesh: Mesh
    simulated: bool
    inputs: list[str]
    pantographs: list[str]
    first: NDArray[np.int64]
    line: bytes


def start(scenario: Scenario, *, simulated: bool) -> Start:
    """Find the line at rest under the forces of the start, and factorise it.

    Raises
    ------
    ModelError, MeshError, EquilibriumError, ContactError
        See `realtime`.
    """
    check(scenario, simulated=simulated)
    found = equilibrium.find(scenario)
    model = prepare(found, scenario)
    travel = trajectory.motion(scenario)
    position, speed = float(travel.positions[0]), float(travel.speeds[0])
    begin = SessionStart(position, speed, friction=scenario.contact.friction_coefficient)
    placements = scenario.pantographs
    names = [placement.name for placement in placements]
    if simulated:
        pantograph_data = [pantograph_at(placement, speed) for placement in placements]
        distances = [placement.distance for placement in placements]
        with stepping(found.mesh, placements):
            core = _core.Session.with_pantographs(
                line=model, pantographs=pantograph_data, distances=distances, start=begin
            )
        inputs = names
        owners = [pantograph for pantograph, _, _ in core.contacts()]
    else:
        core, inputs, owners = _with_given_forces(model, found.mesh, placements, begin)
    first = np.searchsorted(owners, np.arange(len(placements)))
    digest = hashlib.sha256()
    for name in sorted(found.arrays):
        digest.update(np.ascontiguousarray(found.arrays[name]).tobytes())
    return Start(core, found.mesh, simulated, inputs, names, first, digest.digest())


def fingerprint(scenario: Scenario, begun: Start) -> str:
    """Return the fingerprint of scenario and line that a state of the loop belongs to."""
    text = json.dumps(scenario.to_dict(), sort_keys=True, ensure_ascii=False)
    kind = f"{_core.__version__} {begun.simulated} "
    return hashlib.sha256((kind + text).encode() + begun.line).hexdigest()


def names_of(begun: Start) -> tuple[str, ...]:
    """Return the names of the contacts."""
    if not begun.simulated:
        return tuple(begun.inputs)
    raw = {"contacts": begun.core.contacts()}
    return tuple(contacts.labels(raw, begun.pantographs) or begun.pantographs)


def pantograph_at(placement: PantographPlacement, speed: float) -> PantographData:
    """Return a pantograph whose steps each take a force, at a speed in m/s at the start."""
    pantograph = placement.model
    force = (placement.start_force or 0.0) + pantograph.lift_at(speed)
    mass = placement.controller.mass if placement.controller else None
    # Every step brings its force; no controller is asked for one.
    actuator = ActuatorData(acts_on(placement, mass), every=1, delay=0)
    return pantographs.data(pantograph, force, actuator=actuator)


@dataclass(frozen=True)
class GivenForces:
    """Collectors that press with given forces, in the order of the pantographs.

    Attributes
    ----------
    collectors, forces
        Where they are, and the force of each at the start in N.
    names, owners
        Name of each, and number of its pantograph.
    """

    collectors: list[CollectorData]
    forces: list[float]
    names: list[str]
    owners: list[int]


def given_forces(
    mesh: Mesh, placements: tuple[PantographPlacement, ...], speed: float
) -> GivenForces:
    """Return the collectors of pantographs at a speed in m/s, the strips of each alike.

    Raises
    ------
    ModelError
        The line has several contact wires.
    """
    if len(mesh.lanes) > 1:
        what = "how several contact wires share a contact force that is given is not known"
        raise _refusal(what, "line", hint="realtime(scenario, simulated=True)")
    given = GivenForces([], [], [], [])
    for owner, placement in enumerate(placements):
        strips = pantographs.data(placement.model, 0.0).strips
        force = (placement.start_force or 0.0) + placement.model.lift_at(speed)
        for number, strip in enumerate(strips, start=1):
            behind = placement.distance + strip.offset
            given.collectors.append(CollectorData(behind, strip.half_width))
            given.forces.append(force / len(strips))
            given.owners.append(owner)
            several = len(strips) > 1
            given.names.append(f"{placement.name} strip {number}" if several else placement.name)
    return given


def _with_given_forces(
    model: _core.WireModel,
    mesh: Mesh,
    placements: tuple[PantographPlacement, ...],
    begin: SessionStart,
) -> tuple[_core.Session, list[str], list[int]]:
    """Return the loop, and name and pantograph of each collector."""
    given = given_forces(mesh, placements, begin.speed)
    try:
        core = _core.Session.with_forces(
            line=model, collectors=given.collectors, forces=given.forces, start=begin
        )
    except _core.NativeError as error:
        raise translated(mesh, given.names, *error.args) from error
    return core, given.names, given.owners


def check(scenario: Scenario, *, simulated: bool) -> None:
    """Refuse what a loop cannot do.

    Raises
    ------
    ModelError
        See `realtime`.
    """
    if scenario.solver.kinematics == "updated":
        raise _refusal(
            "updated kinematics factorise in every step",
            "solver.kinematics",
            hint="set solver.kinematics to linearised",
        )
    if scenario.as_built.gusts is not None:
        raise _refusal(
            "gusts are given for a whole run",
            "as_built.gusts",
            hint="leave them out; as_built.wind is steady and can stay",
        )
    for index, placement in enumerate(scenario.pantographs if simulated else ()):
        field, model = f"pantographs.{index}", placement.model
        if model.fmu is not None:
            raise _refusal(
                "an FMU runs in a process of its own",
                f"{field}.model.fmu",
                hint="run the scenario; or step the FMU yourself, with realtime(scenario)",
            )
        if placement.roof_motion is not None:
            raise _refusal(
                "the roof moves as given for a whole run",
                f"{field}.roof_motion",
                hint="leave roof_motion out",
            )
        tables = bool(model.matrices and model.matrices.lift_tables)
        if tables or any(part.lift is not None for part in model.masses):
            raise _refusal(
                "lift tables are read for a whole run",
                f"{field}.model",
                hint="leave the table out, and give static_force with the lift at the speed",
            )
        if placement.mean_force is not None:
            raise _refusal(
                "a mean force is found by whole runs",
                f"{field}.mean_force",
                hint="give static_force; a run states it as static_force_found",
            )


def _refusal(what: str, where: str, hint: str | None = None) -> ModelError:
    return ModelError(f"not in a real-time loop: {what}", where=where, hint=hint)
