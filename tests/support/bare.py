"""Smallest models that a run is made of: a wall, an oscillator, pantographs by their matrices."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.mesh import PLANAR, Mesh
from arcless.mesh.tables.columns import GIVEN
from arcless.mesh.tables.parts import Parts
from arcless.model.settings.run_settings import Solver
from arcless.simulate.setup import trajectory
from arcless.simulate.setup.core_data import (
    Excitation,
    ForceHistory,
    LoadData,
    PantographData,
    RecordPlan,
)
from arcless.simulate.setup.pantographs import plain
from tests.support.schemes import Member
from tests.support.structures import add_element, at_rest, mesh_of

Floats = NDArray[np.float64]


@dataclass
class Asked:
    """Requests to a run.

    Attributes
    ----------
    scheme, h
        Scheme, and step in s.
    positions
        Of the first pantograph at the start and after each step, m; see `stand`.
    contact_stiffness
        In N/m.
    nodes, points
        Nodes, and places in m, whose uplift is recorded.
    loads
        Patterns (node, component, N) with a size at each instant.
    ledger
        Whether the energy balance is kept.
    updated
        Whether coordinates and stiffness are updated in each step.
    friction
        Coefficient between strip and wire.
    """

    scheme: Member
    h: float
    positions: Floats
    contact_stiffness: float = inf
    nodes: Sequence[int] = ()
    points: Sequence[float] = ()
    loads: Sequence[LoadData] = ()
    ledger: bool = False
    updated: bool = False
    friction: float = 0.0


def stand(x: float, steps: int) -> Floats:
    """Stand at a place."""
    return np.full(steps + 1, x)


def run(
    mesh: Mesh, pantograph: PantographData, asked: Asked, *, design: bool = False
) -> dict[str, Any]:
    """Return what the core records of a run with one pantograph, every step of it."""
    core = at_rest(mesh, design=design).core
    solver = Solver.model_validate({"scheme": asked.scheme.settings})
    scheme = trajectory.scheme_numbers(solver.scheme)
    model = core.prepare(
        lanes=mesh.lanes,
        scheme=scheme,
        step=asked.h,
        contact_stiffness=asked.contact_stiffness,
        updated=asked.updated,
    )
    plan = RecordPlan(
        contact_every=1,
        line_every=1,
        links=False,
        nodes=asked.nodes,
        supports=[],
        points=asked.points,
        ledger=asked.ledger,
        ledger_every=1,
    )
    return model.run(
        pantographs=[pantograph],
        distances=[0.0],
        positions=asked.positions,
        speeds=np.gradient(asked.positions, asked.h),
        friction=asked.friction,
        loads=list(asked.loads),
        plan=plan,
        observe=lambda _step: True,
    )


def pantograph(
    mass: Floats,
    damping: Floats,
    stiffness: Floats,
    *,
    strip: Sequence[float],
    force: float = 0.0,
    given: Sequence[tuple[Sequence[float], Floats]] = (),
) -> PantographData:
    """Return a pantograph whose preload acts where its strip is; `given` are forces over time."""
    rows = [np.asarray(m, dtype=np.float64).ravel().tolist() for m in (mass, damping, stiffness)]
    forces = [ForceHistory(direction, values.tolist()) for direction, values in given]
    return PantographData(
        mass=rows[0],
        damping=rows[1],
        stiffness=rows[2],
        strips=[plain(strip, None)],
        preload=list(strip),
        lift=[0.0] * len(strip),
        start_force=force,
        excitation=Excitation(forces),
    )


def free_mass(mass: float, force: float, given: Floats) -> PantographData:
    """Return a mass under a constant force and a given one, in N."""
    nothing = np.zeros((1, 1))
    one = np.full((1, 1), mass)
    return pantograph(one, nothing, nothing, strip=[1.0], force=force, given=[([1.0], given)])


def wall(x: Sequence[float] = (-1.0, 1.0), heights: Sequence[float] = (0.0, 0.0)) -> Mesh:
    """Return straight pieces of wire between points that nothing moves."""
    parts, points = Parts(), np.column_stack([x, np.zeros(len(x)), heights])
    lengths = np.linalg.norm(np.diff(points, axis=0), axis=1)
    rows = [
        add_element(parts, i, rest=length, axial=1e6, mass=1.0, tension=1.0)
        for i, length in enumerate(lengths.tolist())
    ]
    hold(parts, range(len(points)))
    return planar(points, parts, rows)


def oscillator(mass: float, damping: float, stiffness: float) -> Mesh:
    """Return a node between two slack strings with a spring and damper below it: node 2.

    The strings weigh 1 g each, which is taken off the mass. The lane is a wall in front.
    """
    parts = Parts()
    rows = [add_element(parts, i, rest=1.0, axial=1e3, mass=1e-3, tension=0.0) for i in range(3)]
    hold(parts, (0, 1, 3))
    parts.fix(2, 0)
    parts.add("masses", node=2, mass=mass - 1e-3, alpha=0.0)
    parts.add_spring(2, 1, GIVEN, stiffness=stiffness, viscosity=damping)
    return planar(np.array([[float(i), 0.0, 0.0] for i in range(4)]), parts, rows[:1])


def hold(parts: Parts, nodes: Sequence[int]) -> None:
    """Fix nodes of a planar structure."""
    for node in nodes:
        parts.fix(node, 0, 1)


def planar(points: Floats, parts: Parts, lane: list[int]) -> Mesh:
    """Make a planar mesh; points are along, across, up."""
    ordered = points[:, [0, 2, 1]]
    return mesh_of(PLANAR, ordered, np.zeros_like(ordered), parts, lane)
