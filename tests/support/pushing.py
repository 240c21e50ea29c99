"""Runs on a hand-built line: strips that press on its first wire, forces on its nodes."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from arcless.equilibrium.equilibrium import Equilibrium
from arcless.model.pantograph.pantograph import Pantograph
from arcless.simulate.setup import pantographs
from arcless.simulate.setup.core_data import Excitation, ForceHistory, LoadData, RecordPlan

Floats = NDArray[np.float64]

TRAPEZOIDAL: tuple[str, list[float]] = ("trapezoidal", [])
EXPLICIT: tuple[str, list[float]] = ("central-difference", [])
# Rigid contact under the trapezoidal rule lets a strip ring at the step frequency, with up to
# 1e6 m/s² where it meets a front: 1e-3 N. In kg.
WEIGHTLESS = 1e-9


@dataclass(frozen=True)
class Pressed:
    """Record of a run: times in s at the balance of each step, the rest at these times.

    Attributes
    ----------
    height : of the wire at the strip, m
    force : of the contact, N
    nodes, points : uplift of nodes and places asked for (time × number), m
    along : motion of these places along the track (time × number), m
    links : tension of each link (time × number), N
    """

    time: Floats
    height: Floats
    force: Floats
    nodes: Floats
    points: Floats
    along: Floats
    links: Floats


def mass(kilograms: float, stiffness: float = 0.0, damping: float = 0.0) -> Pantograph:
    """Return a pantograph of one mass, kg, with a spring and a damper to the ground."""
    one = {"mass": kilograms, "stiffness": stiffness, "damping": damping}
    return Pantograph.model_validate({"name": "one mass", "masses": [one]})


def press(
    line: Equilibrium,
    start_force: float,
    positions: Floats,
    speed: float,
    step: float,
    *,
    added: Floats | None = None,
    strip: Pantograph | None = None,
    nodes: Sequence[int] = (),
    points: Sequence[float] = (),
    loads: Sequence[LoadData] = (),
    contact: float = np.inf,
    scheme: tuple[str, list[float]] = TRAPEZOIDAL,
    period_correction: bool = False,
) -> Pressed:
    """Let a strip press on the wire, from equilibrium under `start_force` N.

    Parameters
    ----------
    line
        As found by `Straight.find`.
    positions, speed
        Of the strip at the start and after each step, m and m/s.
    added
        What its force changes by, at the same instants, N.
    strip
        A pantograph; without one, a force.
    loads
        Forces on nodes at the same instants.
    contact
        Stiffness of the contact, N/m.
    scheme
        Name and numbers of the scheme, as the core is asked.
    period_correction
        Whether the mass of the wires is corrected for the period error of the scheme.
    """
    pantograph = strip or mass(WEIGHTLESS)
    changing = [] if added is None else [ForceHistory([1.0], added.tolist())]
    plan = RecordPlan(
        contact_every=1,
        line_every=1,
        links=True,
        nodes=nodes,
        supports=[],
        points=points,
        ledger=False,
        ledger_every=1,
    )
    model = line.core.prepare(
        lanes=line.mesh.lanes,
        scheme=scheme,
        step=step,
        contact_stiffness=contact,
        updated=False,
        period_correction=period_correction,
    )
    raw = model.run(
        pantographs=[pantographs.data(pantograph, start_force, Excitation(changing))],
        distances=[0.0],
        positions=positions,
        speeds=[speed] * len(positions),
        friction=0.0,
        loads=list(loads),
        plan=plan,
        observe=lambda _step: True,
    )
    rows = len(raw["line_time"])
    assert rows == len(positions) - 1
    return Pressed(
        raw["time"],
        raw["height"],
        raw["force"],
        raw["uplift"].reshape(rows, -1),
        raw["point_uplift"].reshape(rows, -1),
        raw["point_along"].reshape(rows, -1),
        raw["link_force"].reshape(rows, -1),
    )
