"""The section `wear` of a scenario: units, and what is refused."""

from typing import Any

import pytest

from arcless.errors import ModelError
from arcless.model import load
from arcless.study import load as load_study
from tests.support.studies import data
from tests.support.synthetic import scenario_data
from tests.support.wear import wear_data


def test_amounts_with_units() -> None:
    given = wear_data(current="0.2 kA", hardness="1.2 GPa", arc__melting_heat="205 kJ/kg",
                      joule__resistance__reference_resistance="10 mΩ")  # fmt: skip
    wear = load(scenario_data(wear=given)).wear
    assert wear is not None
    assert (wear.current, wear.hardness, wear.arc.melting_heat) == (200.0, 1.2e9, 205e3)
    assert wear.joule.resistance.model_dump()["reference_resistance"] == 0.01


def test_absent_by_default() -> None:
    assert load(scenario_data()).wear is None


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"hardness": 0}, "wear.hardness"),
        ({"hardness": "120 N"}, "N is the unit of a force"),
        ({"current": "-1 A"}, "at least 0 A"),
        ({"body": "rail"}, "wear.body"),
        ({"arc__density": 0}, "wear.arc.density"),
        ({"mechanical__force_exponent": -1}, "above -1"),
        ({"joule__resistance": {"kind": "law"}}, "wear.joule.resistance"),
        (
            {"joule__resistance": {"kind": "table", "force": [1, 2], "resistance": [1]}},
            "wear.joule.resistance.resistance: wrong number of values",
        ),
        (
            {"joule__resistance": {"kind": "table", "force": [2, 1], "resistance": [1, 1]}},
            "wear.joule.resistance.force.1: forces out of order",
        ),
        ({"illustrative": "yes"}, "wear.illustrative"),
    ],
)
def test_refused(changes: dict[str, Any], message: str) -> None:
    with pytest.raises(ModelError) as refused:
        load(scenario_data(wear=wear_data(**changes)))
    assert message in str(refused.value)


def test_a_missing_coefficient_is_named_with_its_unit() -> None:
    given = wear_data()
    del given["arc"]["melting_heat"]
    with pytest.raises(ModelError, match=r"melting_heat.*J/kg"):
        load(scenario_data(wear=given))


def test_a_study_may_use_wear_where_the_scenario_has_it() -> None:
    wear = {"set": data()["set"] | {"wear": wear_data()}, "outputs": ["wear_total_mm3_km"]}
    study = load_study(data(**wear))
    assert "P1.wear_arc_mm3_km" in study.known_keys()
    with pytest.raises(ModelError, match="wear_total_mm3_km"):
        load_study(data(outputs=["wear_total_mm3_km"]))
