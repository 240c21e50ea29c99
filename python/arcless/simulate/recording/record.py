"""Arrays of the core → variables of the result."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from arcless import _core
from arcless.dataset.schema import VARIABLES, Variable
from arcless.equilibrium.equilibrium import Equilibrium
from arcless.model import Scenario
from arcless.simulate.recording import contacts
from arcless.simulate.recording.motion import MotionLayout, wires_of

if TYPE_CHECKING:
    import xarray

Floats = NDArray[np.float64]

# Dimensions that count the instants of a run.
SERIES = ("time", "line_time", "motion_time")
# Variables that are a channel of the core's record: of every row, or of every step.
OF_ROWS = {n: v for n, v in VARIABLES.items() if v.channel and v.dims[0] in SERIES}
OF_STEPS = {n: v for n, v in VARIABLES.items() if v.channel and v.dims[0] not in SERIES}
# Variables of the whole line, and of the part near the pantographs.
OF_DROPPERS = ("dropper_force", "near_dropper_force", "near_dropper_first")
OF_SUPPORTS = tuple(
    name for name, v in OF_ROWS.items() if v.dims[-1].endswith("support") or "support" in name
)


def dynamic_variables(
    raw: dict[str, Any],
    found: Equilibrium,
    scenario: Scenario,
    *,
    controlled: bool = False,
    motion: MotionLayout | None = None,
) -> dict[str, Any]:
    """Return the time series and extremes of a run, shaped as the result wants them."""
    moving = series(raw, found, scenario, controlled=controlled, motion=motion)
    return moving | extremes(raw, found)


def series(
    raw: dict[str, Any],
    found: Equilibrium,
    scenario: Scenario,
    *,
    controlled: bool = False,
    motion: MotionLayout | None = None,
) -> dict[str, Any]:
    """Return the time series of a run or of a piece of it, shaped as the result wants them.

    `motion` is the layout of the motion in the record, None where it holds none.
    """
    count = len(scenario.pantographs)
    out = contacts.channels(raw, count)
    wanted = _wanted(raw, found, scenario, controlled=controlled)
    out |= _channels(raw, found, {name: OF_ROWS[name] for name in wanted})
    out["mass_displacement"] = mass_displacements(raw, scenario)
    models = [placement.model for placement in scenario.pantographs]
    if any(model.rolls for model in models):
        moved = _of_each(raw["masses"], [model.size for model in models])
        out["strip_roll"] = _padded(
            [own[:, model.rolls] for own, model in zip(moved, models, strict=True)]
        )
    kept = {name: values for name, values in raw["energy"].items() if len(values)}
    if scenario.as_built.gusts is None:
        kept.pop("work_wind", None)
    if not controlled:
        kept.pop("work_control", None)
    if motion is not None and len(raw["motion_time"]):
        out |= motion.split(raw)
    return out | {f"energy_{name}": values for name, values in kept.items()}


def mass_displacements(raw: dict[str, Any], scenario: Scenario) -> Floats:
    """Return (time, pantograph, mass) displacement since the start, m."""
    models = [placement.model for placement in scenario.pantographs]
    moved = _of_each(raw["masses"], [model.size for model in models])
    return _padded([own[:, model.heights] for own, model in zip(moved, models, strict=True)])


def extremes(raw: dict[str, Any], found: Equilibrium) -> dict[str, Floats]:
    """Return the extremes over every step of a run so far."""
    return _channels(raw, found, OF_STEPS)


def _wanted(
    raw: dict[str, Any], found: Equilibrium, scenario: Scenario, *, controlled: bool
) -> list[str]:
    """Return the names of `OF_ROWS` that a result has."""
    output = scenario.output
    # Where only what is near was recorded, every row says where it begins.
    is_near = len(raw["uplift_first"]) > 0
    wanted = {
        "control_force": controlled,
        **{name: output.droppers and ("near_" in name) == is_near for name in OF_DROPPERS},
        **{name: output.supports and ("near_" in name) == is_near for name in OF_SUPPORTS},
    }
    for name in _without_value(found):
        wanted[name] = wanted[f"near_{name}"] = False
    return [name for name in OF_ROWS if wanted.get(name, True)]


def _without_value(found: Equilibrium) -> list[str]:
    """Return the series of supports that no support of a line has a value for."""
    supports = found.mesh.supports
    alone = not found.mesh.messenger_nodes
    return [
        *(["support_force"] if all(s.messenger_spring is None for s in supports) else []),
        *(["support_lateral_force"] if all(s.lateral_spring is None for s in supports) else []),
        *(["messenger_uplift"] if alone else []),
        *(["steady_arm_force"] if all(s.steady_arm is None for s in supports) else []),
        *(["steady_arm_angle"] if all(s.steady_arm is None for s in supports) else []),
    ]


def _channels(
    raw: dict[str, Any], found: Equilibrium, wanted: Mapping[str, Variable]
) -> dict[str, Floats]:
    """Return channels as variables, shaped by their dimensions; empty ones are left out."""
    links = [dropper.link for dropper in found.mesh.droppers]
    out = {}
    for name, variable in wanted.items():
        values = raw[variable.channel]
        if not values.size:  # a part of a run may be too short for a row
            continue
        if variable.dims[0] in SERIES and len(variable.dims) > 1:
            values = values.reshape(len(raw[variable.dims[0]]), -1)
        out[name] = values[..., links] if variable.dims[-1] == "dropper" else values
    return out


def joined(pieces: Sequence[dict[str, Any]]) -> dict[str, Any]:
    """Return a record from the pieces that the core handed on; the last one says how far it is."""
    last = pieces[-1]
    series = {name: np.concatenate([piece[name] for piece in pieces]) for name in _core.SERIES}
    energy = {
        name: np.concatenate([piece["energy"][name] for piece in pieces]) for name in last["energy"]
    }
    motion = np.concatenate([piece["motion"] for piece in pieces])
    return {**last, **series, "energy": energy, "motion": motion}


def put_behind(
    earlier: "xarray.Dataset", variables: dict[str, Floats], labels: dict[str, Any]
) -> None:
    """Put the rows of a part of a run behind those that an earlier result has.

    A result has no series without columns, such as the forces of no droppers: here neither.
    """
    empty = [n for n, values in variables.items() if n not in earlier and not values.size]
    for without in empty:
        del variables[without]
    for axis in SERIES:
        before = earlier[axis].values if axis in earlier else np.zeros(0)
        labels[axis] = np.concatenate([before, labels[axis]])
    for name in earlier.data_vars:
        if earlier[name].dims[0] in SERIES:
            rows = [earlier[name].values, *([variables[name]] if name in variables else [])]
            variables[str(name)] = np.concatenate(rows)


def _of_each(flat: Floats, sizes: list[int]) -> list[Floats]:
    """Return a quantity (time, coordinate) of each pantograph."""
    rows = flat.reshape(-1, sum(sizes))
    return np.split(rows, np.cumsum(sizes)[:-1], axis=1)


def _padded(parts: list[Floats]) -> Floats:
    """Return (time, pantograph, number), NaN where a pantograph has fewer than another."""
    most = max(part.shape[1] for part in parts)
    padded = np.full((len(parts[0]), len(parts), most), np.nan)
    for index, part in enumerate(parts):
        padded[:, index, : part.shape[1]] = part
    return padded


def static_variables(found: Equilibrium, elasticity: Floats) -> dict[str, Any]:
    """Return the initial configuration."""
    mesh, points = found.mesh, found.positions
    springs = [support.messenger_spring for support in mesh.supports]
    arms = [support.steady_arm for support in mesh.supports]
    out: dict[str, Any] = {
        "dropper_x": [dropper.x for dropper in mesh.droppers],
        "dropper_span": [dropper.span for dropper in mesh.droppers],
        "dropper_length": found.of_droppers("link_length"),
        "dropper_top_z": points[[dropper.nodes[0] for dropper in mesh.droppers], 2],
        "dropper_bottom_z": points[[dropper.nodes[1] for dropper in mesh.droppers], 2],
        "dropper_force_static": found.of_droppers("link_tension"),
        "support_x": [support.x for support in mesh.supports],
        # Where wires are anchored nothing holds them, and an arm may be no bar: no number.
        "support_force_static": _rows(found.arrays["spring_force"], springs),
        "steady_arm_force_static": _rows(found.arrays["strut_tension"], arms),
        "elasticity": elasticity,
    }
    if mesh.stitches:
        counts = [len(stitch.nodes) for stitch in mesh.stitches]
        numbers = [stitch.support for stitch in mesh.stitches]
        out["stitch_wire_node_support"] = np.repeat(numbers, counts)
    if mesh.bridles:
        counts = [len(bridle.nodes) for bridle in mesh.bridles]
        out["bridle_node_support"] = np.repeat([b.support for b in mesh.bridles], counts)
    for wire, pieces in wires_of(found.mesh).items():
        nodes = [node for piece in pieces for node in piece]
        if not nodes:
            continue
        if len(pieces) > 1:
            lengths = [len(piece) for piece in pieces]
            out[f"{wire}_node_wire"] = np.repeat(np.arange(1, len(pieces) + 1), lengths)
        for axis, component in zip("xyz", points[nodes].T, strict=True):
            out[f"{wire}_node_{axis}"] = component
    return out


def _rows(values: Floats, rows: list[int | None]) -> list[float]:
    return [np.nan if row is None else float(values[row]) for row in rows]


def rows(steps: range, scenario: Scenario, motion: MotionLayout | None = None) -> dict[str, int]:
    """Return how many rows the steps of a run, counted from 0, leave in each of `SERIES`."""
    output = scenario.output
    every = {"time": output.contact_every, "line_time": output.line_every}
    found = {axis: _multiples(steps, of) for axis, of in every.items()}
    found["motion_time"] = 0 if motion is None else _multiples(steps, motion.every)
    return found


def _multiples(steps: range, of: int) -> int:
    return -(-steps.stop // of) + -steps.start // of


def names(
    raw: dict[str, Any],
    found: Equilibrium,
    scenario: Scenario,
    motion: MotionLayout | None = None,
) -> dict[str, Any]:
    """Return the labels of the result's dimensions."""
    labels = {
        "time": raw["time"],
        "line_time": raw["line_time"],
        "motion_time": raw["motion_time"],
        **({} if motion is None else motion.labels),
        "pantograph": [placement.name for placement in scenario.pantographs],
        "dropper": [dropper.name for dropper in found.mesh.droppers],
        "support": [support.name for support in found.mesh.supports],
        "elasticity_x": found.elasticity_positions(),
    }
    named = contacts.labels(raw, labels["pantograph"])
    if named:
        labels["contact"] = named
    if scenario.output.points:
        labels["point"] = [f"{point:g} m" for point in scenario.output.points]
    return labels
