"""Rules for a scenario: pantographs, travel, section and points must fit together."""

from itertools import pairwise
from math import isclose

from arcless.errors import ModelError
from arcless.model.fields.part import Path
from arcless.model.fields.rule_errors import both_given, missing
from arcless.model.line.line_data import POSITION_TOLERANCE
from arcless.model.pantograph.force_tables import LiftTable
from arcless.model.pantograph.pantograph import Pantograph
from arcless.model.scenario.scenario_data import ScenarioData
from arcless.model.settings.schemes import EXPLICIT
from arcless.units import show

KMH = 3.6
# Speed times (element over speed) is the element up to a rounding or two.
ROUNDING = 1e-9


def check_scenario(scenario: ScenarioData) -> None:
    """Raise `ModelError` for the first thing that does not fit, the speed being as it should."""
    _check_dimension(scenario)
    _check_scheme(scenario)
    _check_pantographs(scenario)
    _check_travel(scenario)
    _check_lift(scenario)
    _check_roofs(scenario)
    _check_section(scenario)
    _check_points(scenario)


def _check_scheme(scenario: ScenarioData) -> None:
    line = scenario.line
    wire = next((name for name, each in line.wires() if each.tension == 0), None)
    if scenario.solver.scheme.name == EXPLICIT and wire is not None:
        raise ModelError(
            "explicit steps on a rail",
            got=f"{scenario.solver.scheme.name} with line.{wire}.tension of 0 N",
            expected="a wire under tension: waves of a rail have no speed that bounds a step",
            hint="leave solver.scheme to auto, which takes a matrix for this line",
            field=("solver", "scheme"),
        )


def _check_dimension(scenario: ScenarioData) -> None:
    if scenario.solver.dimension == "planar" and scenario.line.is_spatial:
        raise ModelError(
            "a planar calculation of a line that is not planar",
            got="planar",
            expected="auto or spatial for a line with stagger, curves, hinged steady arms or wires"
            " that part",
            hint="leave solver.dimension out; a planar line is straight, without stagger, with"
            " steady arms of kind spring",
            field=("solver", "dimension"),
        )


def check_speed(scenario: ScenarioData) -> None:
    """Raise `ModelError` unless there is one speed, or one profile, with motion."""
    if scenario.speed is None and scenario.speed_profile is None:
        raise missing(
            "speed", expected="speed or speed_profile", hint="for instance speed: 160 km/h"
        )
    if scenario.speed is not None and scenario.speed_profile is not None:
        raise both_given(
            "speed",
            "speed_profile",
            expected="one of the two",
            hint="leave out the one that is not meant",
        )
    if scenario.speed_profile is not None and max(scenario.speed_profile.speed) <= 0:
        raise ModelError(
            "no motion",
            got="a profile of zeros",
            expected="a speed above 0",
            field=("speed_profile", "speed"),
        )


def _check_pantographs(scenario: ScenarioData) -> None:
    placements = scenario.pantographs
    if placements[0].distance != 0:
        raise ModelError(
            "wrong distance",
            got=f"{placements[0].distance:g} m",
            expected="0 m for the first pantograph",
            hint="distances count from the first pantograph, backwards",
            field=("pantographs", 0, "distance"),
        )
    for index, (front, behind) in enumerate(pairwise(placements), start=1):
        if behind.distance <= front.distance:
            raise ModelError(
                "pantographs out of order",
                got=f"{behind.distance:g} m after {front.distance:g} m",
                expected="distances that increase towards the rear",
                hint="every distance counts from the first pantograph, backwards",
                field=("pantographs", index, "distance"),
            )
    names = [placement.name for placement in placements]
    for index, name in enumerate(names):
        if name in names[:index]:
            raise ModelError(
                "name used twice",
                got=show(name),
                expected="a different name for each pantograph",
                field=("pantographs", index, "name"),
            )


def _check_travel(scenario: ScenarioData) -> None:
    length = scenario.line.total_length
    for name in ("start", "end"):
        _check_inside(getattr(scenario.travel, name), length, ("travel", name))
    start, end = scenario.travel_range()
    last = scenario.pantographs[-1].distance
    if start < last:
        raise ModelError(
            "the last pantograph starts outside the line",
            got=f"a start at {start:g} m with {last:g} m between first and last",
            expected=f"a start of at least {last:g} m",
            hint="travel.start is the place of the first pantograph",
            field=("travel", "start"),
        )
    if start >= end:
        raise ModelError(
            "no travel",
            got=f"{start:g} m to {end:g} m",
            expected="a start before the end",
            hint=_why_no_travel(scenario, length, last),
            field=("travel",),
        )


def _why_no_travel(scenario: ScenarioData, length: float, last: float) -> str:
    if scenario.travel.start is not None and scenario.travel.end is not None:
        return "travel.start and travel.end are places of the first pantograph"
    if last:
        return (
            f"the line is {length:g} m long and the last pantograph {last:g} m behind the first:"
            " add spans, bring the pantographs closer together, or give travel.start and travel.end"
        )
    return "add spans, or give travel.start and travel.end"


def _check_lift(scenario: ScenarioData) -> None:
    """Refuse a lift table that does not reach over all speeds of the scenario."""
    profile = scenario.speed_profile
    slowest, fastest = scenario.top_speed, scenario.top_speed
    if profile is not None:
        slowest = min(profile.speed)
    for index, placement in enumerate(scenario.pantographs):
        for field, table in _lift_tables(placement.model):
            first, last = table.speed[0], table.speed[-1]
            if slowest < first * (1 - ROUNDING) or fastest > last * (1 + ROUNDING):
                raise ModelError(
                    "the table does not reach over the speeds travelled",
                    got=f"{first * KMH:.4g} to {last * KMH:.4g} km/h",
                    expected=_over(slowest, fastest),
                    hint="give the table more points, or change the speed: nothing is assumed"
                    " beyond a table's ends",
                    field=("pantographs", index, "model", *field, "speed"),
                )


def _over(slowest: float, fastest: float) -> str:
    if isclose(slowest, fastest):
        return f"a table over {fastest * KMH:.4g} km/h"
    return f"at least {slowest * KMH:.4g} to {fastest * KMH:.4g} km/h"


def _lift_tables(pantograph: Pantograph) -> list[tuple[Path, LiftTable]]:
    found: list[tuple[Path, LiftTable]] = [
        (("masses", number, "lift"), mass.lift)
        for number, mass in enumerate(pantograph.masses)
        if mass.lift is not None
    ]
    if pantograph.matrices is not None:
        tables = enumerate(pantograph.matrices.lift_tables)
        found += [(("matrices", "lift_tables", number), table) for number, table in tables]
    return found


def _check_roofs(scenario: ScenarioData) -> None:
    """Refuse a roof motion that begins after or ends before the run."""
    start, end = scenario.travel_range()
    for index, placement in enumerate(scenario.pantographs):
        roof = placement.roof_motion
        if roof is None:
            continue
        if roof.time is None:
            first, last = start - placement.distance, end - placement.distance
        else:
            first, last = 0.0, scenario.duration
        unit = "s" if roof.time is not None else "m"
        slack = ROUNDING * max(1.0, last)
        if roof.points[0] > first + slack or roof.points[-1] < last - slack:
            raise ModelError(
                "the roof motion does not cover the run",
                got=f"{roof.points[0]:g} to {roof.points[-1]:g} {unit}",
                expected=f"at least {first:g} to {last:g} {unit}",
                hint="shorten travel, or give more points",
                field=("pantographs", index, "roof_motion", roof.over),
            )


def _check_section(scenario: ScenarioData) -> None:
    length = scenario.line.total_length
    analysis = scenario.analysis
    count = len(scenario.line.support_positions()) - 1
    if analysis.spans is not None and analysis.spans[1] > count:
        raise ModelError(
            "analysis section outside the line",
            got=f"span {analysis.spans[1]}",
            expected=f"spans between 1 and {count}",
            field=("analysis", "spans"),
        )
    for value, name in ((analysis.from_, "from"), (analysis.to, "to")):
        _check_inside(value, length, ("analysis", name), "analysis section outside the line")
    (first, last), (start, end) = scenario.analysis_range(), scenario.travel_range()
    name = "spans" if analysis.spans is not None else "to" if analysis.from_ is None else "from"
    if first >= last:
        raise ModelError(
            "empty analysis section",
            got=f"{first:g} m to {last:g} m",
            expected="a section whose end lies behind its start",
            field=("analysis", name),
        )
    rear = scenario.pantographs[-1].distance
    if start >= end - rear:
        raise ModelError(
            "no place that every pantograph passes",
            got=f"{start:g} m to {end:g} m of the first one, and the last one {rear:g} m behind it",
            expected=f"a way of more than {rear:g} m",
            hint=f"add spans of more than {rear - (end - start):.0f} m in all, or bring the"
            " pantographs closer together",
            field=("pantographs", len(scenario.pantographs) - 1, "distance"),
        )
    if last <= start or first >= end - rear:
        raise ModelError(
            "analysis section not travelled by every pantograph",
            got=f"{first:g} m to {last:g} m",
            expected=f"a section between {start:g} m and {end - rear:g} m",
            hint="choose a section within that, or change travel.start or travel.end",
            field=("analysis", name),
        )


def _check_points(scenario: ScenarioData) -> None:
    for index, point in enumerate(scenario.output.points):
        _check_inside(point, scenario.line.total_length, ("output", "points", index))


def _check_inside(
    x: float | None, length: float, field: Path, what: str = "outside the line"
) -> None:
    if x is not None and not 0 <= x <= length + POSITION_TOLERANCE:
        expected = f"a position between 0 and {length:g} m, the line's length"
        raise ModelError(what, got=f"{x:g} m", expected=expected, field=field)
