"""Failures of a computation: named in the words of the line; of a step, saved for a replay."""

import json
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from arcless import _core
from arcless.equilibrium.equilibrium import place_of, translate
from arcless.errors import (
    ArclessError,
    ContactError,
    EquilibriumError,
    ModelError,
    ResultFormatError,
)
from arcless.mesh import Mesh
from arcless.model import Scenario
from arcless.model.pantograph.placement import PantographPlacement
from arcless.simulate.recording.contacts import label
from arcless.simulate.setup.stops_and_friction import piecewise_forces
from arcless.simulate.setup.trajectory import Motion

# A run starts in statics, and with updated kinematics the tangent is factorised in every step.
STATIC = ("equilibrium", "singular", "unstable")

# Failures of a pantograph that is not below its wire any more.
BESIDE = ("off_wire", "out_of_reach")

# Failures of a step as a whole: what, and a hint.
STEPS = {
    "slack_set": ("the set of slack droppers did not settle", "try a shorter solver.time_step"),
    "not_finite": (
        "the motion grew beyond all bounds",
        "check stiffnesses and dampers; try a dissipative scheme",
    ),
    "folded": (
        "the motion grew beyond all bounds: the contact wire folds back on itself",
        "updated kinematics need a scheme that damps: try a smaller spectral_radius",
    ),
}


@contextmanager
def preparing(mesh: Mesh, scenario: Scenario) -> Iterator[None]:
    """Turn refusals of `solver` or of the line by the core into an error that names the field."""
    try:
        yield
    except _core.NativeError as error:
        kind, message, details = error.args
        if kind == "too_long":
            raise _too_long(scenario, details["longest"]) from error
        if kind == "singular":
            raise _unsolvable(mesh, details["node"]) from error
        if (kind, details.get("array")) != ("input", "solver"):
            raise translate(mesh, kind, message, details) from error
        scheme = scenario.stepping.scheme.name
        raise ModelError(
            f"this line cannot be stepped with the scheme {scheme}",
            where="solver.scheme",
            got=details["reason"],
            hint="leave solver.scheme to auto",
        ) from error


def _unsolvable(mesh: Mesh, node: int) -> EquilibriumError:
    """Say that the matrix of the steps is singular, although the line at rest is firm."""
    return EquilibriumError(
        "the equations of a step cannot be solved",
        where=place_of(mesh, node),
        got="stiffness, damping or mass that outweighs all else there by more than numbers resolve",
        hint="check damping, masses and stiffnesses around that place",
    )


def _too_long(scenario: Scenario, longest_s: float) -> ModelError:
    return ModelError(
        "explicit steps too long for the elements",
        where="solver.time_step",
        got=f"{1e3 * scenario.time_step_s:.4g} ms",
        expected=f"at most about {1e3 * longest_s:.3g} ms, the longest stable step",
        hint="leave solver.time_step to auto; or longer elements: those of "
        f"{scenario.choice.contact_wire:g} m and {scenario.choice.messenger_wire:g} m, which auto"
        " takes for this line and speed, go with it",
    )


@contextmanager
def stepping(
    mesh: Mesh, placements: Sequence[PantographPlacement], travel: Motion | None = None
) -> Iterator[None]:
    """Turn errors of the stepping loop into errors that name step, time and link.

    Given the travel they say where the pantographs were, too.
    """
    try:
        yield
    except _core.NativeError as error:
        kind, message, details = error.args
        if kind == "beyond_table":
            raise _beyond_table(placements, details) from error
        names = [placement.name for placement in placements]
        at = None
        if travel is not None and "step" in details:
            at = _steps_done(details, travel)
            details = {"time": at * travel.time_step, **details}
        failure = translated(mesh, names, kind, message, details)
        if isinstance(failure, ContactError) and travel is not None and at is not None:
            _place(failure, kind, at, placements, travel)
        raise failure from error


def _steps_done(details: dict[str, Any], travel: Motion) -> int:
    """Return how many steps were done at the time of a failure."""
    time = details.get("time")
    done = details["step"] if time is None else round(time / travel.time_step)
    return int(min(done, travel.steps))


def _place(
    failure: ContactError,
    kind: str,
    at: int,
    placements: Sequence[PantographPlacement],
    travel: Motion,
) -> None:
    """Put into the error of a step when that was, and where the pantographs were.

    Where one has left the wire the message has its place already.
    """
    failure.time_s = at * travel.time_step
    failure.positions_m = {
        placement.name: float(travel.positions[at]) - placement.distance for placement in placements
    }
    if kind not in BESIDE:
        places = [f"{name} at {x:.2f} m" for name, x in failure.positions_m.items()]
        failure.where = ", ".join([failure.where or f"step {at}", *places])


def translated(
    mesh: Mesh, pantographs: Sequence[str], kind: str, message: str, details: dict[str, Any]
) -> ArclessError:
    """Return the error of a step in words; `pantographs` are their names."""
    if kind == "lcp":
        return _unsolved(mesh, pantographs, details)
    if kind in BESIDE:
        return _beside_the_wire(pantographs, kind, details)
    if kind == "external":
        return ContactError(
            f"the program that moves pantograph {pantographs[details['pantograph']]} failed",
            where=f"step {details['step']}, t = {details['time']:.6g} s",
            got=details["reason"],
        )
    if (kind, details.get("array")) == ("input", "state"):
        return ResultFormatError("the state in the result does not fit this run", got=message)
    if kind == "balance" or kind in STEPS:
        return _of_step(kind, details)
    is_static = kind in STATIC
    return translate(mesh, kind, message, details) if is_static else ContactError(message)


def _beside_the_wire(
    pantographs: Sequence[str], kind: str, details: dict[str, Any]
) -> ContactError:
    if kind == "off_wire":
        return ContactError(
            f"pantograph {pantographs[details['pantograph']]} left the wire",
            where=f"step {details['step']}",
            got=f"{details['position']:.2f} m",
            hint="shorten travel, or lengthen the line",
        )
    name = pantographs[details["pantograph"]]
    return ContactError(
        f"the contact wire leaves the collector of pantograph {name} sideways",
        where=f"{details['position']:.2f} m, step {details['step']}",
        got=f"{abs(details['lateral']):.3f} m off the middle",
        expected=f"at most the half width of the collector, {details['half_width']:.3f} m",
        hint="a collector shorter than the stagger: check both, and the wind",
    )


# Failures of the energy balance: what, what is expected, and a hint.
FAULT = (
    "a fault of the program or of the machine: please report it; `output.energy: never` runs"
    " without the ledger"
)
UNBALANCED = {
    "residual": ("the energy balance does not close", "1e-9", FAULT),
    "damping": ("wires supply energy instead of damping it", "−1e-5", FAULT),
    "switching": (
        "contacts and droppers that open and close take or give too much energy",
        "5 %",
        "try a shorter solver.time_step: it falls with the step",
    ),
}


def _of_step(kind: str, details: dict[str, Any]) -> ContactError:
    """Return the error of a step as a whole."""
    time = f", t = {details['time']:.6g} s" if "time" in details else ""
    where = f"step {details['step']}{time}"
    if kind in STEPS:
        what, hint = STEPS[kind]
        return ContactError(what, where=where, hint=hint)
    what, share, hint = UNBALANCED[details["what"]]
    return ContactError(
        what,
        where=where,
        got=f"{details['off']:.3g} J",
        expected=f"within {share} of the {details['turnover']:.3g} J turned over or stored so far",
        hint=hint,
    )


def _beyond_table(
    placements: Sequence[PantographPlacement], details: dict[str, Any]
) -> EquilibriumError:
    number = details["pantograph"]
    law = piecewise_forces(placements[number].model)[details["table"]]
    return EquilibriumError(
        f"a table of pantograph {placements[number].name} ends before the static force is reached",
        where=f"pantographs.{number}.model.{law.field}.elongation",
        got=f"{details['end']:g} m",
        expected=f"a table that reaches {details['place']:.4g} m",
        hint="lengthen the table, or lower the static force",
    )


def _unsolved(mesh: Mesh, pantographs: Sequence[str], details: dict[str, Any]) -> ContactError:
    droppers = {dropper.link: dropper.name for dropper in mesh.droppers}
    links = _contacts(details["contacts"], pantographs)
    links += [droppers[i] for i in details["links"]]
    for name, count in zip(pantographs, details["stops"], strict=False):
        links += [f"stop or kink {k} of pantograph {name}" for k in range(1, count + 1)]
    problem = {
        "kind": "lcp",
        "step": details["step"],
        "time_s": details["time"],
        "links": links,
        "H": details["h"],
        "w": details["w"],
        "reason": details["reason"],
    }
    return ContactError(
        "the complementarity problem of a step could not be solved",
        where=f"step {details['step']}, t = {details['time']:.6g} s, {', '.join(links)}",
        got=details["reason"],
        hint=_replay(json.dumps(problem)),
    )


def _contacts(numbers: Sequence[Sequence[int]], pantographs: Sequence[str]) -> list[str]:
    """Name the contacts of a step; strip and wire only where a pantograph has several."""
    owners = [pantograph for pantograph, _, _ in numbers]
    if len(set(owners)) == len(owners):
        return [f"pantograph {pantographs[owner]}" for owner in owners]
    return [f"pantograph {label(each, pantographs)}" for each in numbers]


def _replay(text: str) -> str:
    """Save the failed problem, and say how to replay it; without room the failure still counts."""
    try:
        path = _save(text)
    except OSError as error:
        return f"no file to replay it could be written: {error.strerror or error}"
    return f"replay it with `arcless replay {path}`"


def _save(text: str) -> Path:
    """Write a file that outlives the run into the folder for temporary files."""
    file = tempfile.NamedTemporaryFile(  # noqa: SIM115 - closed below, where it may fail
        "w", prefix="arcless-lcp-", suffix=".json", delete=False, encoding="utf-8"
    )
    try:
        with file:
            file.write(text)
    except BaseException:
        Path(file.name).unlink(missing_ok=True)
        raise
    return Path(file.name)
