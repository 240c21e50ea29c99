"""Two pantographs on each hanging line of the library, over their spacing: runs, tables, figure."""

from dataclasses import dataclass
from functools import cache
from math import ceil
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from validation.wake import Wake, recorded_points

import arcless
from arcless.model import Scenario

IMAGES = Path(__file__).parents[1] / "images"
Floats = NDArray[np.float64]

# The shipped scenario with the highest speed on each line that hangs and has equal spans.
SCENARIOS = (
    "en50318-ac-simple-320-planar",
    "china-stitched-350",
    "france-lgv-est-320",
    "china-beijing-yizhuang-300",
    "en50318-2002-300",
    "germany-re-330-300",
    "norway-s25-250",
    "shinkansen-compound-240",
    "spain-ca-220-220",
    "germany-re-200-200",
    "norway-s20a-200",
    "spain-ca-200-200",
    "spain-ca-220-3kv-200",
    "norway-s20b-160",
    "spain-ca-160-3kv-160",
    "india-25kv-140",
)
SPACINGS = tuple(float(d) for d in range(30, 221, 10))
FURTHEST = 220.0
# Spans before the section and within it, for both pantographs; step in s.
BEFORE, ASSESSED, TIME_STEP = 6, 10, 0.002
# Spacings in m that the wake is looked at in, for its frequencies and for σ to first order.
WAKE = np.arange(20.0, FURTHEST + 0.1, 2.0)


@dataclass(frozen=True)
class Setting:
    """Run of a line: its scenario, where the section lies, and how the steps are taken."""

    scenario: str
    before: int = BEFORE
    assessed: int = ASSESSED
    time_step: float = TIME_STEP

    @property
    def base(self) -> Scenario:
        """The shipped scenario."""
        return arcless.load(self.scenario)

    @property
    def length(self) -> float:
        """Length of a span in m."""
        return self.base.line.span_list()[0].length

    @property
    def speed(self) -> float:
        """Speed in m/s."""
        speed = self.base.speed
        assert speed is not None
        return speed

    def section(self) -> tuple[float, float]:
        """Return the ends of the section in m."""
        first = ceil(FURTHEST / self.length) + 1 + self.before
        return first * self.length, (first + self.assessed) * self.length

    def at(self, spacing: float | None, **changes: Any) -> Scenario:
        """Return the scenario with two pantographs so far apart in m, or with one.

        Each has as static force the mean force that the scenario asks for, where it asks for one:
        so nothing is searched for, and both have the same.
        """
        base, length = self.base, self.length
        behind = ceil(FURTHEST / length)
        first, last = self.section()
        data = base.to_dict()
        one: dict[str, Any] = data["pantographs"][0]
        if one["mean_force"] is not None:
            one |= {"mean_force": None, "static_force": one["mean_force"]}
        placed = [one] if spacing is None else [one, {**one, "name": "P2", "distance": spacing}]
        kind = data["line"]["spans"][0]["type"]
        count = 2 * behind + self.before + self.assessed + 3
        return base.with_(**{
            "line.spans": [{"type": kind, "count": count}],
            "pantographs": placed,
            "travel": {"start": (behind + 1) * length, "end": last + (spacing or 0.0) + length / 2},
            "analysis": {"from": first, "to": last},
            "solver.time_step": self.time_step,
            "output": {"line_every": 10_000, "droppers": False},
            **changes,
        })  # fmt: skip


@dataclass(frozen=True)
class Curve:
    """Standard deviations in N over the spacing in m, and that of one pantograph alone."""

    spacings: Floats
    leading: Floats
    trailing: Floats
    alone: float


@cache
def curve(setting: Setting, spacings: tuple[float, ...] = SPACINGS) -> Curve:
    """Run one pantograph, and two at each spacing."""
    print(f"{setting.scenario}: {len(spacings)} spacings", flush=True)
    outcomes = arcless.batch([setting.at(None), *map(setting.at, spacings)])
    found = []
    for outcome in outcomes:
        if outcome.error is not None:
            raise outcome.error
        assert outcome.assessment is not None
        found.append([one.std_force_N for one in outcome.assessment.pantographs])
    (alone,), *pairs = found
    leading, trailing = np.array(pairs).T
    return Curve(np.array(spacings), leading, trailing, alone)


@cache
def wake(setting: Setting) -> Wake:
    """Run one pantograph, with the motion of the wire behind it."""
    first, last = setting.section()
    output = {"line_every": 2, "droppers": False,
              "points": recorded_points(first, last, setting.length)}  # fmt: skip
    end = last + FURTHEST + 1.2 * setting.length  # the margin behind the section has a wake, too
    scenario = setting.at(None, output=output)
    scenario = scenario.with_(**{"travel.end": end})
    return Wake.of(arcless.run(scenario), setting.length)


@cache
def first_order(setting: Setting) -> tuple[Floats, Floats]:
    """Return spacings in m, and σ in N of a trailing pantograph that follows from the wake."""
    behind = wake(setting)
    sigma = [behind.deviation(behind.second_force(d)) for d in WAKE]
    return WAKE, np.array(sigma)
