"""Wear: each part by hand, limits, dimensions, and what the whole assessment makes of it."""

import json

import numpy as np
import pytest

from arcless.assess import WEAR_KEYS, Assessment, assess
from arcless.assess.wear import ILLUSTRATIVE, contact_resistance, wear_rates
from tests.support.synthetic import scenario_data, synthetic_dataset
from tests.support.wear import wear_data

# Both sides are a handful of products in double precision.
ROUND_OFF = 1e-13
MM3_KM = 1e12  # of 1 m³/m


def parts(force: float = 100.0, loss: float = 0.0, speed: float = 50.0, **changes):
    found = wear_rates(wear_data(**changes), force, loss, speed)
    return tuple(getattr(found, key) for key in WEAR_KEYS)


def test_friction_alone() -> None:
    mechanical, joule, arc, total = parts(force=400.0, current=0.0)
    # (½)^(−2) = 4 and (400/100)^½ = 2, both exact.
    assert mechanical == pytest.approx(2e-8 * 4.0 * 2.0 * 400.0 / 1e9 * MM3_KM, rel=ROUND_OFF)
    assert (joule, arc, total) == (0.0, 0.0, mechanical)


def test_friction_at_the_reference_current_has_no_factor() -> None:
    assert parts()[0] == pytest.approx(2e-8 * 100.0 / 1e9 * MM3_KM, rel=ROUND_OFF)


def test_current_alone() -> None:
    # R(400 N) = 0.01 Ω (400/100)^(−½) = 5 mΩ.
    _, joule, arc, total = parts(force=400.0, mechanical__factor=0.0)
    assert joule == pytest.approx(3e-6 * 0.005 * 400.0**2 / (1e9 * 50.0) * MM3_KM, rel=ROUND_OFF)
    assert (arc, total) == (0.0, joule)


def test_arcs_alone() -> None:
    mechanical, joule, arc, total = parts(loss=2.0, mechanical__factor=0.0, joule__factor=0.0)
    expected = 0.1 * 0.02 * 30.0 * 400.0 / (50.0 * 2e5 * 8900.0) * MM3_KM
    assert arc == pytest.approx(expected, rel=ROUND_OFF)
    assert (mechanical, joule, total) == (0.0, 0.0, arc)


def test_the_sum_is_that_of_its_parts() -> None:
    *each, total = parts(loss=2.0)
    assert min(each) > 0.0
    assert total == pytest.approx(sum(each), rel=ROUND_OFF)


def test_no_part_depends_on_the_choice_of_units() -> None:
    """All amounts in cm, kg, ms, and amperes a tenth: the volume per length is in cm²."""
    length, time, current = 100.0, 1e3, 10.0  # new units in one old unit
    force, power = length / time**2, length**2 / time**3
    voltage = power / current
    scale = {
        "current": current, "hardness": force / length**2,
        "mechanical__reference_current": current, "mechanical__reference_force": force,
        "arc__voltage": voltage, "arc__melting_heat": length**2 / time**2,
        "arc__density": 1.0 / length**3,
    }  # fmt: skip
    plain = wear_data()
    changed = {}
    for path, factor in scale.items():
        value = plain
        for part in path.split("__"):
            value = value[part]
        changed[path] = value * factor
    law = plain["joule"]["resistance"]
    law = law | {"reference_resistance": law["reference_resistance"] * voltage / current,
                 "reference_force": law["reference_force"] * force}  # fmt: skip
    ours = parts(force=150.0, loss=3.0)
    theirs = parts(150.0 * force, 3.0, 50.0 * length / time, joule__resistance=law, **changed)
    np.testing.assert_allclose(theirs, np.multiply(ours, length**2), rtol=ROUND_OFF)


def test_less_wear_by_friction_and_more_by_arcs_at_low_force() -> None:
    low, high = parts(force=40.0, loss=30.0), parts(force=240.0)
    assert low[0] < high[0]
    assert low[2] > 0.0 == high[2]
    assert low[1] > high[1]  # the contact resistance falls with the force


def test_without_contact_nothing_is_rubbed_off() -> None:
    assert parts(force=0.0, loss=100.0)[:2] == (0.0, None)
    assert parts(force=-1e-12, loss=100.0, current=0.0) == (0.0, 0.0, 0.0, 0.0)


def test_standing_still_only_friction_has_a_rate() -> None:
    assert parts(speed=0.0)[1:] == (None, None, None)
    assert parts(speed=0.0)[0] == parts()[0]


def test_a_table_of_resistances_is_linear_and_ends() -> None:
    law = {"kind": "table", "force": [50.0, 150.0], "resistance": [0.03, 0.01]}
    assert contact_resistance(law, 100.0) == pytest.approx(0.02, rel=ROUND_OFF)
    assert contact_resistance(law, 150.0) == 0.01
    assert contact_resistance(law, 151.0) is None
    assert contact_resistance(law, 151.0, current_A=0.0) == 0.0


def test_a_constant_resistance_holds_without_force_too() -> None:
    law = {"kind": "power", "reference_resistance": 0.01, "reference_force": 1.0, "exponent": 0.0}
    assert contact_resistance(law, 0.0) == 0.01


def assessed(**changes) -> Assessment:
    scenario = scenario_data(wear=wear_data(**changes))
    # Contact is lost for two of the 10 s in the section, which begins at 10 s.
    record = synthetic_dataset(
        scenario=scenario,
        pantographs=("P1", "P2"),
        distance_m=20.0,
        force=lambda t: np.where((t >= 12.0) & (t < 14.0), 0.0, 100.0),
    )
    return assess(record)


def test_arcs_follow_the_loss_of_contact_of_each_pantograph() -> None:
    for pantograph in assessed().pantographs:
        u = pantograph.contact_loss_percent / 100.0
        assert u == pytest.approx(0.2, abs=1e-3)  # one sample of 10 001 at each border
        expected = 0.1 * u * 30.0 * 400.0 / (20.0 * 2e5 * 8900.0) * MM3_KM
        assert pantograph.wear_arc_mm3_km == pytest.approx(expected, rel=1e-9)  # mean of 20 m/s


def test_illustrative_coefficients_say_so() -> None:
    assert ILLUSTRATIVE in assessed(illustrative=True).notes
    assert ILLUSTRATIVE not in assessed().notes


def test_beyond_the_table_the_note_says_why() -> None:
    law = {"kind": "table", "force": [100.0, 150.0], "resistance": [0.03, 0.01]}
    found = assessed(joule__resistance=law)
    assert found.pantographs[0].wear_total_mm3_km is None
    assert any("no contact resistance is given" in note for note in found.notes)
    assert json.loads(found.to_json())["pantographs"][0]["wear_joule_mm3_km"] is None


def test_without_coefficients_there_are_no_keys() -> None:
    found = json.loads(assess(synthetic_dataset()).to_json())["pantographs"][0]
    assert not set(WEAR_KEYS) & set(found)
    assert set(WEAR_KEYS) <= set(assessed().to_dict()["pantographs"][0])
