"""Stitched and compound lines at rest."""

from pathlib import Path
from typing import Any

import pytest
from rich.console import Console

import arcless
from arcless.cli.terminal.statics_tables import blocks
from arcless.errors import EquilibriumError
from arcless.model import load
from tests.support.line_types import compound_data, scenario_data, stitched_data


def printed(line: dict[str, Any]) -> str:
    found = arcless.statics(load(scenario_data(line))).to_dict()
    out = Console(width=120)
    with out.capture() as text:
        for block in blocks("it", found):
            out.print(block)
    return text.get()


def test_stitch_wires_are_listed() -> None:
    text = printed(stitched_data())
    assert "Stitch wires there" in text
    # Two droppers, and the stress.
    assert text.count("stitch wire ") == 3
    # Four droppers and the stress; resonance speeds, further down, name the wires too.
    assert text.partition("Resonance speeds")[0].count("messenger wire") == 5


def test_hangers_are_listed_with_the_droppers() -> None:
    text = printed(compound_data())
    assert "Stitch wires" not in text
    assert "hanger 10" in text
    assert "dropper 5" in text
    assert text.count("auxiliary wire") == 10


def test_a_simple_line_reads_as_before() -> None:
    text = printed(stitched_data(stitch_wire=None))
    assert "hangs from" not in text
    assert "Stitch" not in text


def test_stitch_wires_have_a_length_to_cut() -> None:
    found = arcless.statics(load(scenario_data(stitched_data()))).to_dict()
    stitch = found["stitch_wires"][1]
    assert stitch["support"] == "support 3"
    assert [stitch["from_m"], stitch["to_m"]] == pytest.approx([111.0, 129.0])
    left, right = stitch["clamp_heights_m"]
    # The line is symmetric but for its ends, one held and one pulled, three spans away: 0.3 mm.
    assert left == pytest.approx(right, abs=1e-3)
    sag = left - stitch["lowest_m"]
    # Between a straight wire stretched by T/EA = 0.07 % and one that goes down over the 4 m to the
    # first dropper, and up again.
    shortest = 18.0 / (1 + 2.8e3 / 3.9e6)
    assert shortest < stitch["unstretched_length_m"] < shortest + sag * sag / 4.0 + 1e-3
    # The horizontal part is 2.8 kN; 0.05 is the slope at the clamp squared.
    assert 2.8e3 < stitch["tension_N"] < 2.8e3 * 1.05


def test_the_place_without_equilibrium_is_on_the_right_wire(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    with pytest.raises(EquilibriumError, match=r"stitch wire at \d+.\d\d m"):
        arcless.statics(load(scenario_data(stitched_data(stitch_wire__tension=300.0))))
