"""`arcless assess` of measured runs: a file that `arcless export` wrote, and what is refused."""

import json
import re
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from typer.testing import Result

import arcless as package
from arcless.measurements import assess, read
from tests.support.measured import force, record, times, wave, write

Command = Callable[..., Result]


def test_an_exported_run_has_the_numbers_of_the_run(arcless: Command, finished: Path) -> None:
    arcless("export", finished, "--to", "run.csv")
    run = json.loads(arcless("assess", finished, "--json", "--quiet").stdout)
    begin, end = run["section_m"]
    supply = package.open(finished).scenario.line.design.supply
    words = ("--from", f"{begin} m", "--to", f"{end} m", "--json", "--quiet")
    words += () if supply is None else ("--supply", supply)
    done = arcless("assess", "run.csv", *words)
    told = json.loads(done.stdout)
    [own], [ours] = run["pantographs"], told["pantographs"]
    # Not measured: the gap. The rest is the same to the last bit.
    differ = {key for key in own if own[key] != ours[key]}
    assert differ <= {"max_gap_mm", "max_lateral_position_mm"}
    assert set(told) - set(run) == {"measurement"}
    assert set(run) <= set(told)
    verdicts = {one["name"]: one["passed"] for one in run["criteria"]}
    judged = {one["name"]: one["passed"] for one in told["criteria"]}
    assert judged.keys() == verdicts.keys()
    for name, verdict in judged.items():
        assert verdict in (verdicts[name], None), name
    assert told["measurement"]["pantographs"][0]["left_out_percent"] == 0.0


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return write(tmp_path / "run.csv", record())


def test_a_table_with_notes(arcless: Command, file: Path) -> None:
    done = arcless("assess", file, "--supply", "AC 25 kV", "--from", "50 m", "--to", "650 m")
    assert done.exit_code == 0
    for text in ("run at 252 km/h", "standard deviation σ", "Criteria, AC 25 kV", "not judged",
                 "nothing in the section is left out", "Section: 50.0 m to 650.0 m."):  # fmt: skip
        assert text in done.stdout, text
    assert "time steps" not in done.stdout
    assert "maximum gap" not in done.stdout


def test_exit_code_is_that_of_the_criteria(arcless: Command, tmp_path: Path) -> None:
    calm = 90.0 + wave(1.3, 8.0)(times()) + wave(7.1, 3.0)(times())
    file = write(tmp_path / "calm.csv", record(contact_force=calm))
    assert arcless("assess", file, "--supply", "AC 25 kV").exit_code == 0
    wild = 90.0 + wave(1.3, 60.0)(times()) + wave(7.1, 3.0)(times())
    file = write(tmp_path / "wild.csv", record(contact_force=wild))
    done = arcless("assess", file, "--supply", "AC 25 kV")
    assert done.exit_code == 3
    assert "exit code 3, not met: standard deviation σ" in done.stderr
    quiet = arcless("assess", file, "--supply", "AC 25 kV", "--quiet")
    assert (quiet.exit_code, quiet.stderr) == (3, "")


def test_json_goes_to_a_file_too(arcless: Command, file: Path) -> None:
    done = arcless("assess", file, "--json", "--out", "told.json", "--quiet")
    assert json.loads(Path("told.json").read_text("utf-8")) == json.loads(done.stdout)
    told = json.loads(done.stdout)["measurement"]
    assert (told["file"], told["pantographs"][0]["pieces"]) == ("run.csv", 1)


def test_a_page_is_written(arcless: Command, file: Path) -> None:
    done = arcless("assess", file, "--report", "page.html")
    assert done.stdout.endswith("wrote page.html\n")
    assert "A measured run." in Path("page.html").read_text("utf-8")
    done = arcless("assess", file, "--report", "none/page.html")
    assert (done.exit_code, "none" in done.stderr) == (2, True)


def test_speed_and_mass_are_given_on_the_command_line(arcless: Command, tmp_path: Path) -> None:
    acceleration = wave(6.0, 3.0)(times())
    columns = {
        "time [s]": times(),
        "sensor_force_1 [N]": force(times()) - 8.0 * acceleration,
        "acceleration_1 [m/s2]": acceleration,
    }
    file = write(tmp_path / "run.csv", columns)
    words = ("assess", file, "--speed", "252 km/h", "--head-mass", "8 kg", "--json", "--quiet")
    told = json.loads(arcless(*words, "--acceleration-down").stdout)
    plain = json.loads(arcless("assess", write(tmp_path / "b.csv", record()), "--json").stdout)
    for key, value in plain["pantographs"][0].items():
        if isinstance(value, float):  # sums of products, filtered
            assert told["pantographs"][0][key] == pytest.approx(value, rel=1e-9), key
    other = json.loads(arcless(*words).stdout)
    assert other["pantographs"][0]["std_force_5_20Hz_N"] > 30.0


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--speed", "250"], r"--speed: speed of a train: got 250 m/s \(900 km/h\)"),
        (["--speed", "250 kg"], "--speed: wrong value: got .*kg is the unit of a mass"),
        (["--supply", "AC25"], 'supply: got "AC25", expected AC 25 kV, AC 15 kV, DC 3 kV'),
        (["--head-mass", "8 kg"], "which is the contact force already"),
        (["--head-mass", "8 N"], "--head-mass"),
        (["--head-lift", "8 N"], "--head-lift without --head-mass"),
        (["--pantograph", "P2"], 'unknown pantograph: got "P2", expected P1'),
        (["--from", "800 m"], "from < to"),
        (["--low-pass", "300 Hz"], "too few samples for the low-pass"),
    ],
)
def test_wrong_options(arcless: Command, file: Path, words: list[str], message: str) -> None:
    done = arcless("assess", file, *words)
    assert done.exit_code == 2
    assert re.search(message, done.stderr), done.stderr
    assert "Traceback" not in done.stderr


def test_options_of_measurements_are_refused_of_a_run(arcless: Command, finished: Path) -> None:
    done = arcless("assess", finished, "--speed", "250 km/h", "--supply", "AC 25 kV")
    assert done.exit_code == 2
    assert "--speed, --supply of a run" in done.stderr
    assert "are those of its scenario" in done.stderr


def test_a_file_that_is_not_there(arcless: Command) -> None:
    done = arcless("assess", "none.csv")
    assert (done.exit_code, "none.csv: no such file" in done.stderr) == (2, True)


def test_a_million_rows_in_seconds(tmp_path: Path) -> None:
    """A measurement of half an hour at 500 Hz; the limit leaves room for a slow machine."""
    count = np.arange(1_000_000)
    noise = np.random.default_rng(0).normal(130.0, 20.0, count.size).round(2)
    rows = "\n".join(
        f"{i / 500:.3f},{70 * i / 500:.2f},{n}" for i, n in zip(count, noise, strict=True)
    )
    file = tmp_path / "long.csv"
    file.write_text("time [s],position [m],contact_force [N]\n" + rows + "\n")
    begin = time.process_time()
    found = assess(read(file))
    assert time.process_time() - begin < 20.0
    assert found.pantographs[0].mean_force_N == pytest.approx(130.0, abs=0.2)
