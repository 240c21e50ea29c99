"""`arcless stress`: tables, JSON, and what it refuses."""

import json
from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import Result

Run = Callable[..., Result]


def test_tables_and_json(arcless: Run, finished: Path) -> None:
    done = arcless("stress", finished, "--exponent", "5")
    assert done.exit_code == 0, done.output
    assert "S_eq" in done.stdout and "span 3 dropper" in done.stdout
    told = json.loads(arcless("stress", finished, "--json").stdout)
    assert told["exponent"] is None
    assert {one["fibre"] for one in told["places"]} == {"top"}
    stated = json.loads(arcless("stress", finished, "--json", "--area", "150").stdout)
    assert stated["area_mm2"] == pytest.approx(150.0)
    assert stated["area_from"] == "stated"
    pulled = json.loads(arcless("stress", finished, "--json", "--tension", "11 kN").stdout)
    assert pulled["axial_stress_MPa"] == pytest.approx(0.5 * told["axial_stress_MPa"])


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--exponent", "0"], "exponent of the Wöhler line: got 0, expected 1 to 30"),
        (["--area", "0.00012"], "area of a wire"),
        (["--tension", "11"], "the tension is 11 N: one in kN needs its unit"),
        (["--tension", "11 kg"], "--tension"),
        (["--tension", "-5 kN"], "under tension"),
    ],
)
def test_what_is_refused(arcless: Run, finished: Path, words: list[str], message: str) -> None:
    done = arcless("stress", finished, *words)
    assert done.exit_code == 2, done.output
    assert message in " ".join(done.stderr.split())


def test_what_is_no_run(arcless: Run, tmp_path: Path) -> None:
    done = arcless("stress", tmp_path)
    assert done.exit_code == 2
    assert "no run in this folder" in done.stderr
