"""The animation of a run: its data, what is said of it, and the page that carries it."""

import json
import re
from base64 import b64decode, b64encode
from hashlib import sha256
from html import unescape
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.errors import OutputError
from arcless.results import Result
from arcless.studio.animation import animation
from arcless.studio.animation.animation import animation_of
from arcless.studio.animation.rows import Motion
from tests.support.small import small
from tests.support.waving import uplift, waving


@pytest.fixture(scope="module")
def result() -> Result:
    return arcless.run(small())


@pytest.fixture(autouse=True)
def player(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Stand in for the built player and the recorded motion."""
    (tmp_path / "animation.js").write_text("window.player = '</' + 'script>';")
    (tmp_path / "animation.css").write_text(".animated { color: red; }")
    monkeypatch.setattr(animation, "FOLDER", tmp_path)

    def recorded(data: Any, geometry: Any) -> Motion:
        times = np.asarray(data["line_time"].values)
        x = np.interp(times, data["time"].values, np.asarray(data["position"].values)[:, 0])
        return waving(geometry, times, x)

    monkeypatch.setattr(animation, "recorded", recorded)


def numbers(text: str, kind: str) -> Any:
    return np.frombuffer(b64decode(text), kind)


def test_data_are_those_of_the_run(result: Result) -> None:
    data = json.loads(animation_of(result).data)
    times = numbers(data["times"], "<f8")
    blocks = {one["name"]: one for one in data["blocks"]}
    one = blocks["pantograph.0"]
    row = len(times) // 2
    head = numbers(one["values"], "<f4").reshape(len(times), -1)[row]
    at = int(np.argmin(np.abs(result.latest["time"].values - times[row])))
    expected = [
        result.latest[name].values[at, 0]
        for name in ("position", "contact_force", "contact_height")
    ]
    assert head[:3] == pytest.approx(expected, rel=1e-6)  # singles
    assert head[4:] == pytest.approx(result.latest["mass_displacement"].values[at, 0], rel=1e-6)
    wire = blocks["wire.0.up"]
    first, count = (numbers(wire[key], "<u4") for key in ("first", "count"))
    begin = int(count[:row].sum())
    up = numbers(wire["values"], "<i2")[begin : begin + count[row]] * wire["step"]
    x = np.array(data["geometry"]["wires"][0]["x"])[first[row] : first[row] + count[row]]
    assert up == pytest.approx(uplift(x, expected[0]), abs=wire["step"])


def test_droppers_and_supports_are_those_at_the_time(result: Result) -> None:
    data = json.loads(animation_of(result).data)
    blocks = {one["name"]: one for one in data["blocks"]}
    for name, variable in (("droppers", "dropper_force"), ("supports", "support_uplift")):
        expected = result.latest[variable].values
        times = numbers(data["times"], "<f8")
        found = (
            numbers(blocks[name]["values"], "<i2").reshape(len(times), -1) * blocks[name]["step"]
        )
        rows = np.searchsorted(result.latest["line_time"].values, times + 1e-9) - 1
        assert found == pytest.approx(expected[rows], abs=blocks[name]["step"])


def test_a_size_is_kept_and_said(result: Result) -> None:
    whole = animation_of(result)
    limit = 0.6 * len(whole.data)
    small_one = animation_of(result, limit=limit)
    assert len(small_one.data) <= limit
    assert "whole of the recorded motion" in whole.caption
    assert f"{len(small_one.data) / 1e6:.1f} MB" in small_one.caption
    step = max(one["step"] for one in json.loads(small_one.data)["blocks"] if "wire" in one["name"])
    assert f"steps of {1e3 * step:.3g} mm" in small_one.caption


def test_the_page_allows_its_script_by_its_hash(result: Result, tmp_path: Path) -> None:
    made = animation_of(result)
    result.write_report(tmp_path / "report.html", animation=made)
    page = (tmp_path / "report.html").read_text("utf-8")
    script = f"\n{made.script}\n"
    assert f"<script>{script}</script>" in page
    hashed = b64encode(sha256(script.encode()).digest()).decode()
    assert f"'sha256-{hashed}'" in unescape(page.split('content="default-src')[1].split(">")[0])
    assert page.index('id="animation"') < page.index(f"<script>{script}")
    found = re.search(r'id="animation-data">(.*?)</script>', page, re.DOTALL)
    assert found and json.loads(found[1]) == json.loads(made.data)
    assert 'href="#motion"' in page
    result.write_report(tmp_path / "plain.html")
    assert 'id="animation' not in (tmp_path / "plain.html").read_text("utf-8")


def test_a_player_that_was_not_built(result: Result, tmp_path: Path) -> None:
    (tmp_path / "animation.js").unlink()
    with pytest.raises(
        OutputError, match="player of animations is not built; hint: `make page` builds it"
    ):
        animation_of(result)
