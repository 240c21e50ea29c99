"""Checkpoint of a run that stops before its end, as its result holds it.

The state between two steps is plain numbers by name: what the core and the controllers remember.
A result keeps them as one variable, and in an attribute which part is what and of which run they
are. `resume` lays the run out again from the scenario in the result and restores the state.
"""

import hashlib
import json
import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from arcless import _core
from arcless.equilibrium.equilibrium import Equilibrium
from arcless.errors import ModelError, ResultFormatError
from arcless.results import Result
from arcless.simulate.setup.trajectory import Motion
from arcless.units import show, to_si

if TYPE_CHECKING:
    from arcless.model import Scenario

Floats = NDArray[np.float64]
STATE_FORMAT = "arcless-state/2"
STATIC_FORCE = "static_force"  # its name among the numbers


@dataclass(frozen=True)
class State:
    """A run after `step` steps: numbers by name."""

    step: int
    numbers: dict[str, Floats]


def stop_step(travel: Motion, until: str | float | None, after: int = 0) -> int:
    """Return the number of steps after which a run has reached `until`.

    A place is that of the first pantograph, a time counts from the start; the run continues to
    the end of the step in which it gets there.

    Raises
    ------
    ModelError
        Neither a place nor a time, one that leaves no step to do after the first `after`, or one
        beyond the end of the run.
    ResultFormatError
        The travel has no step after the first `after`.
    """
    if after >= travel.steps:
        raise ResultFormatError("the state in the result is damaged", where="its step")
    if until is None:
        return travel.steps
    try:
        place, time = to_si(until, "m"), None
    except ModelError:
        place, time = math.nan, _seconds(until)
    if time is not None:
        # A trifle is taken off so that a time of whole steps is not one late by rounding.
        step = math.ceil(time / travel.time_step - 1e-9)
    else:
        step = int(np.searchsorted(travel.positions, place))
    if step <= after:
        time = after * travel.time_step
        raise ModelError(
            "the run is already there",
            where="until",
            got=show(until),
            expected=f"a place beyond {travel.positions[after]:g} m, or a time after {time:g} s",
        )
    if step > travel.steps:
        end, time = travel.positions[-1], travel.steps * travel.time_step
        raise ModelError(
            "the run ends before that",
            where="until",
            got=show(until),
            expected=f"a place up to {end:g} m, or a time up to {time:g} s",
            hint="the run stops by itself where travel ends",
        )
    return step


def _seconds(until: str | float) -> float:
    try:
        return to_si(until, "s")
    except ModelError as error:
        raise ModelError(
            "where the run stops",
            where="until",
            got=show(until),
            expected='a place such as "600 m", or a time such as "5 s"',
        ) from error


def identity(scenario: "Scenario", found: Equilibrium, travel: Motion) -> dict[str, str]:
    """Return fingerprints of what a state belongs to: the scenario, and the line at rest."""
    text = json.dumps(scenario.to_dict(), sort_keys=True, ensure_ascii=False)
    line = hashlib.sha256()
    for name in sorted(found.arrays):
        line.update(np.ascontiguousarray(found.arrays[name]).tobytes())
    line.update(travel.positions.tobytes() + travel.speeds.tobytes())
    return {
        "scenario": hashlib.sha256(text.encode()).hexdigest(),
        "line": line.hexdigest(),
    }


def stored(state: State, place: float, of: dict[str, str]) -> tuple[Floats, dict[str, Any]]:
    """Return a state at a place of the first pantograph, as variable and attribute of a result."""
    parts = {name: len(values) for name, values in state.numbers.items()}
    facts = {"format": STATE_FORMAT, "step": state.step, "position_m": place, **of, "parts": parts}
    return np.concatenate(list(state.numbers.values())), facts


def read(result: Result) -> State:
    """Return the state in a result.

    Raises
    ------
    ResultFormatError
        There is none, it is damaged, or another version wrote it.
    """
    facts, version = result.metadata["state"], result.metadata["arcless_version"]
    if facts is None or "state" not in result.dataset:
        raise ResultFormatError(
            "the result holds no state to continue from",
            got=f"a run of {result.metadata['steps']} steps that went to its end",
            hint='stop a run with `--until "600 m"`, or run(scenario, until="600 m")',
        )
    found = (facts.get("format") if isinstance(facts, dict) else None, version)
    if found != (STATE_FORMAT, _core.__version__):
        raise ResultFormatError(
            "this version cannot continue from the state in the result",
            got=f"{show(found[0])} of version {version}",
            expected=f"{STATE_FORMAT} of version {_core.__version__}, which rounds alike",
            hint="run the scenario again, or continue with the version that wrote it",
        )
    values, parts = result.dataset["state"].values, facts.get("parts")
    step = facts.get("step")
    sound = isinstance(parts, dict) and all(_is_count(n) for n in [step, *parts.values()])
    sound = sound and values.ndim == 1 and values.dtype == np.float64
    if not sound or sum(parts.values()) != len(values) or step != result.metadata["steps"]:
        raise ResultFormatError("the state in the result is damaged", where="attribute `state`")
    if not np.isfinite(values).all():
        raise ResultFormatError("the state in the result is not finite", where="variable `state`")
    ends = np.cumsum(list(parts.values()))[:-1]
    return State(step, dict(zip(parts, np.split(values, ends), strict=True)))


def take_forces(state: State, count: int) -> list[float]:
    """Take the static force of each pantograph in N out of a state."""
    forces = state.numbers.pop(STATIC_FORCE, np.zeros(0))
    if len(forces) != count:
        raise ResultFormatError("the state in the result is damaged", where=STATIC_FORCE)
    return [float(force) for force in forces]


def check_identity(result: Result, now: dict[str, str]) -> None:
    """Refuse to continue with another scenario, or on a line at rest that differs.

    Raises
    ------
    ResultFormatError
        The state in the result is of another run.
    """
    facts = result.metadata["state"]
    if facts.get("scenario") != now["scenario"]:
        raise ResultFormatError(
            "the scenario is not the one that the run began with",
            hint="a changed scenario is a run of its own, from its start",
        )
    if facts.get("line") != now["line"]:
        raise ResultFormatError(
            "the line at rest differs from that at the start of the run",
            expected="the same program on the same kind of machine",
            hint="run the scenario again from its start",
        )


def _is_count(value: Any) -> bool:
    return isinstance(value, int) and not isinstance(value, bool) and value >= 0
