"""Whether time steps fit the elements, the filter and what can be recorded."""

from math import ceil, floor, isclose
from typing import TYPE_CHECKING

from arcless.errors import ModelError
from arcless.model.settings.run_settings import ONE_ELEMENT
from arcless.units import show

if TYPE_CHECKING:
    from arcless.model.scenario.scenario import Scenario

# Opening a result reads all of it; this many steps at 1 ms are nearly three hours.
MAX_STEPS = 10_000_000
KMH = 3.6
# Speed times (element over speed) is the element up to a rounding or two.
ROUNDING = 1e-9


def check_steps(scenario: "Scenario") -> None:
    """Raise `ModelError` for the first thing that does not fit."""
    _check_step(scenario)
    _check_steps(scenario)
    _check_energy(scenario)


def _check_step(scenario: "Scenario") -> None:
    solver, field = scenario.solver, ("solver", "time_step")
    if solver.time_step == ONE_ELEMENT and scenario.speed is None:
        raise ModelError(
            "no time step",
            got=f"{show(solver.time_step)} with a speed profile",
            expected="a time: with a changing speed, one element takes no fixed time",
            field=field,
        )
    way, element = (
        scenario.top_speed * scenario.time_step_s,
        scenario.stepping.contact_wire_element_m,
    )
    if way > element * (1 + ROUNDING):
        raise ModelError(
            "step longer than an element",
            got=f"{way:.4g} m in a step",
            expected=f"at most {element:g} m, one element of the contact wire",
            hint=f"give at most {_floor(1e3 * element / scenario.top_speed)} ms at this speed, or"
            " leave solver.time_step out, and it is chosen",
            field=field,
        )


def _check_energy(scenario: "Scenario") -> None:
    if scenario.output.energy != "always":
        return
    if scenario.solver.kinematics == "updated":
        raise ModelError(
            "no energy ledger with updated kinematics",
            got="always",
            expected="auto or never, or solver.kinematics linearised",
            hint="stiffness that is formed anew in each step belongs to no stored energy",
            field=("output", "energy"),
        )


def _check_steps(scenario: "Scenario") -> None:
    duration = scenario.duration
    step = scenario.time_step_s
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
            hint=_slower_filter(scenario, low_pass),
            field=("analysis", "low_pass"),
        )


def _slower_filter(scenario: "Scenario", low_pass: float) -> str:
    """Say what lets a frequency in Hz be filtered: shorter steps, or more of them recorded."""
    every, step = scenario.output.contact_every, scenario.time_step_s
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
