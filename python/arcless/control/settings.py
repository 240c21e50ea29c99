"""Settings of an environment: each is checked, and says what is expected."""

from collections.abc import Mapping
from typing import Any

from arcless.errors import ModelError
from arcless.model import Scenario
from arcless.model.pantograph.controller import Controller
from arcless.units import show

# A drive that asks two hundred times a second and acts two samples later, within 100 N.
ACTUATOR: Mapping[str, str | float] = {
    "sample_time": "5 ms",
    "delay": "10 ms",
    "minimum_force": "-100 N",
    "maximum_force": "100 N",
    "rate_limit": "5 kN/s",
}


def number_of(scenario: Scenario, name: str | None) -> int:
    """Return the number of a pantograph by its name; the first without.

    Raises
    ------
    ModelError
        There is none of that name.
    """
    names = [placement.name for placement in scenario.pantographs]
    if name is None:
        return 0
    if name not in names:
        raise ModelError(
            "unknown pantograph",
            where="pantograph",
            got=show(str(name)),
            expected=f"one of {', '.join(names)}",
        )
    return names.index(name)


def check_spans(**numbers: Any) -> None:
    """Refuse lengths in spans that are not whole, or a window that the lead-in does not fill.

    Raises
    ------
    ModelError
        The first of them that is wrong.
    """
    for name, value in numbers.items():
        if not isinstance(value, int) or isinstance(value, bool) or value < 1:
            raise ModelError(
                "not a number of spans",
                where=name,
                got=repr(value)[:80],
                expected="a whole number of at least 1",
            )
    lead_in, window = numbers["lead_in_spans"], numbers["window_spans"]
    if window > lead_in:
        raise ModelError(
            "the window is longer than the lead-in",
            where="window_spans",
            got=f"{window}",
            expected=f"at most lead_in_spans, {lead_in}: the window must be full",
        )


def with_actuator(scenario: Scenario, number: int, given: Mapping[str, Any] | None) -> Scenario:
    """Return the scenario with an actuator as its controller, checked as that of a file.

    Raises
    ------
    ModelError
        A field does not fit, or a limit is missing.
    """
    field, placed = f"pantographs.{number}.controller", scenario.pantographs[number].controller
    for name in ("pid", "function"):
        if given is not None and name in given:
            raise ModelError(
                "a law in the actuator",
                where=f"actuator.{name}",
                expected="sample_time, delay, mass and limits: the agent is the law",
            )
    if given is None and placed is not None:
        without = {f"{field}.pid": None, f"{field}.function": None}
        controlled = scenario.with_(**without)
    else:
        controlled = scenario.with_(**{field: dict(ACTUATOR if given is None else given)})
    controller = controlled.pantographs[number].controller
    assert controller is not None
    low, high = controller.minimum_force, controller.maximum_force
    if low is None or high is None or low >= high:
        raise ModelError(
            "an actuator without limits",
            where="actuator",
            got=f"minimum_force {low}, maximum_force {high}",
            expected="both, minimum_force below maximum_force: they are the bounds of the action",
        )
    return controlled


def action_unit_N(controller: Controller, given: Any) -> float:  # noqa: N802 - the unit
    """Return the force of the action 1 in N, for the unit "limit" or "N".

    Raises
    ------
    ModelError
        Another unit.
    """
    if given not in ("limit", "N"):
        raise ModelError(
            "unit of the action", where="action_in", got=repr(given)[:80], expected="limit or N"
        )
    limits = controller.minimum_force, controller.maximum_force
    return 1.0 if given == "N" else max(abs(limit or 0.0) for limit in limits)


def stretch_of(given: Any) -> tuple[float, float] | None:
    """Return a stretch of the line, from and to in m; None without.

    Raises
    ------
    ModelError
        Not two places in order.
    """
    if given is None:
        return None
    try:
        begin, end = (float(place) for place in given)
    except (TypeError, ValueError):
        begin, end = 1.0, 0.0
    if not begin < end:
        raise ModelError(
            "a stretch of the line",
            where="stretch_m",
            got=repr(given)[:80],
            expected="two places in m, from before to",
        )
    return begin, end


def target_of(scenario: Scenario, number: int, given: Any) -> float:
    """Return the mean contact force wanted of a pantograph, given or that of the scenario, N.

    Raises
    ------
    ModelError
        Not a force.
    """
    if given is not None:
        if not isinstance(given, int | float) or not 0 < given < float("inf"):
            raise ModelError(
                "a mean contact force",
                where="target_force_N",
                got=repr(given)[:80],
                expected="a number above 0, in N",
            )
        return float(given)
    placement = scenario.pantographs[number]
    if placement.mean_force is not None:
        return placement.mean_force
    return (placement.start_force or 0.0) + placement.model.lift_at(speed_of(scenario))


def speed_of(scenario: Scenario) -> float:
    """Return the speed of a scenario, m/s.

    Raises
    ------
    ModelError
        It changes.
    """
    if scenario.speed is None:
        raise ModelError(
            "a speed that changes",
            where="speed_profile",
            expected="`speed`: episodes begin anywhere, at one speed",
        )
    return scenario.speed
