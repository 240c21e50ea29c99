"""`arcless run --until` and `arcless resume`: files, words and exit codes."""

import json
from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import Result

import arcless as library

Arcless = Callable[..., Result]
RAN = (0, 3)  # 3: a criterion is not met


@pytest.fixture
def stopped(arcless: Arcless, short: Path, tmp_path: Path) -> Path:
    """Return the file of a run that the command line stopped."""
    done = arcless(
        "run", short, "--until", "120 m", "--out", "part", "--set", "output.line_every=3"
    )
    assert done.exit_code == 0, done.stderr
    assert sorted(file.name for file in (tmp_path / "part").iterdir()) == ["result.nc"]
    assert "stopped at 120.0" in done.stdout
    assert "continue with: arcless resume part/result.nc" in done.stdout
    return tmp_path / "part" / "result.nc"


def test_it_goes_on_to_what_one_run_makes(
    arcless: Arcless, short: Path, stopped: Path, tmp_path: Path
) -> None:
    done = arcless("resume", stopped, "--json")
    assert done.exit_code in RAN, done.stderr
    names = sorted(file.name for file in (tmp_path / "part").iterdir())
    assert names == ["assessment.json", "report.html", "result.nc"]
    again = arcless("run", short, "--out", "whole", "--json", "--set", "output.line_every=3")
    assert again.exit_code == done.exit_code
    one, other = json.loads(again.stdout), json.loads(done.stdout)
    timing = {"wall_time_s", "setup_time_s", "real_time_factor"}
    assert {k: v for k, v in one.items() if k not in timing} == {
        k: v for k, v in other.items() if k not in timing
    }
    whole, parts = (library.open(tmp_path / f / "result.nc").dataset for f in ("whole", "part"))
    assert whole.equals(parts)
    assert len(whole["time"]) > 100
    # It says how to make the whole run, not the way in which it was made.
    assert whole.attrs["command"] == parts.attrs["command"]


def test_it_may_stop_again_elsewhere(arcless: Arcless, stopped: Path, tmp_path: Path) -> None:
    before = stopped.read_bytes()
    done = arcless("resume", stopped, "--until", "3 s", "--out", "next", "--json")
    assert done.exit_code == 0, done.stderr
    facts = json.loads(done.stdout)["stopped"]
    assert facts["time_s"] == pytest.approx(3.0)
    assert facts["result"] == "next/result.nc"
    assert stopped.read_bytes() == before
    assert not library.open(tmp_path / "next" / "result.nc").is_complete


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["resume", "missing.nc"], "no such result file"),
        (["resume", "part/result.nc", "--until", "60 m"], "already there"),
        (["resume", "part/result.nc", "--until", "6 kN"], "a place such as"),
    ],
)
def test_what_cannot_go_on_is_said(
    arcless: Arcless, stopped: Path, words: list[str], said: str
) -> None:
    before = stopped.read_bytes()
    done = arcless(*words)
    assert done.exit_code == 2
    assert said in done.stderr
    assert "Traceback" not in done.stderr
    assert stopped.read_bytes() == before


def test_a_complete_run_cannot_go_on(arcless: Arcless, finished: Path) -> None:
    done = arcless("resume", finished / "result.nc", "--out", "next")
    assert done.exit_code == 2
    assert "holds no state to continue from" in done.stderr


def test_a_controller_in_python_is_refused_before_computing(
    arcless: Arcless, short: Path, tmp_path: Path
) -> None:
    (tmp_path / "mine.py").write_text("def push(sample):\n    return 0.0\n")
    function = (
        f"pantographs.0.controller={{sample_time: 4 ms, function: '{tmp_path}/mine.py:push'}}"
    )
    done = arcless("run", short, "--until", "120 m", "--set", function)
    assert done.exit_code == 1
    assert "cannot stop early and continue later" in done.stderr
