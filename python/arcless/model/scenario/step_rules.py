"""Rules for elements and time steps: they must fit the filter, controllers and the record."""

from math import ceil, floor, isclose

from arcless.errors import ModelError
from arcless.model.fields.part import Path
from arcless.model.scenario.scenario_data import ScenarioData
from arcless.model.scenario.stepping import time_step_of
from arcless.model.settings.run_settings import ONE_ELEMENT, Solver
from arcless.units import show

MAX_ELEMENTS = 500_000
# Opening a result reads all of it; this many steps at 1 ms are nearly three hours.
MAX_STEPS = 10_000_000
KMH = 3.6
# Speed times (element over speed) is the element up to a rounding or two.
ROUNDING = 1e-9
# A multiple of the time step up to rounding of what is written.
MULTIPLE = 1e-6


def check_steps(scenario: ScenarioData, solver: Solver) -> None:
    """Raise `ModelError` for the first thing that does not fit.

    Parameters
    ----------
    scenario
        The scenario.
    solver
        Its solver settings with nothing left to `auto`.
    """
    _check_elements(scenario, solver)
    _check_step(scenario, solver)
    _check_steps(scenario, time_step_of(scenario, solver))
    _check_energy(scenario)


def _check_elements(scenario: ScenarioData, solver: Solver) -> None:
    line = scenario.line
    places = line.support_positions()
    length = sum(
        places[one.to_span] - places[one.from_span - 1] for one in line.tension_length_list()
    )
    wires_above = sum(wire is not None for wire in (line.messenger_wire, line.auxiliary_wire))
    wires_below = 1 if line.twin_contact_wires is None else 2
    elements = wires_below * length / solver.contact_wire_element_m
    elements += wires_above * length / solver.messenger_wire_element_m
    if elements > MAX_ELEMENTS:
        raise ModelError(
            "too many elements",
            got=f"about {elements:.3g}",
            expected=f"at most {MAX_ELEMENTS}",
            hint="use longer elements or a shorter line",
            field=("solver", "contact_wire_element"),
        )


def _check_step(scenario: ScenarioData, solver: Solver) -> None:
    given, field = scenario.solver.time_step, ("solver", "time_step")
    if given == ONE_ELEMENT and scenario.speed is None:
        raise ModelError(
            "no time step",
            got=f"{show(given)} with a speed profile",
            expected="a time: with a changing speed, one element takes no fixed time",
            field=field,
        )
    way = scenario.top_speed * time_step_of(scenario, solver)
    element = solver.contact_wire_element_m
    if way > element * (1 + ROUNDING):
        raise ModelError(
            "step longer than an element",
            got=f"{way:.4g} m in a step",
            expected=f"at most {element:g} m, one element of the contact wire",
            hint=f"give at most {_floor(1e3 * element / scenario.top_speed)} ms at this speed, or"
            " leave solver.time_step out, and it is chosen",
            field=field,
        )


def _check_energy(scenario: ScenarioData) -> None:
    if scenario.output.energy != "always":
        return
    if scenario.solver.kinematics == "updated":
        raise ModelError(
            "no energy balance with updated kinematics",
            got="always",
            expected="auto or never, or solver.kinematics linearised",
            hint="stiffness that is formed again in each step belongs to no stored energy",
            field=("output", "energy"),
        )


def _check_steps(scenario: ScenarioData, step: float) -> None:
    duration = scenario.duration
    if duration / step > MAX_STEPS:
        raise ModelError(
            "too many time steps",
            got=f"about {duration / step:.3g}",
            expected=f"at most {MAX_STEPS}",
            hint=f"the run lasts {duration / 3600:.3g} h at {scenario.top_speed * KMH:.3g} km/h in"
            f" steps of {1e3 * step:.3g} ms: look at speed and travel",
            field=("solver", "time_step"),
        )
    nyquist = 0.5 / (step * scenario.output.contact_every)
    low_pass = scenario.analysis.low_pass
    if low_pass >= nyquist or isclose(low_pass, nyquist):
        raise ModelError(
            "the recorded steps are too long for the filter",
            got=f"{low_pass:g} Hz",
            expected=f"less than {nyquist:g} Hz, half the record rate",
            hint=_slower_filter(scenario.output.contact_every, step, low_pass),
            field=("analysis", "low_pass"),
        )


def _slower_filter(every: int, step: float, low_pass: float) -> str:
    """Say what lets a frequency in Hz be filtered: shorter steps, or more of them recorded."""
    needed = 0.5 / low_pass / step
    if every > 1 and needed > 1:
        return f"give output.contact_every at most {max(1, ceil(needed) - 1)}"
    return (
        f"give solver.time_step less than {_floor(1e3 * 0.5 / low_pass / every)} ms (it is"
        f" {1e3 * step:.3g} ms), or a lower analysis.low_pass"
    )


def _floor(value: float) -> str:
    """Return a number in four digits that is not above the one given."""
    mantissa, exponent = f"{value:.15e}".split("e")
    digits = floor(1e3 * float(mantissa) * (1 + ROUNDING))
    return f"{float(f'{digits}e{int(exponent) - 3}'):.4g}"


def check_controllers(scenario: ScenarioData, step: float) -> None:
    """Refuse times that are no multiple of the time step in s, and masses that are not there."""
    for index, placement in enumerate(scenario.pantographs):
        controller = placement.controller
        if controller is None:
            continue
        field: Path = ("pantographs", index, "controller")
        for name in ("sample_time", "delay"):
            steps = getattr(controller, name) / step
            if abs(steps - round(steps)) > MULTIPLE * max(1.0, steps) or (
                name == "sample_time" and round(steps) == 0
            ):
                raise ModelError(
                    "not a multiple of the time step",
                    got=f"{1e3 * getattr(controller, name):g} ms",
                    expected=f"a multiple of {1e3 * step:g} ms, solver.time_step",
                    field=(*field, name),
                )
        masses = len(placement.model.masses)
        if controller.mass is not None and controller.mass > masses:
            raise ModelError(
                "no such mass",
                got=f"{controller.mass}",
                expected=f"at most {masses}"
                if masses
                else "no mass for a pantograph given by matrices",
                field=(*field, "mass"),
            )
