"""`arcless study` as a user meets it."""

import json
import re
import subprocess
import sys
from collections import Counter
from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import Result

from arcless.cli.terminal.study_progress import words
from arcless.study import Progress, StudyFolder, load
from tests.support.studies import QUICK, SHORT, filled, rows, written

Arcless = Callable[..., Result]
ALL = "small: 4 of 6 done, 2 invalid, 0 failed"


def test_run_status_resume(arcless: Arcless, tmp_path: Path) -> None:
    file = written(tmp_path)
    done = arcless("study", "run", file)
    assert done.exit_code == 0, done.output
    assert done.stdout.startswith(f"{ALL}; computed 6 in ")
    assert " variants/s" in done.stdout
    assert "wrote runs/studies/small/table.parquet" in done.stdout
    assert done.stderr == ""
    status = arcless("study", "status", file)
    assert status.stdout.startswith(f"{ALL}, 0 missing; not being computed")
    assert "2 × pantographs.0.static_force: got -5.0" in status.stdout
    again = arcless("study", "resume", file)
    assert again.stdout.startswith(f"{ALL}; computed 0")
    assert again.exit_code == 0


def test_json_alone_on_standard_output(arcless: Arcless, tmp_path: Path) -> None:
    file = written(tmp_path)
    done = arcless("study", "run", file, "--json", "--out", "here", "--workers", 2)
    found = json.loads(done.stdout)
    assert {key: found[key] for key in ("study", "total", "done", "invalid", "failed")} == {
        "study": "small", "total": 6, "done": 4, "invalid": 2, "failed": 0,
    }  # fmt: skip
    assert found["table"] == "here/table.parquet"
    assert found["variants_per_s"] > 0
    status = json.loads(arcless("study", "status", file, "--json", "--out", "here").stdout)
    assert (status["missing"], status["running"], status["invalid"]) == (0, False, 2)
    assert len(rows(tmp_path / "here" / "table.parquet")) == 6


def test_a_study_without_any_value_fails(arcless: Arcless, tmp_path: Path) -> None:
    force = {"force": {"field": "pantographs.0.static_force", "values": [-1, -2]}}
    done = arcless("study", "run", written(tmp_path, variables=force))
    assert done.exit_code == 1
    assert "0 of 2 done, 2 invalid" in done.stdout


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["run", "none.yaml"], "none.yaml: no such file"),
        (["run", str(SHORT)], 'got "arcless-scenario/1", expected arcless-study/1'),
        (["resume", "small.yaml"], "no study was begun here"),
        (["status", "small.yaml"], "no study was begun here"),
        (["run", "small.yaml", "--scheduler", "localhost"], "executor.scheduler"),
        (["run", "small.yaml", "--workers", "0"], "--workers"),
        (
            ["run", "small.yaml", "--scheduler", "tcp://h:1", "--workers", "2"],
            "both scheduler and workers",
        ),
        (
            ["run", "small.yaml", "--executor", "threads", "--scheduler", "tcp://h:1"],
            "scheduler without Dask",
        ),
        (["trials", "small.yaml"], "does not optimise has no trials"),
        (["start", "small.yaml"], "No such command"),
    ],
)  # fmt: skip
def test_wrong_input(arcless: Arcless, tmp_path: Path, words: list[str], message: str) -> None:
    written(tmp_path)
    done = arcless("study", *words)
    assert done.exit_code == 2
    assert message in done.stderr
    assert done.stdout == ""
    assert len(done.stderr.splitlines()) <= 2
    assert not (tmp_path / "runs").exists()


def test_a_changed_file_is_refused_with_the_difference(arcless: Arcless, tmp_path: Path) -> None:
    file = written(tmp_path)
    arcless("study", "run", file)
    written(tmp_path, seed=4)
    done = arcless("study", "resume", file)
    assert done.exit_code == 2
    assert "seed: 0 → 4" in done.stderr
    assert "restart in another folder with `--out`" in done.stderr


def test_check_knows_studies(arcless: Arcless, tmp_path: Path) -> None:
    file = written(tmp_path)
    assert arcless("check", file).stdout == f"{file}: valid study `small`, 6 variants\n"
    file.write_text(file.read_text().replace("std_force_N", "std_farce_N"))
    wrong = arcless("check", file)
    assert wrong.exit_code == 2
    assert "did you mean std_force_N?" in wrong.stderr


def test_no_scheduler_is_said_within_ten_seconds(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "arcless", "study", "run", str(written(tmp_path)),
         "--scheduler", "tcp://127.0.0.1:9"],
        cwd=tmp_path, capture_output=True, text=True, timeout=60, check=False,
    )  # fmt: skip
    assert done.returncode == 1
    assert done.stderr.startswith("error: tcp://127.0.0.1:9: no Dask scheduler answers")
    assert "within 5 s" in done.stderr  # what is waited for; nothing else takes long
    assert len(done.stderr.splitlines()) == 1
    assert not (tmp_path / "runs").exists()


def test_the_words_of_the_bar() -> None:
    now = Progress(100, Counter(done=18, failed=2), computed=10, elapsed_s=4.0)
    assert words(now) == "2.5/s, 0:00:32 left, 2 failed"
    assert words(Progress(100)) == ""


def test_a_study_loads_no_cluster_and_no_plots(tmp_path: Path) -> None:
    script = (
        "import sys\nfrom arcless.cli import main\n"
        "try:\n    main()\nexcept SystemExit as leave:\n    assert not leave.code, leave.code\n"
        "print(*sys.modules, file=sys.stderr)"
    )
    done = subprocess.run(
        [sys.executable, "-c", script, "study", "run", str(written(tmp_path)), "--quiet"],
        cwd=tmp_path, capture_output=True, text=True, timeout=60, check=True,
    )  # fmt: skip
    loaded = {name.partition(".")[0] for name in done.stderr.split()}
    assert not loaded & {"dask", "distributed", "bokeh", "scipy", "xarray", "matplotlib"}


def test_status_leaves_percentiles_of_what_is_there(arcless: Arcless, tmp_path: Path) -> None:
    force = {"force": {"field": "pantographs.0.static_force", "range": [60, 120]}}
    sample = {"variables": force, "design": {"kind": "monte-carlo", "count": 4}}
    file = written(tmp_path, **sample)
    filled(tmp_path / "here", of=3, **sample)
    place = tmp_path / "here"
    assert arcless("study", "status", file, "--out", place).exit_code == 0
    left = json.loads((place / "percentiles.json").read_text("utf-8"))
    shown = json.loads(arcless("study", "status", file, "--out", place, "--json").stdout)
    assert shown["percentiles"] == left
    assert left["outputs"]["sigma"]["values"] == 3
    (place / "percentiles.json").unlink()
    with StudyFolder(load(file), place).open_journal():  # who computes it writes them in the end
        assert arcless("study", "status", file, "--out", place).exit_code == 0
    assert not (place / "percentiles.json").exists()


def test_an_optimisation_ends_with_its_best(arcless: Arcless, tmp_path: Path) -> None:
    design = {"kind": "optimise", "trials": 4, "objectives": {"sigma": "minimise"}}
    force = {"force": {"field": "pantographs.0.static_force", "range": [60, 120]}}
    file = written(tmp_path, design=design, variables=force)
    done = arcless("study", "run", file)
    assert done.exit_code == 0, done.output
    (best,) = (line for line in done.stdout.splitlines() if line.startswith("best: variant "))
    assert re.fullmatch(r"best: variant \d: force [\d.]+ N, sigma [\d.]+ N, ratio [\d.]+", best)
    found = json.loads(arcless("study", "resume", file, "--json").stdout)
    table = rows(tmp_path / "runs/studies/small/table.parquet")
    assert found["best"] == [min(table, key=lambda row: row["sigma"])["variant"]]
    made = arcless("study", "variant", file, str(found["best"][0]))
    force_N = json.loads(made.stdout)["pantographs"][0]["static_force"]
    assert force_N == table[found["best"][0] - 1]["force"]
    assert arcless("study", "report", file).exit_code == 0


def test_a_search_tells_what_pruning_saved(arcless: Arcless, tmp_path: Path) -> None:
    import optuna

    design = {"kind": "optimise", "trials": 8, "objectives": {"sigma": "minimise"},
              "pruning": {"kind": "percentile", "after": 2, "percentile": 20}}  # fmt: skip
    force = {"force": {"field": "pantographs.0.static_force", "range": [60, 140]}}
    fine = {**QUICK, "solver.time_step": "1 ms"}
    file = written(tmp_path, design=design, variables=force, set=fine)
    found = json.loads(arcless("study", "run", file, "--json").stdout)
    assert found["pruned"] > 0 and found["done"] + found["pruned"] == 8
    assert 0 < found["steps_saved"] < found["steps_taken"]
    done = arcless("study", "resume", file)
    assert f"{found['done']} of 8 done, {found['pruned']} pruned, 0 invalid" in done.stdout
    assert f"pruning saved some {found['steps_saved']} steps" in done.stdout
    status = arcless("study", "status", file)
    assert f"saved some {found['steps_saved']} steps; {found['steps_taken']} taken" in status.stdout
    wrote = arcless("study", "trials", file)
    assert wrote.stdout == "wrote runs/studies/small/trials.db: 8 trials\n"
    url = f"sqlite:///{tmp_path}/runs/studies/small/trials.db"
    assert len(optuna.load_study(study_name="small", storage=url).trials) == 8


@pytest.mark.parametrize("named", ["", "journal.db", "table.parquet", "study.json", "study.yaml"])
def test_a_study_is_named_by_its_folder_too(
    arcless: Arcless, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, named: str
) -> None:
    (tmp_path / "sources").mkdir()
    (tmp_path / "moved").mkdir()
    file = written(tmp_path / "sources", description="all of it")
    filled(tmp_path / "moved" / "there", of=5, description="all of it")
    file.unlink()  # the folder has all that was asked
    monkeypatch.chdir(tmp_path / "moved")
    given = Path("there", named)
    found = json.loads(arcless("study", "status", given, "--json").stdout)
    assert (found["name"], found["folder"], found["missing"]) == ("small", "there", 1)
    done = arcless("study", "resume", given)
    assert done.exit_code == 0, done.output
    assert "computed 1" in done.stdout and "wrote there/table.parquet" in done.stdout
    assert arcless("study", "report", given).stdout == "wrote there/report.html\n"
    page = Path("there/report.html").read_text("utf-8")
    assert "all of it" in page
    assert re.search(
        r"arcless study variant there (\d) --to variant-\1.yaml &amp;&amp; arcless", page
    )
    one = json.loads(arcless("study", "variant", given, "2").stdout)
    assert one["pantographs"][0]["static_force"] == 90.0
    again = arcless("study", "run", given)
    assert again.exit_code == 2
    assert "complete already" in again.stderr
    assert "`arcless study report there --out there`" in again.stderr
    # A new folder may begin with what an old one asks.
    assert arcless("study", "run", given, "--out", "new").exit_code == 0
    assert rows(Path("new/table.parquet"))[0]["status"] == "done"


def test_a_folder_without_a_study(arcless: Arcless, tmp_path: Path) -> None:
    done = arcless("study", "status", tmp_path)
    assert done.exit_code == 2
    assert "no study was begun here: expected the folder of a study, or a study file" in done.stderr
    filled(tmp_path, of=1)
    text = (tmp_path / "study.json").read_text("utf-8")
    for spoilt in (
        "{}",
        '{"study": {}, "hash": "", "arcless_version": ""}',
        text.replace("90", "91"),
    ):
        (tmp_path / "study.json").write_text(spoilt, "utf-8")
        done = arcless("study", "status", tmp_path)
        assert (done.exit_code, "state of the study cannot be read" in done.stderr) == (2, True)


def test_beginning_twice_says_what_there_is_to_do(arcless: Arcless, tmp_path: Path) -> None:
    file = written(tmp_path)
    filled(tmp_path / "runs/studies/small", of=2)
    done = arcless("study", "run", file)
    assert done.exit_code == 2
    assert "the study was begun here already: got 2 of 6 variants" in done.stderr
    assert f"continue with `arcless study resume {file}`, or restart with" in done.stderr


def test_status_tells_of_damage_once(arcless: Arcless, tmp_path: Path) -> None:
    filled(tmp_path)
    file = tmp_path / "journal.db"
    file.write_bytes(file.read_bytes().replace(b'"variant":2,', b'"variant":3,'))
    done = arcless("study", "status", tmp_path)
    assert done.exit_code == 0
    assert "5 of 6 done" in done.stdout
    (line,) = done.stderr.splitlines()
    assert "the journal is damaged, rows left out: 1; `arcless study resume` computes" in line
    assert "damaged" in arcless("study", "report", tmp_path).stderr


def test_a_file_is_no_folder_of_a_study(arcless: Arcless, tmp_path: Path) -> None:
    # `--out` is the folder; a user who meant the file got none, without a message.
    file = written(tmp_path)
    done = arcless("study", "variant", file, "1", "--out", "one.yaml")
    assert done.exit_code == 2
    assert done.stdout == ""
    assert "--to one.yaml writes the scenario into this file" in done.stderr
    assert arcless("study", "variant", file, "1", "--to", "one.yaml").stdout == "wrote one.yaml\n"
