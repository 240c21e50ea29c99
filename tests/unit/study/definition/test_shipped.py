"""The shipped studies: they load by name, and the one on wear shows both of its branches."""

from pathlib import Path
from typing import Any

import pytest

from arcless.errors import ModelError
from arcless.model.files.yaml_reader import parse
from arcless.model.shipped.library import shipped
from arcless.study import is_study, load, run
from tests.support.studies import QUICK, SHORT

STUDIES = shipped("study")


@pytest.mark.parametrize("name", STUDIES)
def test_loads_by_name(name: str) -> None:
    study = load(name)
    assert study.name == name
    assert study.description and study.sources
    assert study.plan.count > 1
    assert is_study(name)


def test_a_name_that_is_none() -> None:
    with pytest.raises(ModelError, match=r"unknown study.*did you mean uplift-force-and-wear"):
        load("uplift-force-and-waer")
    assert not is_study("norway-s25")


def test_every_coefficient_of_wear_is_marked() -> None:
    study = load("uplift-force-and-wear")
    wear = study.base.wear
    assert wear is not None and wear.illustrative
    for group in ("mechanical", "arc"):
        for field in type(getattr(wear, group)).model_fields:
            assert study.provenance[f"set.wear.{group}.{field}"].mark in ("assumed", "C")


def test_the_line_as_it_is_shipped_is_among_the_dropper_designs() -> None:
    study = load("dropper-spacing-and-pre-sag")
    droppers = study.base.line.span_types["standard"].droppers
    positions, presag = (axis.levels or () for axis in study.axes)
    assert list(droppers.positions) in [list(values) for values in positions]
    # Shipped to the millimetre, here to a tenth of it on a parabola.
    assert any(
        values == pytest.approx(list(droppers.presag or ()), abs=0.5e-3) for values in presag
    )
    for values in positions:
        assert values[0] + values[-1] == pytest.approx(55.0, abs=1e-9)  # about the middle


def test_the_forces_of_the_sweep_are_those_of_the_rule() -> None:
    from arcless.assess.rules import RULES

    study = load("speed-sweep")
    speeds, forces = (axis.levels or () for axis in study.axes)
    kmh = [3.6 * speed for speed in speeds]
    assert kmh == pytest.approx(list(range(100, 401, 5)), abs=1e-9)  # rounding of units
    for speed, force in zip(kmh, forces, strict=True):
        (rule,) = [
            rule
            for rule in RULES
            if rule.name == "mean_force"
            and "AC 25 kV" in rule.supplies
            and rule.speeds_km_h[0] < round(speed, 6) <= rule.speeds_km_h[1]
        ]
        limit = rule.limit.constant + rule.limit.per_speed_squared * speed**2
        assert force == pytest.approx(limit, abs=0.05 + 1e-9)  # written to a tenth of a newton


def test_arcs_wear_at_low_force_and_friction_at_high_force(tmp_path: Path) -> None:
    from pyarrow.parquet import read_table

    data, _ = parse(STUDIES["uplift-force-and-wear"].read_text("utf-8"), "study")
    force: dict[str, Any] = {**data["variables"]["uplift_force"], "values": [4, 90, 300]}
    del force["range"], force["count"]
    short = {**data, "scenario": str(SHORT), "set": {**QUICK, **data["set"], "speed": "160 km/h"},
             "variables": {"uplift_force": force}}  # fmt: skip
    run(load(short), tmp_path)
    low, between, high = read_table(tmp_path / "table.parquet").to_pylist()
    assert low["wear_arc_mm3_km"] > low["wear_mechanical_mm3_km"]
    assert high["wear_mechanical_mm3_km"] > high["wear_arc_mm3_km"]
    totals = [row["wear_total_mm3_km"] for row in (low, between, high)]
    assert min(totals) == totals[1]
