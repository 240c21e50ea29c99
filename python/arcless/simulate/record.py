"""What the core returns → variables of the result."""

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from arcless.model import Scenario
from arcless.simulate import contacts
from arcless.simulate.equilibrium import Equilibrium

if TYPE_CHECKING:
    import xarray

Floats = NDArray[np.float64]

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
    out["dropper_force_min"] = raw["link_min"][links]
    out["dropper_force_max"] = raw["link_max"][links]
    out["support_uplift_max"] = raw["uplift_max"]
    kept = {name: values for name, values in raw["energy"].items() if len(values)}
    if scenario.as_built.gusts is None:
        kept.pop("work_loads", None)
    if not controlled:
        kept.pop("work_control", None)
    for name, values in kept.items():
        out[f"energy_{ENERGY_NAMES.get(name, name)}"] = values
    return out


def _line_series(
    raw: dict[str, Any], scenario: Scenario, links: list[int], rows: int
) -> dict[str, Floats]:
    out, output = {"slack_droppers": raw["slack"]}, scenario.output
    if output.droppers:
        out["dropper_force"] = raw["link_force"].reshape(rows, -1)[:, links]
    if output.supports:
        out["support_uplift"] = raw["uplift"].reshape(rows, -1)
    if output.points:
        out["point_uplift"] = raw["point_uplift"].reshape(rows, -1)
        out["point_along"] = raw["point_along"].reshape(rows, -1)
    return out


def put_behind(
    earlier: "xarray.Dataset", variables: dict[str, Floats], labels: dict[str, Any]
) -> None:
    """Put the rows of a part of a run behind those that an earlier result has."""
    for axis in ("time", "line_time"):
        before = earlier[axis].values if axis in earlier else np.zeros(0)
        labels[axis] = np.concatenate([before, labels[axis]])
    for name in earlier.data_vars:
        if earlier[name].dims[0] in ("time", "line_time"):
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


def names(raw: dict[str, Any], found: Equilibrium, scenario: Scenario, x: Floats) -> dict[str, Any]:
    """Return the labels of the result's dimensions."""
    labels = {
        "time": raw["time"],
        "line_time": raw["line_time"],
        "pantograph": [placement.name for placement in scenario.pantographs],
        "dropper": [dropper.name for dropper in found.mesh.droppers],
        "support": [support.name for support in found.mesh.supports],
        "elasticity_x": x,
    }
    named = contacts.labels(raw, labels["pantograph"])
    if named:
        labels["contact"] = named
    if scenario.output.points:
        labels["point"] = [f"{point:g} m" for point in scenario.output.points]
    return labels
