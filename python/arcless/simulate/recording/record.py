"""What the core returns → variables of the result."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from arcless.equilibrium.equilibrium import Equilibrium
from arcless.model import Scenario
from arcless.simulate.recording import contacts

if TYPE_CHECKING:
    import xarray

Floats = NDArray[np.float64]

# Dimensions that count the instants of a run.
SERIES = ("time", "line_time")
# Arrays of the core's record that grow with the run; the others are extremes and counts so far.
GROWING = (
    "time", "force", "gap", "height", "lateral", "position", "speed", "control", "masses",
    "line_time", "link_force", "uplift", "link_first", "uplift_first", "point_uplift",
    "point_along", "slack",
)  # fmt: skip
# Entries of the core's ledger whose names in the result are the field's own words.
ENERGY_NAMES = {
    "riders": "pantograph",
    "dissipated_links": "dissipated_droppers",
    "dissipated_springs": "dissipated_supports",
    "dissipated_riders": "dissipated_pantograph",
    "work_loads": "work_wind",
}


def dynamic_variables(
    raw: dict[str, Any], found: Equilibrium, scenario: Scenario, *, controlled: bool = False
) -> dict[str, Floats]:
    """Return the time series and extremes of a run, shaped as the result wants them."""
    return series(raw, found, scenario, controlled=controlled) | extremes(raw, found)


def series(
    raw: dict[str, Any], found: Equilibrium, scenario: Scenario, *, controlled: bool = False
) -> dict[str, Floats]:
    """Return the time series of a run or of a piece of it, shaped as the result wants them."""
    count = len(scenario.pantographs)
    out = contacts.channels(raw, count)
    out["position"] = raw["position"].reshape(-1, count)
    if controlled:
        out["control_force"] = raw["control"].reshape(-1, count)
    out["speed"] = raw["speed"]
    models = [placement.model for placement in scenario.pantographs]
    moved = _of_each(raw["masses"], [model.size for model in models])
    out["mass_displacement"] = _padded(
        [own[:, model.heights] for own, model in zip(moved, models, strict=True)]
    )
    if any(model.rolls for model in models):
        out["strip_roll"] = _padded(
            [own[:, model.rolls] for own, model in zip(moved, models, strict=True)]
        )
    links = [dropper.link for dropper in found.mesh.droppers]
    # A part of a run may be too short for a row.
    if rows := len(raw["line_time"]):
        out |= _line_series(raw, scenario, links, rows)
    kept = {name: values for name, values in raw["energy"].items() if len(values)}
    if scenario.as_built.gusts is None:
        kept.pop("work_loads", None)
    if not controlled:
        kept.pop("work_control", None)
    for name, values in kept.items():
        out[f"energy_{ENERGY_NAMES.get(name, name)}"] = values
    return out


def extremes(raw: dict[str, Any], found: Equilibrium) -> dict[str, Floats]:
    """Return the extremes over every step of a run so far."""
    links = [dropper.link for dropper in found.mesh.droppers]
    return {
        "dropper_force_min": raw["link_min"][links],
        "dropper_force_max": raw["link_max"][links],
        "support_uplift_max": raw["uplift_max"],
    }


def _line_series(
    raw: dict[str, Any], scenario: Scenario, links: list[int], rows: int
) -> dict[str, Floats]:
    out, output = {"slack_droppers": raw["slack"]}, scenario.output
    # Where only what is near was recorded, every row says where it begins.
    is_near = len(raw["uplift_first"]) > 0
    if output.droppers and is_near:
        out["near_dropper_force"] = raw["link_force"].reshape(rows, -1)
        out["near_dropper_first"] = raw["link_first"]
    elif output.droppers:
        out["dropper_force"] = raw["link_force"].reshape(rows, -1)[:, links]
    if output.supports:
        prefix = "near_" if is_near else ""
        out[f"{prefix}support_uplift"] = raw["uplift"].reshape(rows, -1)
    if output.supports and is_near:
        out["near_support_first"] = raw["uplift_first"]
    if output.points:
        out["point_uplift"] = raw["point_uplift"].reshape(rows, -1)
        out["point_along"] = raw["point_along"].reshape(rows, -1)
    return out


def joined(pieces: Sequence[dict[str, Any]]) -> dict[str, Any]:
    """Return a record from the pieces that the core handed on; the last one says how far it is."""
    last = pieces[-1]
    series = {name: np.concatenate([piece[name] for piece in pieces]) for name in GROWING}
    energy = {
        name: np.concatenate([piece["energy"][name] for piece in pieces]) for name in last["energy"]
    }
    return {**last, **series, "energy": energy}


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
    """Return (time, coordinate) of each pantograph."""
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
        # The ends of the wires are anchored: no support, no arm, no force.
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
    for wire, pieces in _wires(found).items():
        nodes = [node for piece in pieces for node in piece]
        if not nodes:
            continue
        if len(pieces) > 1:
            lengths = [len(piece) for piece in pieces]
            out[f"{wire}_node_wire"] = np.repeat(np.arange(1, len(pieces) + 1), lengths)
        for axis, component in zip("xyz", points[nodes].T, strict=True):
            out[f"{wire}_node_{axis}"] = component
    return out


def _wires(found: Equilibrium) -> dict[str, list[list[int]]]:
    """Return the nodes of each wire by its kind; stitch wires by their tension length."""
    systems = found.mesh.systems
    return {
        "contact_wire": found.mesh.contact_wires,
        "messenger_wire": [system.messenger for system in systems],
        "auxiliary_wire": [system.auxiliary for system in systems],
        "stitch_wire": [[n for one in system.stitches for n in one.nodes] for system in systems],
        "bridle": [[n for one in system.bridles for n in one.nodes] for system in systems],
    }


def _rows(values: Floats, rows: list[int | None]) -> list[float]:
    return [0.0 if row is None else float(values[row]) for row in rows]


def rows(steps: range, scenario: Scenario) -> dict[str, int]:
    """Return how many rows the steps of a run, counted from 0, leave in each of `SERIES`."""
    output = scenario.output
    every = {"time": output.contact_every, "line_time": output.line_every}
    return {axis: _multiples(steps, of) for axis, of in every.items()}


def _multiples(steps: range, of: int) -> int:
    return -(-steps.stop // of) + -steps.start // of


def names(raw: dict[str, Any], found: Equilibrium, scenario: Scenario) -> dict[str, Any]:
    """Return the labels of the result's dimensions."""
    labels = {
        "time": raw["time"],
        "line_time": raw["line_time"],
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
