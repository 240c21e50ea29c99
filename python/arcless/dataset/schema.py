"""Content of a result file: one table that building, checking and the documentation share."""

from dataclasses import dataclass
from typing import Any, Literal

RESULT_FORMAT = "arcless-result/1"


@dataclass(frozen=True)
class Dimension:
    """One dimension of the dataset, with the coordinate that labels it."""

    kind: Literal["number", "name", "count"]
    units: str
    long_name: str


@dataclass(frozen=True)
class Variable:
    """One variable of the dataset."""

    dims: tuple[str, ...]
    units: str
    long_name: str
    required: bool = False
    integer: bool = False
    padded: bool = False
    """True when whole columns may be NaN (a pantograph with fewer masses than another)."""
    absent: bool = False
    """True when single values may be NaN (a contact that has no wire in reach)."""
    single: bool = False
    """True for numbers of single precision."""
    channel: str = ""
    """Channel of the core's record that it is, columns in the order of the dimension."""


@dataclass(frozen=True)
class Attribute:
    """One attribute of the dataset; lists and dictionaries are stored as JSON text."""

    kind: Literal["text", "integer", "number", "json"]
    meaning: str
    required: bool = False


DIMENSIONS: dict[str, Dimension] = {
    "time": Dimension("number", "s", "time since the start of the run, contact channels"),
    "line_time": Dimension("number", "s", "time since the start of the run, line channels"),
    "pantograph": Dimension("name", "1", "pantograph name, first in the direction of travel first"),
    "contact": Dimension("name", "1", "strip of a pantograph on a lane of contact wires"),
    "mass": Dimension("count", "1", "mass of a pantograph, from 1 at the base to the strips"),
    "strip": Dimension("count", "1", "strip of a collector head, from 1, the first in front"),
    "dropper": Dimension("name", "1", "dropper name"),
    "support": Dimension("name", "1", "support name"),
    "near_dropper": Dimension("count", "1", "place in a row of the droppers near the pantographs"),
    "near_support": Dimension("count", "1", "place in a row of the supports near the pantographs"),
    "point": Dimension("name", "1", "recorded point of the contact wire"),
    "motion_time": Dimension("number", "s", "time since the start of the run, motion of the wires"),
    "motion_wire": Dimension(
        "name", "1", "wire whose motion is recorded: its kind, and its number or that of its lane"
    ),
    "motion_node": Dimension(
        "count", "1", "place in a row of motion: nodes near the pantographs, wire after wire"
    ),
    "near_motion_dropper": Dimension(
        "count", "1", "place in a row of the droppers whose force goes with the motion"
    ),
    "contact_wire_node": Dimension("count", "1", "node of the contact wire"),
    "messenger_wire_node": Dimension("count", "1", "node of the messenger wire"),
    "auxiliary_wire_node": Dimension("count", "1", "node of the auxiliary wire"),
    "stitch_wire_node": Dimension("count", "1", "node of the stitch wires, one after the other"),
    "bridle_node": Dimension("count", "1", "node of the bridles, one after the other"),
    "elasticity_x": Dimension("number", "m", "position at which the elasticity was found"),
    "mode": Dimension("count", "1", "natural mode of the line at rest"),
    "state_number": Dimension("count", "1", "number of the state of a run that stopped early"),
}

_CONTACT = ("time", "pantograph")
_LINE = ("line_time",)


def _energy(long_name: str) -> Variable:
    """Return an entry of the energy balance: NaN in rows at which it was not settled."""
    return Variable(_LINE, "J", long_name, absent=True)


def _wire_number(wire: str) -> Variable:
    meaning = "number of its wire, from 1; only where there are several"
    return Variable((f"{wire}_wire_node",), "1", meaning, integer=True)


# Name, channel of the core, unit and meaning of what holds the wires at supports.
_HOLDING = (
    ("support_force", "support_force", "N", "vertical force on the support, positive downwards"),
    (
        "support_lateral_force",
        "support_lateral",
        "N",
        "lateral force of the wires on the support, positive to the left",
    ),
    ("messenger_uplift", "held_uplift", "m", "uplift of the messenger wire at the support"),
    ("steady_arm_force", "arm_force", "N", "force of the steady arm, tension positive"),
    (
        "steady_arm_angle",
        "arm_angle",
        "rad",
        "angle of the steady arm to the horizontal, positive with its hinge higher",
    ),
)


def _holding(dim: str) -> dict[str, Variable]:
    """Return the variables of all supports, or of those near the pantographs."""
    near = dim.removesuffix("support")
    return {
        f"{near}{name}": Variable(
            ("line_time", dim),
            units,
            f"{meaning}{', near the pantographs' if near else ''}; NaN where there is none",
            absent=True,
            channel=channel,
        )
        for name, channel, units, meaning in _HOLDING
    }


_MOTION = ("motion_time", "motion_node")
# Kinds of wires, whose nodes are dimensions.
WIRES = ("contact_wire", "messenger_wire", "auxiliary_wire", "stitch_wire", "bridle")


def _lane(wire: str) -> Variable:
    meaning = "lane of the recorded motion, from 1, which wires one behind the other share"
    return Variable((f"{wire}_node",), "1", meaning, integer=True)


VARIABLES: dict[str, Variable] = {
    "contact_force": Variable(_CONTACT, "N", "contact force", required=True),
    "contact_gap": Variable(
        _CONTACT, "m", "gap between contact wire and strip, 0 when closed", required=True
    ),
    "contact_height": Variable(
        _CONTACT, "m", "height of the contact wire above rail at the pantograph", required=True
    ),
    "contact_lateral": Variable(_CONTACT, "m", "lateral position of the contact wire at the strip"),
    "wire_contact_force": Variable(("time", "contact"), "N", "force of a single contact"),
    "wire_contact_gap": Variable(
        ("time", "contact"),
        "m",
        "gap of a single contact, NaN with no wire in reach",
        absent=True,
    ),
    "wire_contact_lateral": Variable(
        ("time", "contact"),
        "m",
        "lateral position of the wire at a single contact, NaN without a wire",
        absent=True,
    ),
    "position": Variable(
        _CONTACT,
        "m",
        "position of the pantograph along the track",
        required=True,
        channel="position",
    ),
    "control_force": Variable(
        _CONTACT, "N", "controlled force on the pantograph, upwards", channel="control"
    ),
    "speed": Variable(("time",), "m/s", "speed of the train", required=True, channel="speed"),
    "mass_displacement": Variable(
        ("time", "pantograph", "mass"),
        "m",
        "vertical displacement of a pantograph mass since the start of the run",
        padded=True,
    ),
    "strip_roll": Variable(
        ("time", "pantograph", "strip"),
        "rad",
        "roll angle of a strip since the start of the run, positive when the left side rises",
        padded=True,
    ),
    "dropper_force": Variable(
        ("line_time", "dropper"), "N", "dropper force, tension positive", channel="link_force"
    ),
    "support_uplift": Variable(
        ("line_time", "support"), "m", "uplift of the contact wire", channel="uplift"
    ),
    **_holding("support"),
    "near_dropper_force": Variable(
        ("line_time", "near_dropper"),
        "N",
        "force of the droppers near the pantographs",
        channel="link_force",
    ),
    "near_dropper_first": Variable(
        _LINE,
        "1",
        "place in `dropper_order` of the first dropper of a row, from 0",
        integer=True,
        channel="link_first",
    ),
    "near_support_uplift": Variable(
        ("line_time", "near_support"),
        "m",
        "uplift at the supports near the pantographs",
        channel="uplift",
    ),
    **_holding("near_support"),
    "near_support_first": Variable(
        _LINE,
        "1",
        "place in `support_order` of the first support of a row, from 0",
        integer=True,
        channel="uplift_first",
    ),
    "point_uplift": Variable(
        ("line_time", "point"), "m", "uplift of the contact wire", channel="point_uplift"
    ),
    "point_along": Variable(
        ("line_time", "point"),
        "m",
        "displacement of the contact wire along the track",
        channel="point_along",
    ),
    "slack_droppers": Variable(
        _LINE, "1", "number of slack droppers", integer=True, channel="slack"
    ),
    "energy_kinetic": _energy("kinetic energy of the line"),
    "energy_elastic": _energy("elastic energy of the line"),
    "energy_contact": _energy("energy stored in contacts and bump stops"),
    "energy_pantograph": _energy("kinetic and elastic energy of the pantographs"),
    "energy_dissipated_line": _energy("energy dissipated in the wires"),
    "energy_dissipated_droppers": _energy("energy dissipated in the droppers"),
    "energy_dissipated_supports": _energy("energy dissipated at the supports"),
    "energy_dissipated_pantograph": _energy("energy dissipated in the pantographs"),
    "energy_dissipated_scheme": _energy("energy dissipated by the time scheme"),
    "energy_switching": _energy(
        "energy lost where a contact or a dropper closes or opens within a step"
    ),
    "energy_work_uplift": _energy("work of the uplift forces and of the roof"),
    "energy_work_control": _energy("work of the controlled forces"),
    "energy_work_traction": _energy("work that moves the contact along the wire"),
    "energy_work_friction": _energy("work of the friction along the wire"),
    "energy_work_wind": _energy("work of the gusts on the wires"),
    "energy_residual": _energy("what the energy balance does not account for"),
    "dropper_force_min": Variable(
        ("dropper",), "N", "minimum dropper force, every step", channel="link_min"
    ),
    "dropper_force_max": Variable(
        ("dropper",), "N", "maximum dropper force, every step", channel="link_max"
    ),
    "support_uplift_max": Variable(
        ("support",), "m", "maximum uplift of the contact wire, every step", channel="uplift_max"
    ),
    "motion_up": Variable(
        _MOTION,
        "m",
        "displacement of the wires from rest, upwards, near the pantographs",
        single=True,
    ),
    "motion_across": Variable(
        _MOTION,
        "m",
        "displacement of the wires from rest, to the left, near the pantographs",
        single=True,
    ),
    "motion_first": Variable(
        ("motion_time", "motion_wire"),
        "1",
        "number of the first node of each wire in a row of motion, from 0",
        integer=True,
    ),
    "motion_count": Variable(
        ("motion_wire",), "1", "number of nodes of each wire in a row of motion", integer=True
    ),
    **{f"{wire}_node_lane": _lane(wire) for wire in WIRES},
    "motion_dropper_force": Variable(
        ("motion_time", "near_motion_dropper"),
        "N",
        "tension of the droppers near the pantographs; 0 is slack",
        single=True,
    ),
    "motion_dropper_first": Variable(
        ("motion_time",),
        "1",
        "place of the first of these droppers in motion_dropper_order, from 0",
        integer=True,
    ),
    "motion_dropper_order": Variable(
        ("dropper",), "1", "droppers along the track: index of each, from 0", integer=True
    ),
    "dropper_order": Variable(
        ("dropper",), "1", "droppers along the track: index of each, from 0", integer=True
    ),
    "support_order": Variable(
        ("support",), "1", "supports along the track: index of each, from 0", integer=True
    ),
    "dropper_x": Variable(("dropper",), "m", "position of the dropper along the track"),
    "dropper_span": Variable(("dropper",), "1", "span of the dropper, from 1", integer=True),
    "dropper_length": Variable(("dropper",), "m", "distance between the clamps at rest"),
    "dropper_top_z": Variable(("dropper",), "m", "height of the upper clamp above rail, at rest"),
    "dropper_bottom_z": Variable(
        ("dropper",), "m", "height of the lower clamp above rail, at rest"
    ),
    "dropper_force_static": Variable(("dropper",), "N", "dropper force at rest"),
    "support_x": Variable(("support",), "m", "position of the support along the track"),
    "support_force_static": Variable(
        ("support",), "N", "vertical force on the support; NaN where there is none", absent=True
    ),
    "steady_arm_force_static": Variable(
        ("support",), "N", "force of the steady arm at rest; NaN where there is none", absent=True
    ),
    "contact_wire_node_x": Variable(("contact_wire_node",), "m", "along the track, at rest"),
    "contact_wire_node_y": Variable(("contact_wire_node",), "m", "across the track, at rest"),
    "contact_wire_node_z": Variable(("contact_wire_node",), "m", "height above rail, at rest"),
    "contact_wire_node_wire": Variable(
        ("contact_wire_node",),
        "1",
        "which contact wire it is of, from 1; only where there are several",
        integer=True,
    ),
    "messenger_wire_node_x": Variable(("messenger_wire_node",), "m", "along the track, at rest"),
    "messenger_wire_node_y": Variable(("messenger_wire_node",), "m", "across the track, at rest"),
    "messenger_wire_node_z": Variable(("messenger_wire_node",), "m", "height above rail, at rest"),
    "messenger_wire_node_wire": Variable(
        ("messenger_wire_node",),
        "1",
        "tension length, from 1; only where there are several",
        integer=True,
    ),
    "auxiliary_wire_node_x": Variable(("auxiliary_wire_node",), "m", "along the track, at rest"),
    "auxiliary_wire_node_y": Variable(("auxiliary_wire_node",), "m", "across the track, at rest"),
    "auxiliary_wire_node_z": Variable(("auxiliary_wire_node",), "m", "height above rail, at rest"),
    "auxiliary_wire_node_wire": Variable(
        ("auxiliary_wire_node",),
        "1",
        "tension length, from 1; only where there are several",
        integer=True,
    ),
    "stitch_wire_node_x": Variable(("stitch_wire_node",), "m", "along the track, at rest"),
    "stitch_wire_node_y": Variable(("stitch_wire_node",), "m", "across the track, at rest"),
    "stitch_wire_node_z": Variable(("stitch_wire_node",), "m", "height above rail, at rest"),
    "stitch_wire_node_wire": Variable(
        ("stitch_wire_node",),
        "1",
        "tension length, from 1; only where there are several",
        integer=True,
    ),
    "stitch_wire_node_support": Variable(
        ("stitch_wire_node",), "1", "support of the stitch wire, from 1", integer=True
    ),
    "bridle_node_x": Variable(("bridle_node",), "m", "along the track, at rest"),
    "bridle_node_y": Variable(("bridle_node",), "m", "across the track, at rest"),
    "bridle_node_z": Variable(("bridle_node",), "m", "height above rail, at rest"),
    "bridle_node_wire": Variable(
        ("bridle_node",),
        "1",
        "tension length, from 1; only where there are several",
        integer=True,
    ),
    "bridle_node_support": Variable(
        ("bridle_node",), "1", "support of the bridle, from 1", integer=True
    ),
    "elasticity": Variable(("elasticity_x",), "m/N", "static elasticity of the contact wire"),
    "natural_frequency": Variable(("mode",), "Hz", "natural frequency of the line at rest"),
    "state": Variable(
        ("state_number",),
        "1",
        "what `arcless resume` continues from, SI; only if the run stopped early",
    ),
}

ATTRIBUTES: dict[str, Attribute] = {
    "format": Attribute("text", f"always `{RESULT_FORMAT}`", required=True),
    "arcless_version": Attribute("text", "version that computed the run", required=True),
    "created": Attribute("text", "when the dataset was built, ISO 8601, UTC", required=True),
    "scenario": Attribute("json", "the whole resolved scenario, with provenance", required=True),
    "as_typed": Attribute("json", "values of the scenario, its line and pantographs as typed"),
    "scenario_name": Attribute("text", "name of the scenario", required=True),
    "section_m": Attribute("json", "analysis section, [from, to]", required=True),
    "scheme": Attribute("text", "time-stepping scheme, also where the scenario says `auto`"),
    "why_matrix": Attribute("text", "why `auto` took a matrix; empty where it did not"),
    "time_step_s": Attribute("number", "time step, likewise"),
    "wire_model": Attribute("text", "wire model, likewise"),
    "contact_wire_element_m": Attribute("number", "longest element of the contact wire, likewise"),
    "messenger_wire_element_m": Attribute("number", "that of the messenger wire, likewise"),
    "wave_speed_m_s": Attribute(
        "number", "wave speed of the contact wire: as designed or, as built, the lowest"
    ),
    "steps": Attribute("integer", "number of time steps", required=True),
    "simulated_time_s": Attribute("number", "simulated time", required=True),
    "wall_time_s": Attribute("number", "wall time of the time-stepping loop alone", required=True),
    "setup_time_s": Attribute("number", "wall time of everything before the loop"),
    "real_time_factor": Attribute("number", "simulated time over wall time", required=True),
    "energy_residual_relative": Attribute("number", "largest ledger residual, relative"),
    "slack_droppers_max": Attribute("integer", "maximum number of slack droppers, every step"),
    "lcp_pivots_total": Attribute("integer", "pivots of the complementarity solver, all steps"),
    "lcp_pivots_max": Attribute("integer", "most pivots in one step"),
    "lcp_pivots_mean": Attribute("number", "pivots per step, mean of all steps"),
    "lcp_pivots_per_step": Attribute("json", "number of steps that took 0, 1, 2, … pivots"),
    "static_force_found": Attribute("json", "static force of each pantograph in N"),
    "stop_force_max": Attribute(
        "json", "maximum force on a bump stop of each pantograph that has any, in N"
    ),
    "controllers": Attribute(
        "json", "controllers given from Python, by the name of their pantograph"
    ),
    "fmus": Attribute(
        "json",
        "pantographs that are FMUs, by name: file and its SHA-256, version of FMI, and the largest"
        " difference of a height from what a step took for it, in m",
    ),
    "certainty": Attribute(
        "json", "numbers of the runs from other starts and by the other family of elements"
    ),
    "state": Attribute(
        "json", "where the run stopped, parts of the variable `state`, and fingerprints of its run"
    ),
    "warnings": Attribute("json", "warnings of the run, as sentences"),
    "command": Attribute("text", "command that runs this scenario again"),
}


def sizes_of(shapes: dict[str, tuple[int, ...]]) -> dict[str, int]:
    """Return the size of each dimension as the first variable that uses it has it."""
    sizes: dict[str, int] = {}
    for name, shape in shapes.items():
        for dim, size in zip(VARIABLES[name].dims, shape, strict=False):
            sizes.setdefault(dim, size)
    return sizes


def markdown_tables() -> str:
    """Return the tables of this module as Markdown, for the reference page."""
    rows: list[str] = ["| dimension | unit | meaning |", "|---|---|---|"]
    rows += [f"| `{n}` | {d.units} | {d.long_name} |" for n, d in DIMENSIONS.items()]
    rows += ["", "| variable | dimensions | unit | meaning |", "|---|---|---|---|"]
    rows += [_variable_row(name, variable) for name, variable in VARIABLES.items()]
    rows += ["", "| attribute | kind | meaning |", "|---|---|---|"]
    rows += [f"| {_mark(n, a)} | {a.kind} | {a.meaning} |" for n, a in ATTRIBUTES.items()]
    return "\n".join(rows) + "\n"


def _variable_row(name: str, variable: Variable) -> str:
    dims = ", ".join(variable.dims)
    return f"| {_mark(name, variable)} | {dims} | {variable.units} | {variable.long_name} |"


def _mark(name: str, entry: Any) -> str:
    return f"**`{name}`**" if entry.required else f"`{name}`"
