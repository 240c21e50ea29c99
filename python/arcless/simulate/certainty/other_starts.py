"""Other starts of a run, and the same passage begun there.

The numbers of a run depend on its start: lines damp so little that the waves of the start are still
there when the section is reached. No start is better than another within a span, so others are
taken, evenly spread over the length L of the span that the run itself starts in: s + k L/N,
k = 1 … N − 1.

A start that is carried forward must not carry its own transient into the section: it keeps two
spans from it, as a section by default keeps two spans from the ends of the line. What would come
nearer begins a whole span further back instead, at the same place of its span. Nothing begins
within a quarter of a span from the beginning of the line. Where that leaves less than L the starts
are spread over what is left.

The pantograph stays the same. Its base spring is at rest at the height where a run starts, and
there alone it has its static force P. Begun where the wire at rest is at another height w, with
another elasticity e, the same pantograph with the stiffness K against a slow rise has there

    P′ = P − K (w′ + e′ (P′ + A′) − w − e (P + A)),

A the lift at the speed of the start. On AC simple at 320 km/h the mean force then stays within
0.1 N, from all starts. With the static force kept as a number it would change by up to 3 N: not
because a run is a draw, but because it would be another pantograph.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from arcless.errors import ModelError
from arcless.model import Analysis, Scenario, SpeedProfile, Travel
from arcless.simulate.runs.first_guess import base_stiffness

if TYPE_CHECKING:
    from arcless.model.pantograph.placement import PantographPlacement
    from arcless.simulate.runs.job import Job

Floats = NDArray[np.float64]

# Spans that a start keeps from the section, and the part of a span that it keeps from the end.
RUN_IN_SPANS = 2.0
FROM_THE_END_SPANS = 0.25
# Less than that of a span to spread the starts over says little of a span.
LEAST_SPAN = 0.25


def places(scenario: Scenario) -> list[float]:
    """Return where the first pantograph starts in m, in each of the runs; first in the run itself.

    Raises
    ------
    ModelError
        There is no room for other starts.
    """
    assert scenario.certainty is not None
    count = scenario.certainty.starts
    start, _ = scenario.travel_range()
    first, room = window(scenario)
    return [first + (start - first + k * room / count) % room if k else start for k in range(count)]


def window(scenario: Scenario) -> tuple[float, float]:
    """Return where starts lie: from a place in m, over a length in m.

    Raises
    ------
    ModelError
        There is no room for other starts.
    """
    start, _ = scenario.travel_range()
    section, _ = scenario.analysis_range()
    span = _span_at(scenario, start)
    last = min(max(start, section - RUN_IN_SPANS * span), start + span)
    first = min(start, max(_earliest(scenario, span), last - span))
    if last - first < LEAST_SPAN * span:
        raise ModelError(
            "no room for other starts",
            where="certainty",
            got=f"a start at {start:g} m, and a section from {section:g} m",
            expected=f"{LEAST_SPAN * span:g} m to begin in, at least"
            f" {RUN_IN_SPANS * span:g} m before the section",
            hint="a later travel.start or a later section, or no certainty",
        )
    return first, last - first


def started_at(job: "Job", forces: list[float], places: Sequence[float]) -> list[Scenario]:
    """Return the same passage, begun with the first pantograph at each of other places in m.

    Parameters
    ----------
    job
        The run.
    forces
        Static force of each pantograph in the run in N.
    places
        Where the others begin.
    """
    speeds = [_speed_at(job.scenario, place) for place in places]
    carried = carried_forces(job, forces, places, [speed for speed, _ in speeds])
    return [
        _begun(job.scenario, place, profile, own)
        for place, (_, profile), own in zip(places, speeds, carried, strict=True)
    ]


def _begun(
    scenario: Scenario, place: float, profile: SpeedProfile | None, forces: Sequence[float]
) -> Scenario:
    _, end = scenario.travel_range()
    begin, finish = scenario.analysis_range()
    carried = [
        placement.model_copy(update={"mean_force": None, "static_force": force})
        for placement, force in zip(scenario.pantographs, forces, strict=True)
    ]
    return scenario.model_copy(
        update={
            "pantographs": tuple(carried),
            "speed_profile": profile,
            "travel": Travel(start=place, end=end),
            "analysis": _fixed(scenario.analysis, begin, finish),
            "output": scenario.output.model_copy(update={"energy": "never"}),
            "certainty": None,
        }
    )


def _fixed(analysis: Analysis, begin: float, end: float) -> Analysis:
    """Return the same analysis over a section that no longer follows from the travel."""
    return analysis.model_copy(update={"from_": begin, "to": end, "spans": None})


def _span_at(scenario: Scenario, place: float) -> float:
    """Return the length in m of the span at a place."""
    supports = np.array(scenario.line.support_positions())
    index = int(np.clip(np.searchsorted(supports, place, "right"), 1, len(supports) - 1))
    return float(supports[index] - supports[index - 1])


def _earliest(scenario: Scenario, span: float) -> float:
    """Return the first place in m where the first pantograph may start."""
    start, end = scenario.travel_range()
    bounds = [
        scenario.line.support_positions()[0]
        + FROM_THE_END_SPANS * span
        + scenario.pantographs[-1].distance
    ]
    profile = scenario.speed_profile
    if profile is not None and profile.speed[0] == 0.0:
        bounds.append(start)  # a train that stands comes from nowhere
    for placement in scenario.pantographs:
        roof = placement.roof_motion
        if roof is not None and roof.position is not None:
            bounds.append(roof.position[0] + placement.distance)
        elif roof is not None and roof.time is not None and scenario.speed is not None:
            bounds.append(end - scenario.speed * roof.time[-1])
        elif roof is not None:
            bounds.append(start)
    return max(bounds)


def _speed_at(scenario: Scenario, place: float) -> tuple[float, SpeedProfile | None]:
    """Return the speed in m/s at a start, and the profile with the same speed at every place."""
    profile = scenario.speed_profile
    if profile is None:
        assert scenario.speed is not None
        return scenario.speed, None
    start, _ = scenario.travel_range()
    times, speeds = np.array(profile.time), np.array(profile.speed)
    begin = _time_at(times, speeds, place - start)
    inside = times > begin
    speed = float(np.interp(begin, times, speeds))
    return speed, SpeedProfile(
        time=(0.0, *(times[inside] - begin).tolist()), speed=(speed, *speeds[inside].tolist())
    )


def _time_at(times: Floats, speeds: Floats, way: float) -> float:
    """Return when a way in m is travelled; below 0 at the first speed, as if it had come so."""
    if way <= 0.0:
        return way / float(speeds[0]) if way else 0.0
    pieces = np.diff(times) * (speeds[1:] + speeds[:-1]) / 2.0
    ways = np.concatenate([[0.0], np.cumsum(pieces)])
    piece = int(np.clip(np.searchsorted(ways, way, "right") - 1, 0, len(pieces) - 1))
    slope = (speeds[piece + 1] - speeds[piece]) / (times[piece + 1] - times[piece])
    rest, speed = way - ways[piece], speeds[piece]
    # The smaller root of speed t + slope t²/2 = rest, in the form that has no difference in it.
    root = np.sqrt(max(0.0, speed * speed + 2.0 * slope * rest))
    return float(times[piece] + (2.0 * rest / (speed + root) if speed + root > 0.0 else 0.0))


def carried_forces(
    job: "Job", forces: list[float], places: Sequence[float], speeds: Sequence[float]
) -> list[list[float]]:
    """Return the static forces in N that the same pantographs have at other starts.

    Parameters
    ----------
    job
        The run.
    forces
        Static force of each pantograph in the run in N.
    places, speeds
        Where the first pantograph starts otherwise in m, and its speed there in m/s.

    Returns
    -------
    Of each start those of all pantographs.
    """
    starts = np.array([job.travel.positions[0], *places])
    at = [float(job.travel.speeds[0]), *speeds]
    of_each = [
        _carried_one(job, placement, force, starts, at)
        for placement, force in zip(job.scenario.pantographs, forces, strict=True)
    ]
    return [list(own) for own in zip(*of_each, strict=True)]


def _carried_one(
    job: "Job",
    placement: "PantographPlacement",
    force: float,
    starts: Floats,
    speeds: Sequence[float],
) -> list[float]:
    """Return P′ of the formula above at all starts but the first, which is the run's own."""
    base = base_stiffness(placement.model)
    if base == 0.0:
        return [force] * (len(starts) - 1)
    x = starts - placement.distance
    lift = np.array([placement.model.lift_at(speed) for speed in speeds])
    yields = job.found.elasticity(x, max(0.0, force + float(lift[0])))
    height = job.found.lowest_heights(x)
    raised = yields[0] * (force + lift[0]) - yields[1:] * lift[1:]
    carried = (force + base * (height[0] - height[1:] + raised)) / (1.0 + base * yields[1:])
    found: list[float] = carried.tolist()
    return found
