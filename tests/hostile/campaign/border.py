"""Calls of the compiled core, and of the published step, with arguments spoilt.

A Python exception must come back, or finite numbers.
"""

from collections.abc import Callable
from functools import cache
from random import Random
from typing import Any

import numpy as np

from arcless import _core, lcp
from arcless.errors import ArclessError
from arcless.simulate.runs.job import Job, lay_out
from arcless.simulate.setup import trajectory
from arcless.simulate.setup.controllers import Controllers
from arcless.simulate.setup.core_data import CollectorData, SessionStart
from tests.hostile.campaign import spoiling
from tests.hostile.campaign.blocks import FoundError
from tests.support.explicit import EXPLICIT
from tests.support.small import small

REFUSALS = (
    _core.NativeError,
    ArclessError,
    TypeError,
    ValueError,
    OverflowError,
    KeyError,
    AttributeError,
)
STEPS = 12
MOST_STEPS = 100
# Lines in space with cubic elements, point masses, explicit steps; and one in the plane.
LINES: dict[str, dict[str, Any]] = {
    "cubic": {"solver.scheme": "generalised-alpha"},
    "flexible": {"solver.scheme": "trapezoidal", "solver.residual_flexibility": True},
    "lumped": {"solver.scheme": "generalised-alpha", "solver.wire_model": "lumped"},
    "explicit": EXPLICIT,
}
Call = tuple[Callable[..., Any], list[Any] | dict[str, Any]]


class RecordedError(Exception):
    """Carries the arguments of a run."""


class _Recorder:
    def run(self, **given: Any) -> None:
        raise RecordedError(given)


@cache
def line(name: str) -> Job:
    """Lay out a small line."""
    scenario = small(**LINES[name])
    return lay_out(scenario, Controllers(scenario), lambda _part, _text: None, None)


def ridden(job: Job) -> dict[str, Any]:
    """Return the arguments of a sound run of some steps."""
    alike = Job(**{**vars(job), "model": _Recorder()})  # type: ignore[arg-type]
    try:
        alike.step([120.0] * len(job.scenario.pantographs), full=True)
    except RecordedError as caught:
        given: dict[str, Any] = caught.args[0]
    for along in ("positions", "speeds"):
        given[along] = given[along][: STEPS + 1]
    return given | {"observe": lambda _step: True}


def at_rest(random: Random) -> Call:
    """A call of a line at rest."""
    job = line(random.choice(list(LINES)))
    found, scenario = job.found, job.scenario
    core, mesh = found.core, found.mesh
    way = random.randrange(6)
    if way == 0:
        return _core.Equilibrium, {
            "dimension": mesh.dimension, "positions": mesh.positions, "slopes": mesh.slopes,
            "parts": mesh.parts, "gravity": mesh.gravity, "design": True,
        }  # fmt: skip
    elements = len(mesh.elements)
    if way == 1:
        return core.nodal_forces, [np.ones((elements, 3))]
    if way == 2:
        return core.elasticity, [mesh.lanes, [60.0, 75.5], 100.0]
    if way == 3:
        return core.frequencies, [5]
    if way == 4:
        return core.modes_moved, [mesh.lanes, 60.0, 5]
    return core.prepare, {
        "lanes": mesh.lanes, "scheme": trajectory.scheme_numbers(scenario.stepping.scheme),
        "step": scenario.time_step_s, "contact_stiffness": 5e4, "updated": False,
        "period_correction": True,
    }  # fmt: skip


def running(random: Random) -> Call:
    """A call of a run, or of a loop with the outside."""
    job = line(random.choice(list(LINES)))
    if random.random() < 0.7:
        return job.model.run, ridden(job)
    return _core.Session.with_forces, {
        "line": job.model, "collectors": [CollectorData(0.0, 0.5)], "forces": [120.0],
        "start": SessionStart(60.0, 50.0, 0.0),
    }  # fmt: skip


def plain(random: Random) -> Call:
    """A call that needs no line."""
    n = random.randint(1, 6)
    matrix = np.array([[random.gauss(0, 1) for _ in range(n)] for _ in range(n)])
    matrix = matrix @ matrix.T + np.eye(n)
    vector = np.array([random.gauss(0, 1) for _ in range(n)])
    way = random.randrange(5)
    if way == 0:
        return _core.solve_lcp, [matrix.ravel(), vector]
    if way == 1:
        return lcp.PublishedStep, [matrix, matrix, matrix, 1e-3]
    if way == 2:
        system, zero = lcp.PublishedStep(matrix, matrix, matrix, 1e-3), np.zeros(n)
        return system.step, [zero, zero, vector, np.eye(n)[:, :1], np.zeros(1)]
    if way == 3:
        return _core.filter_on, [np.ones((2, 5)), np.zeros((n, 2, 2)), np.ones((n, 4))]
    return _core.filtered, [np.ones((2, 5)), np.zeros((2, 2)), vector]


def case(seed: int) -> str:
    """Spoil the arguments of a call, and call."""
    random = Random(f"calls {seed}")
    made = random.choices([plain, at_rest, running], weights=[6, 3, 1])[0]
    called, given = made(random)
    name = getattr(called, "__name__", "?")
    spoilt = spoiling.call(random, given)
    if name == "modes_moved" and isinstance(spoilt[2], int):
        # All the modes there are take half a minute, and one time is as good as a thousand.
        spoilt[2] = min(spoilt[2], MOST_STEPS)
    with np.errstate(all="ignore"):
        try:
            answer = called(**spoilt) if isinstance(spoilt, dict) else called(*spoilt)
        except REFUSALS:
            return f"{name} refused"
    if name != "filtered":  # which does arithmetic with what it is given
        finite(name, answer)
    return f"{name} answered"


def finite(name: str, answer: Any) -> None:
    """See that numbers that came back are finite."""
    if isinstance(answer, _core.Equilibrium):
        answer = answer.arrays()
    if name == "run":
        answer = {key: answer[key] for key in ("time", "force", "masses", "link_force", "uplift")}
    if isinstance(answer, lcp.Step):
        answer = [answer.u, answer.force, answer.gap]
    parts = answer.values() if isinstance(answer, dict) else answer
    if not isinstance(answer, (dict, list, tuple)):
        return
    for part in parts:
        if isinstance(part, (float, list, np.ndarray)) and not np.isfinite(part).all():
            raise FoundError(f"{name}: numbers that are not finite")
