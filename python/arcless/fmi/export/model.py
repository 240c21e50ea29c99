"""Scenario → model: the line at rest, or a pantograph, as bytes that the library opens."""

from collections.abc import Sequence
from typing import cast

from arcless import _core
from arcless.equilibrium import equilibrium
from arcless.errors import ModelError
from arcless.fmi.export.choice import Choice
from arcless.mesh import Mesh
from arcless.model import Scenario
from arcless.model.pantograph.pantograph import Pantograph
from arcless.model.pantograph.placement import PantographPlacement
from arcless.simulate.runs.failures import preparing, stepping
from arcless.simulate.runs.job import stepping_of
from arcless.simulate.session.start import check, given_forces, pantograph_at, start
from arcless.simulate.setup import pantographs, trajectory
from arcless.simulate.setup.core_data import (
    DriveData,
    ExternalPantograph,
    OnLineData,
    PantographData,
    SessionStart,
    StripData,
)

# Mark of a pantograph that something outside moves: a session never asks it.
OUTSIDE = object()


def model_of(scenario: Scenario, choice: Choice) -> bytes:
    """Return the model that a choice means.

    Raises
    ------
    ModelError
        A choice that the scenario does not have; what a loop cannot do, see `arcless.realtime`.
    MeshError, EquilibriumError, ContactError
        The line cannot be divided, has no equilibrium, or the start is not on it.
    """
    choice.check(scenario)
    if choice.pantograph is None:
        return _line(scenario, choice)
    return _pantograph(scenario, choice.number(scenario))


def _pantograph(scenario: Scenario, number: int) -> bytes:
    """Return a pantograph by itself, in the equilibrium that it starts in on its line."""
    begun = start(scenario, simulated=True)
    placement = scenario.pantographs[number]
    with stepping(begun.mesh, scenario.pantographs):
        return _core.exported_pantograph(
            session=begun.core,
            number=number,
            stepping=stepping_of(scenario),
            name=placement.name,
            heights=heights_of(placement.model),
            influence=list(placement.model.raised),
        )


def _line(scenario: Scenario, choice: Choice) -> bytes:
    simulated = choice.given == "control-force"
    check(scenario, simulated=simulated)
    found = equilibrium.find(scenario)
    travel = trajectory.motion(scenario)
    position, speed = float(travel.positions[0]), float(travel.speeds[0])
    placements = scenario.pantographs
    drive, on_line = _drive(choice, found.mesh, placements, speed)
    supports = _supports(found.mesh, choice.supports)
    with preparing(found.mesh, scenario), stepping(found.mesh, placements):
        return _core.exported_line(
            line=found.core,
            lanes=found.mesh.lanes,
            stepping=stepping_of(scenario),
            drive=drive,
            start=SessionStart(position, speed, friction=scenario.contact.friction_coefficient),
            travel=choice.travel,
            pantographs=on_line,
            watched=[found.mesh.supports[row].contact_node for row in supports],
            supports=[found.mesh.supports[row].name for row in supports],
        )


def _drive(
    choice: Choice, mesh: Mesh, placements: tuple[PantographPlacement, ...], speed: float
) -> tuple[DriveData, list[OnLineData]]:
    """Return what presses against the line, and the names of its parts."""
    strips = [len(pantographs.data(placement.model, 0.0).strips) for placement in placements]
    named = [(placement.name, count) for placement, count in zip(placements, strips, strict=True)]
    distances = [placement.distance for placement in placements]
    if choice.given == "contact-force":
        given = given_forces(mesh, placements, speed)
        drive = DriveData(collectors=given.collectors, forces=given.forces)
        return drive, [OnLineData(name, count, []) for name, count in named]
    if choice.given == "strip-height":
        outside = [strips_alone(placement, speed) for placement in placements]
        drive = DriveData(pantographs=outside, distances=distances)
        return drive, [OnLineData(name, count, []) for name, count in named]
    inside = [pantograph_at(placement, speed) for placement in placements]
    return DriveData(pantographs=inside, distances=distances), [
        OnLineData(name, count, heights_of(placement.model))
        for (name, count), placement in zip(named, placements, strict=True)
    ]


def strips_alone(placement: PantographPlacement, speed: float) -> PantographData:
    """Return the strips of a pantograph that something outside moves, each with one height."""
    strips = pantographs.data(placement.model, 0.0).strips
    alone = [
        StripData(
            offset=strip.offset,
            half_width=strip.half_width,
            knots=[0.0],
            vectors=[[float(own == number) for own in range(len(strips))]],
        )
        for number, strip in enumerate(strips)
    ]
    force = (placement.start_force or 0.0) + placement.model.lift_at(speed)
    return PantographData(
        mass=(),
        damping=(),
        stiffness=(),
        strips=alone,
        preload=(),
        lift=(),
        start_force=force,
        external=cast(ExternalPantograph, OUTSIDE),
    )


def heights_of(pantograph: Pantograph) -> list[tuple[int, str]]:
    """Return the coordinates of a pantograph that are heights, with names."""
    if pantograph.matrices is not None:
        return [(index, f"coordinate_{index + 1}") for index in pantograph.heights]
    masses = len(pantograph.masses)
    head = [index for index in pantograph.heights if index >= masses]
    return [
        *((index, f"mass_{index + 1}") for index in pantograph.heights if index < masses),
        *((index, f"head_{number}") for number, index in enumerate(head, start=1)),
    ]


def _supports(mesh: Mesh, wanted: Sequence[str] | None) -> list[int]:
    """Return the rows of supports by their names; all of them without."""
    names = [support.name for support in mesh.supports]
    if wanted is None:
        return list(range(len(names)))
    rows = []
    for name in wanted:
        if name not in names:
            some = ", ".join(f"`{each}`" for each in names[:3])
            raise ModelError(
                "a support whose uplift is to be an output",
                where="--uplift",
                got=f"`{name}`",
                expected=f"a support of the line: {some}, …",
            )
        rows.append(names.index(name))
    return rows
