"""`arcless step-times`: what it prints and writes, and what it refuses before it measures."""

import csv
import json
from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import Result

from arcless.errors import MachineError
from arcless.platforms import real_time

Arcless = Callable[..., Result]
SCENARIO = "en50318-ac-simple-320-planar"


def test_table_and_histogram(arcless: Arcless) -> None:
    found = arcless("step-times", SCENARIO, "--seconds", "0.1", "--quiet")
    assert found.exit_code == 0, found.stderr
    for words in ("a step: computing", "empty loop: due to done", "99.99 %", "of 100 not done"):
        assert words in found.stdout


@pytest.mark.parametrize("ending", ["json", "csv"])
def test_files(arcless: Arcless, tmp_path: Path, ending: str) -> None:
    file = tmp_path / f"times.{ending}"
    found = arcless(
        "step-times", SCENARIO, "--seconds", "0.1", "--wait", "spin", "--to", str(file), "--json"
    )
    assert found.exit_code == 0, found.stderr
    told = json.loads(found.stdout)
    assert told["circumstances"] == ["ordinary priority", "looking at the clock between steps"]
    if ending == "json":
        assert json.loads(file.read_text("utf-8")) == told
    else:
        rows = list(csv.DictReader(file.read_text("utf-8").splitlines()))
        assert sum(int(row["steps response"]) for row in rows) == 100
        assert [float(row["to [s]"]) for row in rows] == told["histograms"]["edges_s"][1:]
    assert sum(told["histograms"]["empty loop response"]) == told["empty_loop"]["steps"] == 100


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--seconds", "0"], "--seconds: got 0, expected above 0"),
        (["--seconds", "nan"], "--seconds: got nan"),
        (["--to", "times.txt"], "expected a name that ends in .csv, .json"),
        (["--to", "none/times.csv"], "no folder"),
        (["--fifo", "100"], "less than or equal to 99"),
    ],
)
def test_what_is_refused(arcless: Arcless, options: list[str], words: str) -> None:
    found = arcless("step-times", SCENARIO, *options)
    assert found.exit_code == 2
    assert words in found.stderr


def test_a_priority_that_is_not_given_measures_nothing(
    arcless: Arcless, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(_: int) -> str:
        raise MachineError("the system gives no real-time priority", hint="as root")

    monkeypatch.setattr(real_time, "ask_priority", refuse)
    found = arcless("step-times", SCENARIO, "--fifo", "49")
    assert (found.exit_code, found.stdout) == (2, "")
    assert "the system gives no real-time priority; hint: as root" in found.stderr
