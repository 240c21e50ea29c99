"""Stress of a passage whose forces are known, and lines that are refused."""

from typing import Any

import numpy as np
import pytest

import arcless
from arcless.assess.wire_stress.tables import by_range
from arcless.errors import ModelError
from arcless.results import Result
from tests.support.synthetic import scenario_data, synthetic_dataset

SPATIAL = "en50318-ac-simple-320"


def drawn(**changes: Any) -> Result:
    """A force of 100 N at 20 m/s; droppers carry 50 N less a bell of 60 N, none below 0."""
    data = scenario_data(**changes)
    return Result(synthetic_dataset(scenario=data), arcless.load(data))


def test_clamps_of_a_drawn_passage() -> None:
    result = drawn()
    found = result.wire_stress(exponent=5.0)
    wire, per_newton = found.wire, found.wire.stress_per_newton()
    axial = wire.axial_stress
    assert axial == pytest.approx(10e3 / (4e-5 * np.pi))  # A = 4π · 100/10⁷
    inside = [one for one in found.places if 210.0 < one.x_m < 390.0]
    assert found.section_m == (150.0, 450.0) and len(found.places) == 30
    assert len(inside) == 18
    for one in inside:
        assert one.fibre == "top"
        assert 1e6 * one.at_rest_MPa == pytest.approx(axial + 50.0 * per_newton)
        # Below the pantograph the dropper is slack and the strip alone bends the wire.
        strip = 100.0 * wire.stress_per_newton(20.0)
        assert 1e6 * one.max_MPa == pytest.approx(axial + max(50.0 * per_newton, strip), rel=1e-9)
        # Away from both by more than three layers it is slack, or nearly: 60 N of the bell.
        assert 1e6 * one.min_MPa == pytest.approx(axial, abs=4.0 * per_newton)
        assert one.equivalent_range_MPa is not None
        assert one.equivalent_range_MPa >= one.largest_range_MPa * 0.5**0.2
    assert found.worst.largest_range_MPa == max(one.largest_range_MPa for one in found.places)


def test_the_instant_of_the_passage_is_among_the_rows() -> None:
    """Rows 0.1 s apart are 2 m of travel: without that instant the strip would be missed."""
    coarse = Result(
        synthetic_dataset(scenario=scenario_data(), line_every=100), arcless.load(scenario_data())
    )
    fine = drawn().wire_stress()
    for one, other in zip(coarse.wire_stress().places, fine.places, strict=True):
        assert one.max_MPa == pytest.approx(other.max_MPa, rel=2e-3)


def test_texts_with_units_are_amounts() -> None:
    result = drawn()
    found = result.wire_stress(area="120 mm²", tension="18 kN", exponent="5")
    assert found == result.wire_stress(area=120e-6, tension=18e3, exponent=5.0)


@pytest.mark.parametrize(
    ("asked", "words"),
    [
        ({"exponent": "five"}, 'exponent of the Wöhler line: got "five", expected a number'),
        ({"exponent": [5]}, "exponent of the Wöhler line: got a list of 1"),
        ({"tension": "18 kg"}, "tension: wrong value.*expected a force"),
        ({"area": "120 mm"}, "area: wrong value.*mm is the unit of a length"),
        ({"area": []}, "area: wrong value: got a list of 0"),
    ],
)
def test_amounts_that_are_none_are_refused(asked: dict[str, Any], words: str) -> None:
    with pytest.raises(ModelError, match=words):
        drawn().wire_stress(**asked)


@pytest.mark.parametrize(
    ("area", "modulus", "is_told"),
    # EA is 10 MN: E = EA/A on both sides of 90 and 135 GPa.
    [("111 mm2", 90.1, False), ("112 mm2", 89.3, True),
     ("75 mm2", 133.3, False), ("74 mm2", 135.1, True)],
)  # fmt: skip
def test_a_modulus_that_is_none_of_copper_is_told(area: str, modulus: float, is_told: bool) -> None:
    found = drawn().wire_stress(area=area)
    assert 1e-9 * found.wire.section.modulus == pytest.approx(modulus, abs=0.05)
    assert bool(found.notes) is is_told
    assert found.to_dict()["notes"] == found.notes
    for note in found.notes:
        assert f"{modulus:.1f} GPa" in note and "90 to 135 GPa (assumed)" in note


def test_places_are_in_the_order_of_what_is_asked_for() -> None:
    result = drawn()
    for exponent, key in ((None, "largest_range_MPa"), (5.0, "equivalent_range_MPa")):
        found = result.wire_stress(exponent=exponent)
        ordered = by_range(found.to_dict())
        ranges = [one[key] for one in ordered]
        assert ranges == sorted(ranges, reverse=True) and len(ranges) == len(found.places)
        assert found.worst.name == ordered[0]["name"]


@pytest.mark.parametrize("exponent", [None, 5.0])
def test_a_data_frame_has_all_places(exponent: float | None) -> None:
    found = drawn().wire_stress(exponent=exponent)
    table = found.to_dataframe()
    assert len(table) == len(found.places)
    assert table["place"].tolist() == [one.name for one in found.places]
    assert table["largest range [MPa]"].tolist() == [one.largest_range_MPa for one in found.places]
    assert ("equivalent range S_eq [MPa]" in table) is (exponent is not None)
    assert table.attrs["units"]["position [m]"] == "m"


def test_numbers_for_json() -> None:
    told = drawn().wire_stress(area=1.5e-4, tension=12e3).to_dict()
    assert (told["area_mm2"], told["area_from"]) == (pytest.approx(150.0), "stated")
    assert told["axial_stress_MPa"] == pytest.approx(80.0)
    assert told["exponent"] is None
    assert told["places"][0]["equivalent_range_MPa"] is None


@pytest.fixture(scope="module")
def staggered() -> Result:
    scenario = arcless.load(SPATIAL).with_(
        **{
            "line.spans": [{"type": "standard", "count": 8}],
            "travel": {"start": "60 m", "end": "380 m"},
            "analysis": {"from": "110 m", "to": "330 m"},
        }
    )
    return arcless.run(scenario)


def test_steady_arms_bend_the_wire_towards_themselves(staggered: Result) -> None:
    found = staggered.wire_stress()
    arms = [one for one in found.places if one.name.startswith("support")]
    assert [one.fibre for one in arms[:2]] == ["top", "arm"]
    per_newton, axial = found.wire.stress_per_newton(), found.wire.axial_stress
    force = float(staggered.dataset["steady_arm_force_static"][4])
    # 22 kN · 4 · 0.2 m/55 m = 320 N: the arm's horizontal part, at its slope of 10°.
    assert force * np.cos(np.radians(10.0)) == pytest.approx(320.0, rel=0.01)
    side = next(one for one in arms if one.name == "support 5" and one.fibre == "arm")
    assert 1e6 * side.at_rest_MPa == pytest.approx(axial + per_newton * force)
    assert side.min_MPa < side.at_rest_MPa < side.max_MPa


def test_elements_of_half_the_length_change_little(staggered: Result) -> None:
    fine = arcless.run(
        staggered.scenario.with_(**{"solver.contact_wire_element": "0.225 m"})
    ).wire_stress()
    ranges = [
        np.array([one.largest_range_MPa for one in found.places])
        for found in (staggered.wire_stress(), fine)
    ]
    # Forces of droppers converge to 1 % of their change; the curvature of a mesh would by 30 %.
    assert np.median(np.abs(ranges[1] / ranges[0] - 1.0)) < 0.03


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"as_built": {"temperature_difference": 20.0}}, "a line as built"),
        ({"line__contact_wire__bending_stiffness": 0.0}, "EI = 0 N m²"),
    ],
)
def test_what_cannot_be_known_is_refused(changes: dict[str, Any], words: str) -> None:
    with pytest.raises(ModelError, match=words):
        drawn(**changes).wire_stress()


def test_a_run_without_forces_is_refused(staggered: Result) -> None:
    bare = staggered.dataset.drop_vars(["dropper_force", "steady_arm_force"])
    with pytest.raises(ModelError, match="no force of a dropper"):
        Result(bare, staggered.scenario).wire_stress()


def test_a_run_that_stopped_early_is_refused() -> None:
    scenario = arcless.load(SPATIAL + "-planar")
    part = arcless.run(scenario, until="500 ft")
    assert not part.is_complete
    with pytest.raises(ModelError, match=r"run that stopped early.*`arcless resume RUN`"):
        part.wire_stress()


@pytest.mark.parametrize(
    ("section", "words"),
    [
        # The second pantograph runs from −100 to 500 m, the first from 0 to 600 m.
        ({"from": "150 m", "to": "560 m"}, r"pantograph P2 ran over -100\.0 to 500\.0 m"),
        ({"from": "150 m", "to": "480 m"}, None),
    ],
)
def test_a_section_that_was_not_wholly_passed_is_refused(
    section: dict[str, str], words: str | None
) -> None:
    data = scenario_data(analysis=section)
    result = Result(synthetic_dataset(scenario=data, pantographs=("P1", "P2")), arcless.load(data))
    if words is None:
        assert result.wire_stress().places
        return
    with pytest.raises(ModelError, match=rf"section that was not wholly passed.*{words}"):
        result.wire_stress()
