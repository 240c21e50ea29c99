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
        (["--exponent", "0"], "exponent of the Wöhler line: got 0.0, expected a number, 1 to 30"),
        (["--area", "0.00012"], "area of a wire"),
        (["--area", "120 mm3"], '--area: wrong value: got "120 mm3", expected an area (m², mm²'),
        (["--area", "1,2"], '--area: wrong value: got "1,2"'),
        (["--tension", "11"], "the tension is 11 N: one in kN needs its unit"),
        (["--tension", "11 kg"], "--tension"),
        (["--tension", "-5 kN"], "under tension"),
    ],
)
def test_what_is_refused(arcless: Run, finished: Path, words: list[str], message: str) -> None:
    done = arcless("stress", finished, *words)
    assert done.exit_code == 2, done.output
    assert message in " ".join(done.stderr.split())


@pytest.mark.parametrize("area", ["120", "120 mm2", "120 mm²", "1.2 cm2"])
def test_an_area_has_a_unit_or_is_in_square_millimetres(
    arcless: Run, finished: Path, area: str
) -> None:
    told = json.loads(arcless("stress", finished, "--json", "--area", area).stdout)
    assert told["area_mm2"] == pytest.approx(120.0, rel=1e-12)


def test_an_area_that_is_not_that_of_the_wire_is_warned_of(arcless: Run, finished: Path) -> None:
    done = arcless("stress", finished, "--area", "95")  # E = 15 MN/95 mm² = 157.9 GPa
    assert done.exit_code == 0
    assert "warning: the area of 95.0 mm² (stated)" in done.stderr
    assert "157.9 GPa" in done.stderr and "90 to 135 GPa (assumed)" in done.stderr
    assert arcless("stress", finished, "--area", "150 mm²").stderr == ""


def test_the_table_says_its_order_and_fits_80_characters(
    arcless: Run, finished: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    plain = arcless("stress", finished).stdout
    told = arcless("stress", finished, "--exponent", "5").stdout
    assert "fibres, largest range first" in plain and "S_eq" not in plain
    assert "fibres, largest S_eq first" in told
    assert "range of one cycle per passage that does the damage of all" in told
    assert all(len(line) <= 80 for line in (plain + told).splitlines())
    rows = [line.split() for line in told.splitlines() if "dropper" in line]
    assert len(rows) > 5
    # Each row is on one line: the name of the place, and six numbers.
    assert all(len(row) == 11 for row in rows)
    ranges = [float(row[-1]) for row in rows]
    assert ranges == sorted(ranges, reverse=True)


def test_a_run_that_stopped_early_is_refused(arcless: Run, short: Path) -> None:
    begun = arcless("run", short, "--until", "300 ft", "--out", "part", "--quiet")
    assert begun.exit_code == 0, begun.output
    done = arcless("stress", "part", "--exponent", "5")
    assert done.exit_code == 2 and done.stdout == ""
    message = " ".join(done.stderr.split())
    assert "run that stopped early: expected a finished run" in message
    assert "`arcless resume RUN` continues it" in message


def test_what_is_no_run(arcless: Run, tmp_path: Path) -> None:
    done = arcless("stress", tmp_path)
    assert done.exit_code == 2
    assert "no run in this folder" in done.stderr
