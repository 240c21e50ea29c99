"""Every shipped line comes to rest from a cold start and carries a pantograph."""

import math

import numpy as np
import pytest

from arcless.model import Line, Scenario, load, load_line, load_pantograph
from arcless.model.library import shipped
from arcless.simulate import StaticsResult, run, statics

SPANS = 6


def scenario(line: Line, pantograph: str = "dsa-250") -> Scenario:
    """A slow run over the middle of a line, shortened where a line is longer than that."""
    spans = [{"type": line.spans[0].type, "count": min(SPANS, len(line.span_list()))}]
    if line.has_overlaps:  # in the middle, where the pantograph is to go
        spans = line.to_dict()["spans"]
    data = {
        "name": line.name,
        "line": {**line.to_dict(), "spans": spans},
        "pantographs": [{"model": pantograph, "static_force": 80.0}],
        "speed": "100 km/h",
        "solver": {"contact_wire_element": 1.0, "messenger_wire_element": 2.0},
    }
    short = load(data)
    length = short.line.total_length
    return short.with_(travel={"start": 0.3 * length, "end": 0.6 * length})


@pytest.fixture(scope="module", params=shipped("line"))
def rest(request: pytest.FixtureRequest) -> StaticsResult:
    line = load_line(request.param)
    return statics(load({"name": "rest", "line": line.to_dict(), "speed": 30.0,
                         "pantographs": [{"model": "dsa-250", "static_force": 70.0}]}))  # fmt: skip


def test_droppers_pull_and_the_wire_is_where_it_was_designed(rest: StaticsResult) -> None:
    line = rest.scenario.line
    assert all(dropper["force_N"] > 0 for dropper in rest.droppers)
    assert all(dropper["length_m"] > 0.2 for dropper in rest.droppers)
    wires = [rest.equilibrium.positions[nodes] for nodes in rest.equilibrium.mesh.contact_wires]
    span, start = line.span_list()[1], line.support_positions()[1]
    for x, presag in zip(span.holders.positions, span.holders.design_presag, strict=True):
        # Of two wires side by side one hangs on the dropper, and the other one sags beside it.
        height = max(
            np.interp(start + x, points[:, 0], points[:, 2])
            for points in wires
            if points[0, 0] < start + x < points[-1, 0]
        )
        # The design asks for this height; 1 mm for the sag between nodes half an element away.
        assert height == pytest.approx(line.geometry.contact_wire_height - presag, abs=1e-3)


def test_supports_carry_the_weight_of_what_is_between_them(rest: StaticsResult) -> None:
    """Forces at an inner support against the weight of one span, counted from the model's data."""
    line = rest.scenario.line
    span = line.span_list()[0]
    wires = [line.contact_wire, line.messenger_wire, line.auxiliary_wire]
    if line.twin_contact_wires is not None:
        wires.append(line.contact_wire)
    weight = sum(wire.mass for wire in wires if wire is not None) * span.length
    if line.stitch_wire is not None:
        weight += line.stitch_wire.mass * line.stitch_wire.length + 2 * line.stitch_wire.clamp_mass
    if line.bridle is not None:
        weight += line.bridle.mass * line.bridle.length + 2 * line.bridle.clamp_mass
    if line.contact_support is not None:
        weight += line.contact_support.mass
    if line.contact_wire.joints is not None:
        weight += line.contact_wire.joints.mass * span.length / line.contact_wire.joints.spacing
    for dropper in rest.droppers:
        if dropper["span"] == 3:
            kind = line.hanger if "hanger" in dropper["name"] and line.hanger else line.dropper
            weight += kind.mass * dropper["length_m"]
            weight += kind.clamp_mass_contact_wire + kind.clamp_mass_messenger_wire
    # The fifth support, or the middle one of a short line: of twin wires with an arm for each.
    places = rest.equilibrium.support_places()
    place = places[min(4, len(places) // 2)]
    inner = [support for support in rest.supports if support["x_m"] == place]
    if line.messenger_wire is None:
        # A joint hangs on one support or the other: what they carry on average.
        forces = [support["contact_support_force_N"] for support in rest.supports[4:-4]]
        carried = abs(float(np.mean(forces)))
    else:
        held = sum(_held_by_the_arm(rest, support) for support in inner)
        carried = abs(inner[0]["messenger_force_N"]) + held
    # 2 %: the arm's own mass (0.9 kg of some 100 kg) and, where the arm is a spring, its share.
    assert carried == pytest.approx(9.81 * weight, rel=0.02)


def _held_by_the_arm(rest: StaticsResult, support: dict[str, float]) -> float:
    """Upward force in N of a hinged arm, whose tension has a vertical part; a spring rests at 0."""
    arm = rest.scenario.line.steady_arm
    if arm.kind != "arm":
        return 0.0
    return float(support["steady_arm_force_N"]) * math.sin(arm.slope)


@pytest.mark.parametrize("name", shipped("line"))
def test_a_pantograph_stays_in_contact_at_low_speed(name: str) -> None:
    found = run(scenario(load_line(name)))
    force = found.dataset["contact_force"].values[:, 0]
    assert np.isfinite(force).all()
    assert force.min() > 0.0  # at 100 km/h nothing may bounce off
    # Without lift the mean force is the static one, less what the base spring (80 N/m) loses over
    # some centimetres of uplift, and the work of lifting hardly counts at this speed.
    assert force.mean() == pytest.approx(80.0, rel=0.1)


@pytest.mark.parametrize("name", shipped("pantograph"))
def test_a_pantograph_of_the_library_runs_on_a_line(name: str) -> None:
    found = run(scenario(load_line("norway-s20a"), name))
    force = found.dataset["contact_force"].values[:, 0]
    assert np.isfinite(force).all()
    lift = load_pantograph(name).masses[1].lift
    # A lift table adds to the static force: 0.00095 v² + 0.0017 v - 0.2 = 9.5 N at 100 km/h.
    extra = 9.5 if lift is not None else 0.0
    tolerance = 0.6 if name == "tsg-18f" else 0.12  # its base spring takes 41 N per mm of uplift
    assert force.mean() == pytest.approx(80.0 + extra, rel=tolerance)
