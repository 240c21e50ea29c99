"""Sag and stress of the wires at rest, against closed forms."""

import numpy as np
import pytest

import arcless
from arcless.model.line.wire_section import WireSection
from arcless.simulate import StaticsResult

PLANAR = "en50318-ac-simple-320-planar"


@pytest.fixture(scope="module")
def planar() -> StaticsResult:
    return arcless.statics(arcless.load(PLANAR).with_(**{"solver.scheme": "generalised-alpha"}))


def test_the_sag_is_the_moment_of_a_simple_beam_over_the_tension(planar: StaticsResult) -> None:
    """H f(x) = M(x) under the weight of the messenger wire and the forces of its droppers."""
    line, span = planar.scenario.line, planar.spans[9]
    assert span["span"] == 10
    left, right = span["from_m"], span["to_m"]
    length, weight = right - left, line.messenger_wire.mass * 9.81
    droppers = [one for one in planar.droppers if one["span"] == 10]
    # Half of a dropper's mass and its clamp hang on the messenger wire besides its tension.
    extra = 9.81 * line.dropper.clamp_mass_messenger_wire
    x = np.linspace(0.0, length, 2001)
    moment = 0.5 * weight * x * (length - x)
    for one in droppers:
        at = one["x_m"] - left
        force = one["force_N"] + extra + 0.5 * 9.81 * line.dropper.mass * one["length_m"]
        moment += force * np.minimum(x * (length - at), at * (length - x)) / length
    # Bending, and the tension along a wire that is not horizontal, are some parts in a thousand.
    expected = moment.max() / line.messenger_wire.tension
    assert span["messenger_wire_sag_below_chord_m"] == pytest.approx(expected, rel=4e-3)
    lowest = span["messenger_wire_lowest_m"]
    held = line.geometry.contact_wire_height + line.geometry.encumbrance
    assert held - lowest == pytest.approx(expected, rel=4e-3)


def test_the_loads_of_the_supports_are_the_weight(planar: StaticsResult) -> None:
    line, spans = planar.scenario.line, planar.spans
    length = spans[9]["to_m"] - spans[9]["from_m"]
    droppers = [one for one in planar.droppers if one["span"] == 10]
    clamps = line.dropper.clamp_mass_contact_wire + line.dropper.clamp_mass_messenger_wire
    hung = sum(clamps + line.dropper.mass * one["length_m"] for one in droppers)
    moving = line.support.mass + line.steady_arm.mass
    wires = sum(
        wire.mass * length / (1.0 + wire.tension / wire.axial_stiffness)
        for wire in (line.contact_wire, line.messenger_wire)
    )
    inner = [one for one in planar.supports if one["x_m"] == spans[9]["from_m"]]
    # The weight of a span hangs on each; stretched wires have less mass per metre. The messenger
    # wire is longer than the span by 8 f²/(3 L²), 1e-4, and a little unlike its neighbours.
    assert inner[0]["messenger_force_N"] == pytest.approx(9.81 * (wires + hung + moving), rel=3e-4)


def test_every_span_has_its_row(planar: StaticsResult) -> None:
    assert [one["span"] for one in planar.spans] == list(range(1, 21))
    assert {one["tension_length"] for one in planar.spans} == {""}
    middle = planar.spans[planar.middle_span - 1]
    assert middle["contact_wire_highest_m"] - middle["contact_wire_lowest_m"] == pytest.approx(
        planar.contact_wire_sag_m
    )


def test_the_two_sags_have_names_of_their_own() -> None:
    """Droppers of this line raise the middle of a span above its supports: the numbers differ."""
    found = arcless.statics(arcless.load("spain-ca-220-220")).to_dict()
    middle = found["spans"][found["middle_span"] - 1]
    assert "contact_wire_sag_m" not in middle
    spread = middle["contact_wire_highest_m"] - middle["contact_wire_lowest_m"]
    assert found["contact_wire_sag_m"] == pytest.approx(spread)
    assert 0.0 < middle["contact_wire_sag_below_chord_m"] < spread


def test_an_overlap_has_rows_of_both_tension_lengths() -> None:
    found = arcless.statics(arcless.load("ac-simple-overlap-275"))
    rows = found.spans
    twice = {one["span"] for one in rows if sum(o["span"] == one["span"] for o in rows) == 2}
    assert twice
    assert all(one["tension_length"] for one in rows)


def test_the_stress_is_the_tension_over_the_area(planar: StaticsResult) -> None:
    found = {one["wire"]: one for one in planar.wires}
    assert list(found) == ["contact_wire", "messenger_wire"]
    for name, one in found.items():
        wire = getattr(planar.scenario.line, name)
        section = WireSection.of(wire)
        assert section is not None
        # The tension along the wire exceeds the horizontal one by its slope, 1e-3.
        stress = 1e-6 * wire.tension / section.area
        assert one["stress_mean_MPa"] == pytest.approx(stress, rel=1e-3)
        assert one["stress_min_MPa"] <= one["stress_mean_MPa"] <= one["stress_max_MPa"]


def test_a_rail_has_no_stress_of_a_wire() -> None:
    found = arcless.statics(arcless.load("conductor-rail-1-120"))
    assert [one["stress_mean_MPa"] for one in found.wires] == [None]
    assert found.spans[0]["messenger_wire_sag_below_chord_m"] is None
