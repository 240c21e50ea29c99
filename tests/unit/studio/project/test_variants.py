"""Variants as files: only what differs, next to their base."""

from pathlib import Path
from typing import Any

import httpx
import pytest
from starlette.testclient import TestClient

import arcless

BASE = "shipped:scenario/en50318-ac-simple-320-planar"
BAD = range(400, 500)


def make(
    client: TestClient, name: Any = "softer", scenario: Any = BASE, **changes: Any
) -> httpx.Response:
    asked = {"scenario": scenario, "name": name, "changes": changes}
    return client.post("/api/variant", json=asked)


def test_a_variant_of_a_shipped_scenario(client: TestClient, folder: Path) -> None:
    found = make(client, **{"line.contact_wire.tension": "19 kN", "speed": "300 km/h"})
    assert found.json() == {"path": "softer.yaml"}
    text = (folder / "softer.yaml").read_text("utf-8")
    assert "base: en50318-ac-simple-320-planar\n" in text
    assert len(text.splitlines()) == 6
    scenario = arcless.load(folder / "softer.yaml")
    assert scenario.line.contact_wire.tension == 19e3
    assert scenario.name == "softer"


def test_a_variant_stands_next_to_its_base(client: TestClient, folder: Path) -> None:
    make(client)
    (folder / "deep").mkdir()
    (folder / "softer.yaml").rename(folder / "deep" / "softer.yaml")
    found = make(client, "faster", "deep/softer.yaml", speed="310 km/h")
    assert found.json() == {"path": "deep/faster.yaml"}
    assert "base: softer.yaml\n" in (folder / "deep" / "faster.yaml").read_text("utf-8")
    assert arcless.load(folder / "deep" / "faster.yaml").speed == pytest.approx(310 / 3.6)


def test_one_of_the_name_stays(client: TestClient, folder: Path) -> None:
    make(client)
    before = (folder / "softer.yaml").read_bytes()
    assert make(client, speed="310 km/h").status_code in BAD
    assert (folder / "softer.yaml").read_bytes() == before


@pytest.mark.parametrize("changes", [
    {"speed": "310 kN"}, {"none": 1}, {"line.contact_wire.tension": "-1 kN"}, {"description": "x"},
])  # fmt: skip
def test_what_would_be_no_scenario_is_not_written(
    client: TestClient, folder: Path, changes: dict[str, Any]
) -> None:
    found = make(client, **changes)
    assert found.status_code in BAD
    assert found.json()["error"]["text"]
    assert list(folder.iterdir()) == []


@pytest.mark.parametrize("name", [
    "", ".x", "a/b", "../x", "x\n", "en50318-ac-simple-320-planar", "x" * 100, 5, None, "a:b",
])  # fmt: skip
def test_names_that_are_none(client: TestClient, folder: Path, name: Any) -> None:
    assert make(client, name).status_code in BAD
    assert list(folder.iterdir()) == []


@pytest.mark.parametrize("scenario", ["none.yaml", "shipped:line/ac-simple-55", 5, None, ""])
def test_a_base_that_is_none(client: TestClient, folder: Path, scenario: Any) -> None:
    assert make(client, scenario=scenario).status_code in BAD
    assert list(folder.iterdir()) == []
