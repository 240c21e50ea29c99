"""The geometry of lines at rest: from an equilibrium, and from the result of a run."""

import json
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.equilibrium import equilibrium
from arcless.studio.at_rest.of_equilibrium import geometry_at_rest
from arcless.studio.at_rest.of_run import geometry_of_run

# A line in the plane, one in space with hinged arms, two tension lengths, stitch wires, bridles.
LINES = (
    "en50318-ac-simple-320-planar",
    "en50318-ac-simple-320",
    "ac-simple-overlap-275",
    "norway-s25-250",
    "trolley-bridles-60",
)
# Coordinates are given to the micrometre.
COORDINATE = 1e-6
# Arms come from the design and turn a little with the line that they hold: 0.02 degrees of 1.2 m.
ARM = 1e-3


def at_rest(name: str) -> tuple[equilibrium.Equilibrium, Any]:
    scenario = arcless.load(name)
    found = equilibrium.find(scenario)
    return found, geometry_at_rest(found, scenario.line)


def node_of(geometry: Any, wire: int, node: int) -> list[float]:
    return [geometry["wires"][wire][axis][node] for axis in "xyz"]


@pytest.mark.parametrize("name", LINES)
def test_droppers_end_at_the_nodes_of_wires_that_they_name(name: str) -> None:
    found, geometry = at_rest(name)
    assert len(geometry["droppers"]) == len(found.mesh.droppers)
    for dropper in geometry["droppers"]:
        assert node_of(geometry, dropper["wire"], dropper["node"]) == dropper["bottom"]
        assert node_of(geometry, dropper["top_wire"], dropper["top_node"]) == dropper["top"]
        apart = np.linalg.norm(np.subtract(dropper["top"], dropper["bottom"]))
        # The rounding of two points.
        assert apart == pytest.approx(dropper["length_m"], abs=2 * COORDINATE)


@pytest.mark.parametrize("name", LINES)
def test_a_run_has_the_same_line_as_its_scenario_at_rest(name: str) -> None:
    _, expected = at_rest(name)
    found: Any = geometry_of_run(arcless.run(arcless.load(name), until="0.2 s"))
    for key in ("name", "spatial", "height_m", "spans", "wires", "droppers"):
        assert found[key] == expected[key], key
    for one, other in zip(found["supports"], expected["supports"], strict=True):
        assert {**one, "arms": []} == {**other, "arms": []}
        assert len(one["arms"]) == len(other["arms"])
        for arm, known in zip(one["arms"], other["arms"], strict=True):
            assert arm["from"] == known["from"]
            np.testing.assert_allclose(arm["to"], known["to"], atol=ARM)


def test_wires_count_the_nodes_of_their_kind_in_the_result() -> None:
    result = arcless.run(arcless.load("norway-s25-250"), until="0.2 s")
    geometry = geometry_of_run(result)
    heights = result.dataset["stitch_wire_node_z"].values
    stitches = [wire for wire in geometry["wires"] if wire["kind"] == "stitch"]
    assert len(stitches) > 1
    for wire in stitches:
        own = heights[wire["first"] : wire["first"] + len(wire["z"])]
        np.testing.assert_allclose(wire["z"], own, atol=COORDINATE)
    assert stitches[0]["name"] == "stitch wire at support 2"


def test_a_hinged_arm_leads_from_the_wire_to_the_side_that_it_pulls_to() -> None:
    _, geometry = at_rest("en50318-ac-simple-320")
    inner = geometry["supports"][1:-1]
    for support in inner:
        (arm,) = support["arms"]
        assert arm["from"] == node_of(geometry, support["wire"], support["node"])
        # An arm pulls the wire outwards, to the side of its stagger.
        assert np.sign(arm["to"][1] - arm["from"][1]) == np.sign(support["stagger_m"])
        assert np.linalg.norm(np.subtract(arm["to"], arm["from"])) == pytest.approx(1.22, abs=ARM)
    assert geometry["supports"][0]["arms"] == []


def test_a_geometry_is_plain_data() -> None:
    _, geometry = at_rest("ac-simple-overlap-275")
    assert json.loads(json.dumps(geometry, allow_nan=False)) == geometry
    assert [wire["name"] for wire in geometry["wires"][:2]] == ["contact wire 1", "contact wire 2"]
    starts = [span["start_m"] for span in geometry["spans"]]
    assert starts[1:] == [span["end_m"] for span in geometry["spans"]][:-1]
