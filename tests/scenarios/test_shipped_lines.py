"""Every shipped line comes to rest from a cold start and carries a pantograph."""

from typing import Any

import numpy as np
import pytest

from arcless.model import Line, Scenario, load, load_line, load_pantograph
from arcless.model.shipped.library import shipped
from arcless.simulate import StaticsResult, run, statics

SPANS = 6


def shortened(line: Line) -> dict[str, Any]:
    """Return a line of some spans, where it is longer than that."""
    spans = [{"type": line.spans[0].type, "count": min(SPANS, len(line.span_list()))}]
    if line.has_overlaps:  # in the middle, where the pantograph is to go
        spans = line.to_dict()["spans"]
    return {**line.to_dict(), "spans": spans}


def scenario(line: Line, pantograph: str = "dsa-250") -> Scenario:
    """A slow run over the middle of a line, shortened where a line is longer than that."""
    data = {
        "name": line.name,
        "line": shortened(line),
        "pantographs": [{"model": pantograph, "static_force": 80.0}],
        "speed": "100 km/h",
        "solver": {"contact_wire_element": 1.0, "messenger_wire_element": 2.0},
    }
    short = load(data)
    length = short.line.total_length
    return short.with_(travel={"start": 0.3 * length, "end": 0.6 * length})


@pytest.fixture(scope="module", params=shipped("line"))
def rest(request: pytest.FixtureRequest) -> StaticsResult:
    line = shortened(load_line(request.param))
    return statics(load({"name": "rest", "line": line, "speed": 30.0,
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
