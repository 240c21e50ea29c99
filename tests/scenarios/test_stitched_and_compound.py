"""Stitched and compound lines: drawn, as built, in motion, and what cannot be drawn."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import arcless
from arcless import report
from arcless.errors import EquilibriumError
from arcless.model import load
from arcless.simulate import StaticsResult
from tests.support.line_types import compound_data, scenario_data, stitched_data

STAGGER = {
    "geometry__stagger_contact_wire": [0.3, -0.3],
    "geometry__stagger_messenger_wire": [0.1, -0.1],
}


def at_rest(line: dict[str, Any], **changes: Any) -> StaticsResult:
    return arcless.statics(load(scenario_data(line, **changes)))


@pytest.mark.parametrize("model", ["hermite", "lumped"])
@pytest.mark.parametrize("stagger", [{}, STAGGER], ids=["straight", "staggered"])
@pytest.mark.parametrize("data", [stitched_data, compound_data], ids=["stitched", "compound"])
def test_wires_are_where_they_were_drawn(data: Any, stagger: dict[str, Any], model: str) -> None:
    drawn = data(**stagger)
    found = at_rest(drawn, solver__wire_model=model).equilibrium
    height = {"contact wire": 5.3, "auxiliary wire": 5.3 + 0.3}
    lower = [found.positions[d.nodes[1], 2] for d in found.mesh.droppers]
    expected = [height[d.wires[1]] for d in found.mesh.droppers]
    # In service, with all lengths kept: far below a millimetre, the equilibrium is exact.
    np.testing.assert_allclose(lower, expected, atol=1e-7)
    assert found.of_droppers("link_tension").min() > 0.0


def test_lengths_that_were_found_give_the_same_line_as_built() -> None:
    for data in (stitched_data, compound_data):
        design = at_rest(data())
        changes: dict[str, Any] = {}
        for name, word in (("droppers", "dropper"), ("hangers", "hanger")):
            rest = [
                d["unstretched_length_m"]
                for d in design.droppers
                if d["span"] == 3 and f" {word} " in d["name"]
            ]
            if rest:
                changes[f"span_types__span__{name}__lengths"] = rest
        built = at_rest(data(spans=[{"type": "span", "count": 6}], **changes))
        pairs = [
            (a["force_N"], b["force_N"])
            for a, b in zip(design.droppers, built.droppers, strict=True)
            if a["span"] == 3
        ]
        # Spans 1 and 6, which end at an anchor, got the lengths of span 3: two spans away they
        # change the forces of span 3 by less than this.
        assert all(abs(a - b) < 3.0 for a, b in pairs)


def test_both_wire_models_find_the_same_droppers() -> None:
    fine = {"solver__contact_wire_element": 0.5, "solver__messenger_wire_element": 0.5}
    for data in (stitched_data, compound_data):
        one, two = (at_rest(data(), **fine, solver__wire_model=m) for m in ("hermite", "lumped"))
        lengths = [[d["length_m"] for d in found.droppers] for found in (one, two)]
        # 1.6 mm at 0.25 m in a simple line (docs/theory/wires.md) where messenger wires bend most.
        np.testing.assert_allclose(*lengths, atol=4e-3)


def test_a_hanger_that_would_have_to_push_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    high = [0, -0.08, *[0] * 8]
    with pytest.raises(EquilibriumError) as caught:
        at_rest(compound_data(span_types__span__hangers__presag=high))
    assert "hanger" in str(caught.value)
    assert "would have to push to hold the contact wire at its height" in str(caught.value)
    low = [0, 0, -0.2, 0, 0]
    with pytest.raises(EquilibriumError) as caught:
        at_rest(compound_data(span_types__span__droppers__presag=low))
    assert "would have to push to hold the" in str(caught.value)


@pytest.mark.parametrize("model", ["hermite", "lumped"])
@pytest.mark.parametrize("data", [stitched_data, compound_data], ids=["stitched", "compound"])
def test_a_pantograph_runs_below(data: Any, model: str) -> None:
    result = arcless.run(load(scenario_data(data(), solver__wire_model=model)))
    force = result.dataset["contact_force"].values
    # The masses of the pantograph move freely: the mean is the static force but for the base.
    assert force.mean() == pytest.approx(120.0, rel=0.05)
    html = report.html(result)
    if "stitch_wire" in data():
        owner = result.dataset["stitch_wire_node_support"].values
        assert np.unique(owner).tolist() == [2, 3, 4, 5, 6]
        assert "auxiliary_wire_node" not in result.dataset.dims
        assert "stitch wires" in html
    else:
        height = result.dataset["auxiliary_wire_node_z"].values
        assert abs(height - 5.6).max() < 0.05
        assert "stitch_wire_node" not in result.dataset.dims
        assert "auxiliary wire" in html
    top, bottom = (result.dataset[f"dropper_{end}_z"].values for end in ("top", "bottom"))
    # Rounding of a difference of heights: droppers of a planar line hang upright.
    np.testing.assert_allclose(top - bottom, result.dataset["dropper_length"].values, atol=1e-12)


@pytest.mark.parametrize("data", [stitched_data, compound_data], ids=["stitched", "compound"])
def test_the_energy_ledger_closes(data: Any) -> None:
    settings = {"solver__scheme": "trapezoidal", "output__energy": "always"}
    result = arcless.run(load(scenario_data(data(), **settings)))
    # Rounding; as for simple lines.
    assert abs(result.dataset.attrs["energy_residual_relative"]) < 1e-9
