"""Rules for the line as built: its deviations must fit the line."""

from arcless.errors import ModelError
from arcless.model.as_built.gusts import Gusts
from arcless.model.as_built.measured_heights import check_measured
from arcless.model.line.line_data import POSITION_TOLERANCE
from arcless.model.line.places.dropper_names import DropperName, droppers_called, parse_name
from arcless.model.line.places.support_names import SupportName, supports_called
from arcless.model.scenario.scenario_data import ScenarioData
from arcless.units import accepted

# Relative tolerance, equal in all checks of a scenario: the end of a run is the way over the speed.
ROUNDING = 1e-9

WIRES = ("contact_wire", "messenger_wire", "stitch_wire", "auxiliary_wire", "bridle")


def check_as_built(scenario: ScenarioData) -> None:
    """Raise `ModelError` for the first thing that does not fit."""
    if scenario.as_built.wind.speed:
        _check_wind(scenario, ("wind", "speed"), f"{scenario.as_built.wind.speed:g} m/s")
    if scenario.as_built.gusts is not None:
        _check_wind(scenario, ("gusts",), "gusts")
        _check_gusts(scenario, scenario.as_built.gusts)
    if scenario.as_built.measured_heights:
        check_measured(scenario.line, scenario.as_built.measured_heights)
    if scenario.as_built.is_empty:
        return
    _check_droppers(scenario)
    _check_supports(scenario)
    _check_wear(scenario)
    _check_ice(scenario)


def _check_droppers(scenario: ScenarioData) -> None:
    built, known = scenario.as_built, set[DropperName]()
    given = [
        *(
            (e.name, ("dropper_length_errors", i))
            for i, e in enumerate(built.dropper_length_errors)
        ),
        *((parse_name(n), ("missing_droppers", i)) for i, n in enumerate(built.missing_droppers)),
    ]
    for name, where in given:
        field = ("as_built", *where)
        found = droppers_called(scenario.line, name)
        if not found:
            raise _unknown(scenario, name, field)
        if len(found) > 1:
            raise ModelError(
                "a name that fits several droppers",
                got=str(name),
                expected=" or ".join(str(one) for one in found),
                field=field,
            )
        if found[0] in known:
            raise ModelError(
                "dropper given twice",
                got=f"{name}, which is {found[0]}",
                expected="each dropper once",
                field=field,
            )
        known.add(found[0])


def _unknown(scenario: ScenarioData, name: DropperName, field: tuple[str | int, ...]) -> ModelError:
    spans = scenario.line.span_list()
    near = min(max(name.span, 1), len(spans))
    count = len(spans[near - 1].droppers.positions)
    close = DropperName(near, min(max(name.dropper, 1), count))
    there = droppers_called(scenario.line, close)
    hint = f"did you mean {' or '.join(str(one) for one in there)}? " if there else ""
    return ModelError(
        "unknown dropper",
        got=str(name),
        expected=f"a dropper of the line's {len(spans)} spans",
        hint=f"{hint}span {near} has {count} droppers",
        field=field,
    )


def _check_supports(scenario: ScenarioData) -> None:
    known = set[SupportName]()
    for index, error in enumerate(scenario.as_built.support_height_errors):
        field = ("as_built", "support_height_errors", index)
        found = supports_called(scenario.line, error.name)
        if not found:
            last = len(scenario.line.support_positions())
            raise ModelError(
                "no support that holds wires",
                got=str(error.name),
                expected=f"a support from 2 to {last - 1} that is no end of a tension length",
                hint="at their ends wires are anchored at the height as drawn",
                field=field,
            )
        if len(found) > 1:
            raise ModelError(
                "a name that fits several supports",
                got=str(error.name),
                expected=" or ".join(str(one) for one in found),
                field=field,
            )
        if found[0] in known:
            raise ModelError(
                "support given twice",
                got=str(error.name),
                expected="each support once",
                field=field,
            )
        known.add(found[0])


def _check_wear(scenario: ScenarioData) -> None:
    length = scenario.line.total_length
    for index, worn in enumerate(scenario.as_built.contact_wire_wear):
        if worn.to > length + POSITION_TOLERANCE:
            raise ModelError(
                "wear outside the line",
                got=f"{worn.from_:g} m to {worn.to:g} m",
                expected=f"a stretch between 0 and {length:g} m, the line's length",
                field=("as_built", "contact_wire_wear", index, "to"),
            )


def _check_ice(scenario: ScenarioData) -> None:
    for name in WIRES:
        coat = getattr(scenario.as_built.ice, name)
        if coat and getattr(scenario.line, name) is None:
            raise ModelError(
                "ice on a wire that the line does not have",
                got=f"{coat:g} kg/m",
                expected="0 kg/m, or a line with this wire",
                hint="leave it out",
                field=("as_built", "ice", name),
            )


def _check_gusts(scenario: ScenarioData, gusts: Gusts) -> None:
    """Refuse readings that begin after or end before the run."""
    end = scenario.duration
    slack = ROUNDING * max(1.0, end)
    for place, rows in gusts.stations().items():
        first, last = gusts.time[rows[0]], gusts.time[rows[-1]]
        if first > slack or last < end - slack:
            where = "" if gusts.position is None else f" at {place:g} m"
            raise ModelError(
                f"the gusts{where} do not cover the run",
                got=f"{first:g} to {last:g} s",
                expected=f"at least 0 to {end:g} s",
                hint="shorten travel, or give more readings",
                field=("as_built", "gusts", "time"),
            )


def _check_wind(scenario: ScenarioData, field: tuple[str, ...], got: str) -> None:
    line, dimension = scenario.line, scenario.solver.dimension
    if dimension == "planar" or (dimension == "auto" and not line.is_spatial):
        raise ModelError(
            "wind on a planar line",
            got=f"{got} with solver.dimension {dimension}",
            expected="a spatial line",
            hint="a planar line cannot move across the track: set solver.dimension to spatial",
            field=("as_built", *field),
        )
    for name in WIRES:
        wire = getattr(line, name)
        if wire is not None and wire.diameter is None:
            raise ModelError(
                "wind on a wire without diameter",
                expected=f"line.{name}.diameter: {accepted('m')}",
                hint="that of a contact wire of 100 mm² is 12 mm",
                field=("as_built", *field),
            )
