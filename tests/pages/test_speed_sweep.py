"""The picture of the sweep of speed is repeatable, its marks are those in range."""

from math import pi
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import make_speed_sweep as make
import numpy as np
import pytest
import xarray
from guide import speed_marks

from arcless.simulate import ResonanceSpeeds, resonance_speeds
from arcless.study import load


@pytest.fixture(scope="module")
def told() -> ResonanceSpeeds:
    return resonance_speeds(load("speed-sweep").base)


def rows(values: list[float]) -> list[dict[str, Any]]:
    names = (*make.COLUMNS, "mean")
    return make.sweep(
        [
            {"status": "done", "speed": (100 + 100 * i) / 3.6, **dict.fromkeys(names, value)}
            for i, value in enumerate(values)
        ]
    )


def test_marks_are_those_in_range(told: ResonanceSpeeds) -> None:
    rows = speed_marks.marks(told, 300.0, 340.0).splitlines()
    assert rows[2:] == ["| 322 | – | wave speed: limit of EN 50119 | – |"]


def test_peaks_are_above_their_neighbours() -> None:
    assert make.peaks(rows([1.0, 3.0, 2.0, 4.0])) == [200.0]
    assert make.peaks(rows([3.0, 2.0, 2.0, 1.0])) == []


def test_drawn_twice_it_is_the_same_file(tmp_path: Path, told: ResonanceSpeeds) -> None:
    one, other = tmp_path / "one.svg", tmp_path / "other.svg"
    for file in (one, other):
        make.draw(rows([1.0, 3.0, 2.0, 4.0]), told, str(file))
    assert one.read_bytes() == other.read_bytes()
    assert "span passing, swing of the line" in one.read_text("utf-8")


def test_waves_of_a_span() -> None:
    scenario = load("speed-sweep").base
    x = np.linspace(200.0, 900.0, 30_000)
    force = 100.0 + 3.0 * np.sqrt(2.0) * np.sin(2.0 * pi * 4.0 * x / 55.0)
    data = xarray.Dataset(
        {"position": (("t", "p"), x[:, None]), "contact_force": (("t", "p"), force[:, None])}
    )
    found = make.waves(SimpleNamespace(scenario=scenario, dataset=data))
    # Four waves in each span of 55 m; linear between points every 23 mm.
    assert found == pytest.approx([0.0, 0.0, 0.0, 3.0, *[0.0] * 9], abs=1e-4)
