"""Stepping loops of whole runs: real-time factor, and the counts behind it."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from arcless.equilibrium import equilibrium
from arcless.model import Scenario, Solver, load
from arcless.model.settings import schemes
from arcless.simulate.runs.job import Job, prepare
from arcless.simulate.setup import pantographs, trajectory
from arcless.simulate.setup.controllers import Controllers
from benchmarks.clock import Taken, interleaved, timed
from benchmarks.floor import Floor, floor, mass_entries

# A matrix in the place of explicit steps, and cubic elements of a quarter of a dropper interval; in
# space shorter ones.
SOLVED: dict[str, Any] = {
    "solver.scheme": "generalised-alpha",
    "solver.residual_flexibility": False,
    "solver.contact_wire_element": "1.45 m",
    "solver.messenger_wire_element": "2.9 m",
    "solver.time_step": "1 ms",
}
SOLVED_IN_SPACE: dict[str, Any] = SOLVED | {
    "solver.contact_wire_element": "0.72 m",
    "solver.messenger_wire_element": "1.45 m",
}
CASES: tuple[tuple[str, str, dict[str, Any]], ...] = (
    ("AC simple, 20 spans, planar", "en50318-ac-simple-320-planar", {}),
    ("in space, stagger, steady arms", "en50318-ac-simple-320", {}),
    ("two pantographs, planar", "ac-simple-320-two-pantographs", {}),
    ("planar with a matrix", "en50318-ac-simple-320-planar", SOLVED),
    (
        "the same with energy balance",
        "en50318-ac-simple-320-planar",
        {**SOLVED, "output.energy": "always"},
    ),
    ("in space with a matrix, 0.72 and 1.45 m", "en50318-ac-simple-320", SOLVED_IN_SPACE),
    ("EN 50318:2002, 10 spans", "en50318-2002-300", {}),
    ("PRAKS, 30 spans, 180 km/h, published method", "praks-180", {}),
    ("PRAKS, 30 spans, 360 km/h, published method", "praks-360", {}),
)
HEAD = (
    "run", "× real time", "µs/step", "unknowns", "solves/step", "pivots/step",
    "kB/step of the whole line",
)  # fmt: skip
SPANS = (10, 20, 50, 100)
# The same with tension lengths of so many spans, each of which shares some with the next.
LENGTH, SHARED = 22, 3
SPANS_IN_LENGTHS = (60, 98, 1000)
SPANS_HEAD = ("spans", "unknowns", "µs/step", "set-up s")


@dataclass(frozen=True)
class Stepping:
    """A scenario ready to step from rest under the forces at the start."""

    job: Job
    forces: list[float]

    @classmethod
    def of(cls, scenario: Scenario) -> "Stepping":
        """Find the equilibrium, factorise."""
        found = equilibrium.find(scenario)
        travel = trajectory.motion(scenario)
        excitations = pantographs.excitations(scenario, travel)
        nobody = Controllers(scenario)
        job = Job(
            scenario,
            found,
            prepare(found, scenario),
            travel,
            excitations,
            [],
            nobody,
            lambda _step: True,
        )
        return cls(job, [placed.start_force or 0.0 for placed in scenario.pantographs])

    def run(self) -> dict[str, Any]:
        """Take all steps, recording everything."""
        return self.job.step(self.forces, full=True)

    def floor(self) -> Floor:
        """What a step of the whole line has to do."""
        nodes, blocks = self.job.model.cost()[:2]
        chained = bool(len(self.job.found.mesh.parts["segments"]))
        width = self.job.found.mesh.dimension * (1 if chained else 2)
        return floor(nodes, blocks, mass_entries(self.job.found), width)


def rows(cases: Sequence[tuple[str, str, dict[str, Any]]] = CASES) -> list[list[str]]:
    """Step each case several times, all in turn."""
    made = [Stepping.of(load(name).with_(**changes)) for _, name, changes in cases]
    taken = interleaved([one.run for one in made])
    return [
        _row(title, one, time) for (title, *_), one, time in zip(cases, made, taken, strict=True)
    ]


def _solves(solver: Solver) -> str:
    if solver.scheme.name == schemes.EXPLICIT:
        return "0"
    # Updated kinematics factorise in every step.
    return "1" if solver.kinematics == "linearised" else "1, with a new factor"


def _row(title: str, one: Stepping, taken: Taken) -> list[str]:
    travel, least, solves = one.job.travel, one.floor(), _solves(one.job.scenario.stepping)
    return [
        title,
        f"{travel.duration / taken.processor:.0f}",
        f"{1e6 * taken.processor / travel.steps:.1f}",
        str(least.unknowns),
        solves,
        f"{one.run()['pivots'] / travel.steps:.2f}",
        # The floor is that of a factor.
        f"{least.bytes / 1024:.0f}" if solves != "0" else "",
    ]


def tension_lengths(spans: int) -> list[dict[str, int]]:
    """Tension lengths of a line of so many spans."""
    firsts = range(1, max(spans - SHARED, 1) + 1, LENGTH - SHARED)
    return [{"from_span": at, "to_span": min(at + LENGTH - 1, spans)} for at in firsts]


def over_spans() -> list[list[str]]:
    """Cost of a step over the length of the line: AC simple, planar, 2 s from the middle on.

    In tension lengths it depends on the place: from the middle on through one of them.
    """
    one_wire = [_span_row(str(count), _of_spans(count)) for count in SPANS]
    overlap = {"raise": ["500 mm", "60 mm"], "separation": 0.0}
    found = []
    for count in SPANS_IN_LENGTHS:
        lengths = {"line.tension_lengths": tension_lengths(count), "line.overlap": overlap}
        start, _ = _of_spans(count).travel_range()
        end = start + 55.0 * (LENGTH - SHARED)
        travel = {"travel.end": end, "output.around": "200 m"}
        scenario = _of_spans(count).with_(**travel, **lengths)
        found.append(_span_row(f"{count}, in tension lengths", scenario))
    return one_wire + found


def _of_spans(count: int) -> Scenario:
    middle = 55.0 * (count // 2 - 2)
    changes: dict[str, Any] = {
        "line.spans": [{"type": "standard", "count": count}],
        "travel": {"start": middle, "end": middle + 2.0 * 320.0 / 3.6},
        "analysis.spans": None,
    }
    return load("en50318-ac-simple-320-planar").with_(**changes)


def _span_row(title: str, scenario: Scenario) -> list[str]:
    made: list[Stepping] = []
    setup = timed(lambda: made.append(Stepping.of(scenario)), 1)
    taken = timed(made[0].run)
    steps = made[0].job.travel.steps
    return [
        title,
        str(made[0].floor().unknowns),
        f"{1e6 * taken.processor / steps:.1f}",
        f"{setup.processor:.2f}",
    ]
