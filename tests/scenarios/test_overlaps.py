"""Statics of several tension lengths and of twin contact wires."""

from typing import Any

import numpy as np
import pytest

from arcless.cli.terminal.statics_tables import blocks
from arcless.equilibrium.equilibrium import Equilibrium, find, place_of
from arcless.model import load
from arcless.simulate import StaticsResult, statics
from arcless.simulate.recording import record
from tests.support.line_types import compound_data, scenario_data, stitched_data
from tests.support.overlaps import overlap_data, plain_data

TWIN = {"separation": 0.04}


def rest(line: dict[str, Any], **changes: Any) -> Equilibrium:
    return find(load(scenario_data(line, **changes)))


def tensions(found: Equilibrium) -> dict[str, float]:
    forces = found.of_droppers("link_tension")
    return {d.name: float(f) for d, f in zip(found.mesh.droppers, forces, strict=True)}


@pytest.mark.parametrize("model", ["hermite", "lumped"])
@pytest.mark.parametrize("shared", [3, 4, 5])
def test_overlaps_come_to_rest_and_are_their_own_mirror_image(shared: int, model: str) -> None:
    # Spans 1 to 4 + n and 5 to 8 + n: the line looks the same from its other end.
    line = overlap_data(shared, ends=(4 + shared,), spans=8 + shared)
    found = rest(line, solver__wire_model=model)
    force = tensions(found)
    assert min(force.values()) > 0.0
    for name, value in force.items():
        _, _, length, _, span, _, dropper = name.split()
        mirror = (
            f"tension length {3 - int(length)} span {9 + shared - int(span)}"
            f" dropper {7 - int(dropper)}"
        )
        # The balance is found to about 1e-8 N.
        assert force[mirror] == pytest.approx(value, abs=1e-6), name
    nodes = found.mesh.contact_wires
    first, second = (found.positions[wire] for wire in nodes)
    total = 60.0 * (8 + shared)
    # The same line seen from its other end: rounding of places of some 1e2 m.
    np.testing.assert_allclose(first[::-1, 2], second[:, 2], atol=1e-10)
    np.testing.assert_allclose(total - first[::-1, 0], second[:, 0], atol=1e-10)
    np.testing.assert_allclose(first[::-1, 1], -second[:, 1], atol=1e-10)


def test_what_happens_to_one_wire_of_an_overlap_leaves_the_other_alone() -> None:
    plain = tensions(rest(overlap_data()))
    name = "tension length 2 span 6 dropper 3"
    broken = tensions(rest(overlap_data(), as_built__missing_droppers=[name]))
    assert set(plain) - set(broken) == {name}
    # R of a line as built is that of its own tensions, of a designed one that of the drawing.
    moved = {own for own, force in broken.items() if abs(force - plain[own]) > 1e-2}
    assert {own.split(" span")[0] for own in moved} == {"tension length 2"}
    assert "tension length 2 span 6 dropper 2" in moved


def test_weather_and_wear_reach_all_wires() -> None:
    found = rest(
        overlap_data(contact_wire__ends="constant_force"),
        as_built__ice={"contact_wire": 1.0},
        as_built__contact_wire_wear=[{"from": 240.0, "to": 420.0, "fraction": 0.2}],
    )
    mass = found.arrays["wire_mass"]
    worn = [np.isclose(mass[lane], 1.1 * 0.8 + 1.0) for lane in found.mesh.lanes]
    # 180 m of either wire, in elements of 1.25 to 1.45 m.
    assert worn[0].sum() == worn[1].sum() > 180 / 1.45


def test_of_several_wires_the_travel_of_the_one_that_moves_furthest_is_told() -> None:
    ends = {f"{wire}_wire__ends": "constant_force" for wire in ("contact", "messenger")}
    line = overlap_data(ends=(8,), spans=11, **ends)
    contact, messenger = rest(line, as_built__temperature_difference=30.0).end_travel()
    # The longer has 8 spans of 60 m: 480 m · 30 K · 17e-6 = 245 mm. 2 % for the sag that changes.
    assert contact == pytest.approx(0.245, rel=0.02)
    assert messenger == pytest.approx(0.245, rel=0.02)


def test_places_are_named_with_their_tension_length() -> None:
    mesh = rest(overlap_data()).mesh
    second = mesh.systems[1]
    assert place_of(mesh, second.contact["contact wire"][0]) == (
        "contact wire of tension length 2 at 240.00 m"
    )
    assert place_of(mesh, second.messenger[-1]).startswith("messenger wire of tension length 2 at")
    alone = rest(plain_data(4, twin_contact_wires=TWIN)).mesh
    assert place_of(alone, alone.contact_wires[1][0]) == "contact wire 2 at 0.00 m"


def test_the_span_of_which_the_elasticity_is_told_is_in_no_overlap() -> None:
    assert rest(plain_data(11)).middle_span() == (300.0, 360.0)
    assert rest(overlap_data()).middle_span() == (180.0, 240.0)


def test_nodes_of_different_wires_are_told_apart() -> None:
    for line, wires in (
        (overlap_data(), 2),
        (plain_data(4, twin_contact_wires=TWIN), 2),
        (overlap_data(twin_contact_wires=TWIN), 4),
    ):
        found = rest(line)
        out = record.static_variables(found, np.zeros(1))
        which, x = out["contact_wire_node_wire"], out["contact_wire_node_x"]
        assert sorted(set(which)) == list(range(1, wires + 1))
        assert all(np.all(np.diff(x[which == one]) > 0.0) for one in set(which))
    assert set(record.static_variables(rest(overlap_data()), np.zeros(1))) >= {
        "messenger_wire_node_wire"
    }
    stitched = rest(overlap_data(stitch_wire=stitched_data()["stitch_wire"]))
    out = record.static_variables(stitched, np.zeros(1))
    owners = set(zip(out["stitch_wire_node_wire"], out["stitch_wire_node_support"], strict=True))
    assert len(owners) == len(stitched.mesh.stitches) == 12
    assert "contact_wire_node_wire" not in record.static_variables(rest(plain_data(4)), np.zeros(1))


@pytest.fixture(scope="module")
def found() -> StaticsResult:
    return statics(load(scenario_data(overlap_data())))


def test_statics_of_an_overlap_as_tables_and_data(found: StaticsResult) -> None:
    data = found.to_dict()
    assert data["middle_span"] == 4
    names = [support["name"] for support in data["supports"]]
    assert len(set(names)) == len(names) == 8 + 8
    tables = list(blocks("overlap", data))
    assert tables[0].title == "Droppers of span 4 of 11"
    # Where span 4 ends, the first tension length is held and the second one anchored.
    assert tables[1].row_count == 3
    stitched = scenario_data(overlap_data(stitch_wire=stitched_data()["stitch_wire"]))
    hung = statics(load(stitched)).to_dict()["stitch_wires"]
    assert hung[0]["support"] == "tension length 1 support 2"
    assert len({one["support"] for one in hung}) == len(hung)


@pytest.mark.parametrize("dimension", ["planar", "spatial"])
def test_paired_twins_hang_like_one_wire_of_twice_everything(dimension: str) -> None:
    double = {"mass": 2.2, "axial_stiffness": 28e6, "bending_stiffness": 260.0, "tension": 30e3}
    # So close that droppers hang upright.
    twin = rest(plain_data(6, twin_contact_wires={"separation": 1e-6}), solver__dimension=dimension)
    heavy = plain_data(6, contact_wire=double, steady_arm__vertical_stiffness=600.0)
    # A dropper is 100 kN/m and 0.1 kg/m.
    heavy["dropper"] = {"stiffness": 2e5, "mass": 0.2}
    one = rest(heavy, solver__dimension=dimension)
    single, paired = tensions(one), tensions(twin)
    for name, force in single.items():
        # The balance is found to about 1e-8 N.
        assert paired[f"{name} wire 1"] == pytest.approx(0.5 * force, abs=1e-6)
        assert paired[f"{name} wire 2"] == pytest.approx(0.5 * force, abs=1e-6)


def test_alternating_droppers_carry_both_wires() -> None:
    twin = {**TWIN, "droppers": "alternating"}
    found = rest(plain_data(6, twin_contact_wires=twin, dropper__mass=0.0))
    force = tensions(found)
    # In an inner span the droppers carry all but the arms: 2 · 1.1 kg/m · 60 m · 9.81 = 1295 N; the
    # springs of the arms do not act at rest.
    inner = sum(value for name, value in force.items() if name.startswith("span 3 "))
    assert inner == pytest.approx(2 * 1.1 * 60.0 * 9.81, rel=0.05)
    assert min(force.values()) > 0.0
    below = rest(compound_data(twin_contact_wires=twin))
    assert min(tensions(below).values()) > 0.0
