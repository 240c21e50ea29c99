"""Shifted origin

Where the origin of coordinates lies is a matter of taste:

    x → x + 1000 m,   y → y + 50 m,   z → z + 100 m      forces and displacements the same

Derived here: the equations hold differences of coordinates only. The line has four uneven spans
in space (`tests/support/small.py`). All nodes of its mesh are moved before the design, with the
anchors of arms and the rests of springs that are given as coordinates, and so is the travel:
1309 steps at 275 km/h.

What remains is rounding: a coordinate of 1000 m is known to 1.1e-13 m, one of 5 m to 4e-16 m.
"""

from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np

from arcless.mesh import Mesh
from arcless.simulate.runs.job import Job, prepare
from arcless.simulate.setup.trajectory import Motion
from tests.support.faults import Fault, kept
from tests.support.python_faults import misled, wrong
from tests.support.small import FORCE, laid_out, small
from tests.support.structures import at_rest

SHIFTS = {"along": (1000.0, 0.0, 0.0), "across": (0.0, 50.0, 0.0), "up": (0.0, 0.0, 100.0)}


@cache
def in_place() -> tuple[Job, dict[str, Any]]:
    job = laid_out(small())
    raw = job.step([FORCE], full=True)
    assert raw["slack_max"] > 0, "droppers go slack"
    return job, raw


def moved(mesh: Mesh, by: Any) -> Mesh:
    """Move a mesh before its design."""
    struts, springs = mesh.parts["struts"], mesh.parts["springs"]
    struts, springs = struts.copy(), springs.copy()
    struts["anchor"] += by
    springs["rest"] += np.asarray(by)[springs["component"]]
    parts = mesh.parts | {"struts": struts, "springs": springs}
    return replace(mesh, positions=mesh.positions + by, parts=parts)


def difference(by: tuple[float, float, float]) -> tuple[float, float]:
    """Largest differences of the contact force, N, and of the masses, m."""
    job, raw = in_place()
    found = at_rest(moved(job.found.mesh, by), design=True)
    travel = Motion(job.travel.positions + by[0], job.travel.speeds, job.travel.time_step)
    there = replace(job, found=found, model=prepare(found, job.scenario), travel=travel)
    other = there.step([FORCE], full=True)
    lateral = other["lateral"] - raw["lateral"] - by[1]
    assert np.max(np.abs(lateral)) < 1e-6, "it was moved"
    force, masses = (np.max(np.abs(raw[name] - other[name])) for name in ("force", "masses"))
    return float(force), float(masses)


def test_along_the_track(evidence: Any) -> None:
    force, masses = difference(SHIFTS["along"])
    evidence.below(
        "1000 m along: largest difference of the contact force",
        force,
        3e-6,
        unit="N",
        reason="ends of elements known to 1e-13 m change their tension by EA 1e-13/1.4 = 1e-6 N",
    )
    evidence.below(
        "1000 m along: largest difference of the places of the masses",
        masses,
        2e-10,
        unit="m",
        reason="1e-6 N on a line that yields by 0.4 mm/N is 4e-10 m; of single elements half of it",
    )


def test_across_and_up(evidence: Any) -> None:
    across, up = difference(SHIFTS["across"])[0], difference(SHIFTS["up"])[0]
    reason = "coordinates of {} m known to {} m: heights by some of it, times 50 kN/m"
    evidence.below(
        "50 m across: largest difference of the contact force", across, 5e-8, unit="N",
        reason=reason.format(50, "7e-15"),
    )  # fmt: skip
    evidence.below(
        "100 m up: largest difference of the contact force", up, 1e-7, unit="N",
        reason=reason.format(100, "1.4e-14"),
    )  # fmt: skip


def softened(mesh: Mesh) -> Mesh:
    springs = mesh.parts["springs"].copy()
    springs["stiffness"][0] *= 1.0 + 1e-6
    return replace(mesh, parts=mesh.parts | {"springs": springs})


FAULTS = [
    Fault("one support 1e-6 softer where it was moved",
          [kept(in_place), wrong(__name__, "moved", softened)], test_across_and_up),
    Fault("travel 1 µm behind",
          [kept(in_place), misled(__name__, "Motion", lambda x, v, step: (x - 1e-6, v, step))],
          test_along_the_track),
]  # fmt: skip
