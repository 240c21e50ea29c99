"""Tables of the page modelling-choices: one choice of the model at a time, on two lines."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any
from unittest.mock import patch

from validation.runs import table
from validation.variants import WIRES, Changes

import arcless
from arcless.mesh.division import nodes
from arcless.results import Result

# By explicit steps with their own elements: what discretisation leaves is below what is shown.
STEPS: Changes = {
    "solver.scheme": "central-difference",
    "solver.contact_wire_element": "auto",
    "solver.messenger_wire_element": "auto",
}
REFERENCE, SIMPLE, IN_SPACE = (
    "en50318-2002-250",
    "en50318-ac-simple-275-planar",
    "en50318-ac-simple-275",
)
NO_HINGES = "without hinges"
SHOWN = {
    "mean_force_N": "Fm N",
    "std_force_N": "σ N",
    "max_force_N": "max N",
    "min_force_N": "min N",
    "contact_point_range_mm": "range mm",
    "max_uplift_at_support_mm": "uplift mm",
}


@contextmanager
def stiff_saddles() -> Iterator[None]:
    """Let messenger wires bend over their supports as if they were not hinged there."""
    plain = nodes.number

    def number(systems: Any, *, lumped: bool) -> Any:
        for system in systems:
            system.messenger.hinges = []
        return plain(systems, lumped=lumped)

    with patch.object(nodes, "number", number):
        yield


def numbers(name: str, changes: Changes) -> dict[str, float]:
    """Run a shipped scenario by explicit steps; no file can ask for `NO_HINGES`."""
    rest = {key: value for key, value in changes.items() if key != NO_HINGES}
    scenario = arcless.load(name).with_(**{**STEPS, **rest})
    print(f"{name} {changes}", flush=True)

    def made() -> Result:
        return arcless.run(scenario)

    if NO_HINGES in changes:
        with stiff_saddles():
            found = made().assessment.to_dict()
    else:
        found = made().assessment.to_dict()
    return {**found, **found["pantographs"][0]}


def ends(kind: str) -> Changes:
    """What holds the ends of both wires."""
    return {f"line.{wire}.ends": kind for wire in WIRES}


def axial(name: str, factor: float) -> Changes:
    """Multiply the axial stiffness of both wires."""
    line = arcless.load(name).line
    return {
        f"line.{wire}.axial_stiffness": factor * getattr(line, wire).axial_stiffness
        for wire in WIRES
    }


def per_stretched_metre(name: str) -> Changes:
    """Masses as if they were given per metre of the wire under its tension."""
    line = arcless.load(name).line
    wires = {wire: getattr(line, wire) for wire in WIRES}
    return {
        f"line.{wire}.mass": of.mass * (1.0 + of.tension / of.axial_stiffness)
        for wire, of in wires.items()
    }


def along_table(name: str) -> str:
    """What moves along the track, and what follows from unstretched lengths and hinges."""
    supports = arcless.load(name).line.support.longitudinal_stiffness
    weights = ends("constant_force")
    other = ("free", 0.0) if supports else ("held by 1e6 N/m", 1e6)
    variants: list[tuple[str, Changes]] = [
        ("**as shipped**", {}),
        ("`motion: across`", {"solver.motion": "across"}),
        (
            f"messenger supports {other[0]} along the track",
            {"line.support.longitudinal_stiffness": other[1]},
        ),
        ("`axial_stiffness` halved", axial(name, 0.5)),
        ("`axial_stiffness` doubled", axial(name, 2.0)),
        ("`ends: constant_force`: the far end", weights),
        (
            "the same with a midpoint anchor of 1 MN/m: both ends",
            {**weights, "line.midpoint_anchor": {"stiffness": 1e6}},
        ),
        ("mass per stretched metre", per_stretched_metre(name)),
        ("messenger wire not hinged at supports", {NO_HINGES: True}),
    ]
    rows = []
    for title, changes in variants:
        found = numbers(name, changes)
        rows.append((title, *(f"{found[key]:.1f}" for key in SHOWN)))
    return table(("choice", *SHOWN.values()), rows)


def arms_table() -> str:
    """What a steady arm does upright: its own stiffness, and that of its pull."""
    stiffness = "line.steady_arm.vertical_stiffness"
    held = {"line.steady_arm": {"kind": "spring", "vertical_stiffness": 0.0}}
    variants: list[tuple[str, str, Changes]] = [
        ("in space, hinged arm with its pull, as shipped", IN_SPACE, {}),
        ("in space, no arm but the stagger held", IN_SPACE, held),
        ("planar, a spring of 2673.58 N/m, as shipped", SIMPLE, {}),
        ("planar, a spring of 267 N/m: pull over length", SIMPLE, {stiffness: 267.0}),
        ("planar, no spring", SIMPLE, {stiffness: 0.0}),
    ]
    rows = []
    for title, name, changes in variants:
        found = numbers(name, changes)
        scenario = arcless.load(name).with_(**{**STEPS, **changes})
        at_support = 1e3 * arcless.statics(scenario).elasticity_m_per_N[0]
        rows.append((title, f"{at_support:.3f}", *(f"{found[key]:.1f}" for key in SHOWN)))
    return table(("arm", "elasticity mm/N", *SHOWN.values()), rows)


TABLES = {
    "reference": lambda: along_table(REFERENCE),
    "simple": lambda: along_table(SIMPLE),
    "arms": arms_table,
}
