"""Folders of runs: their names, what keeps a run from being overwritten, and `arcless runs`."""

import json
import re
import shlex
import shutil
import subprocess
import threading
from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import Result

import arcless as library
from arcless.results.run_folder.run_folder import LONGEST, folder_of
from arcless.storage import hidden_files
from tests.interface.conftest import command
from tests.interface.test_start import OF_OTHERS, SLOW, modules_of

GUIDE = Path(__file__).parents[2] / "docs" / "guide" / "runs.md"
Arcless = Callable[..., Result]
RAN = (0, 3)  # 3: a criterion is not met
# Ends in a fraction of the time of a whole run, and has a result all the same.
BRIEF = ("--until", "70 m", "--quiet")
# Characters that Windows has in no name of a file, and the slash.
FORBIDDEN = set('<>:"/\\|?*') | {chr(code) for code in range(32)}


@pytest.fixture
def never(monkeypatch: pytest.MonkeyPatch) -> None:
    """Fail where anything is computed."""
    from arcless import simulate

    def fault(*_arguments: object, **_options: object) -> None:
        raise AssertionError("it was computed first")

    for name in ("run", "resume"):
        monkeypatch.setattr(simulate, name, fault)


def folders() -> list[str]:
    return sorted(path.name for path in Path("runs").iterdir())


def refused(done: Result, *words: str) -> None:
    assert done.exit_code == 2, done.output
    assert not done.stdout
    for word in words:
        assert word in done.stderr, done.stderr


def test_changes_are_in_the_name(arcless: Arcless, short: Path) -> None:
    changes = ("--set", "line.contact_wire.tension=19 kN", "--speed", "150 km/h")
    for words in ((), changes):
        assert arcless("run", short, *BRIEF, *words).exit_code == 0
    assert folders() == ["short", "short-speed=150_km-h,line.contact_wire.tension=19_kN"]
    refused(arcless("run", short, *BRIEF, *changes[2:], *changes[:2]), "a run is in this folder")


def test_certainty_and_another_name_are_no_changes(short: Path) -> None:
    scenario = library.load(short).with_(certainty=8, name="a/b: c")
    assert folder_of(scenario) == Path("runs/a-b-c")


@pytest.mark.parametrize(
    ("changes", "name"),
    [
        ({"speed": " 150  km/h"}, "short-speed=150_km-h"),
        ({"as_built.temperature_difference": "-20 K"}, "-as_built.temperature_difference=-20_K"),
        ({"output.points": ["100 m", "110.5 m"]}, "short-output.points=100_m_110.5_m"),
        ({"analysis.from": None}, "short-analysis.from=null"),
        ({"solver.scheme": {"name": "hht", "alpha": -0.1}}, "=name_hht_alpha_-0.1"),
        ({"name": "Große Linie µ"}, "Große-Linie-µ"),
        ({"name": "x" * 300}, None),
        ({"name": "線" * 100}, None),
        ({"name": "../../etc"}, "etc"),
        ({"name": "🚄"}, "scenario"),
        ({"name": "nul"}, "_nul"),
        ({"name": "COM1.txt"}, "_COM1.txt"),
        ({"output.points": list(range(100, 130))}, None),
        ({"description": "not in the name"}, "short"),
    ],
)
def test_names_are_names_of_files_on_any_system(
    short: Path, changes: dict[str, object], name: str | None
) -> None:
    folder = folder_of(library.load(short).with_(**changes))
    assert folder.parent == Path("runs")
    assert not set(folder.name) & FORBIDDEN
    assert len(folder.name.encode()) <= LONGEST
    assert folder.name.strip(". ") == folder.name
    if name is None:
        assert re.search("-[0-9a-f]{8}$", folder.name)
    else:
        assert folder.name.endswith(name)


def test_long_changes_are_told_apart(short: Path) -> None:
    scenario = library.load(short)
    points = [*range(100, 130)]
    names = {folder_of(scenario.with_(**{"output.points": [*points, last]})) for last in (140, 150)}
    assert len(names) == 2


def test_a_run_is_not_overwritten(
    arcless: Arcless, short: Path, finished: Path, never: None
) -> None:
    shutil.copytree(finished, "kept")
    before = {path.name: path.read_bytes() for path in Path("kept").iterdir()}
    done = arcless("run", short, "--out", "kept")
    refused(done, "kept: a run is in this folder: got short of ", " UTC", "`--overwrite`", "`--out")
    assert {path.name: path.read_bytes() for path in Path("kept").iterdir()} == before


@pytest.mark.parametrize("name", ["result.nc", "assessment.json", "report.html"])
def test_files_that_only_look_like_a_run_are_kept_too(
    arcless: Arcless, short: Path, never: None, name: str
) -> None:
    Path("mine").mkdir()
    Path("mine", name).write_text("my own words")
    refused(arcless("run", short, "--out", "mine"), name, "--overwrite")
    assert Path("mine", name).read_text() == "my own words"


def test_overwrite_replaces_all_of_it(arcless: Arcless, short: Path, finished: Path) -> None:
    shutil.copytree(finished, "kept")
    done = arcless("run", short, "--out", "kept", "--overwrite", "--speed", "150 km/h", *BRIEF)
    assert done.exit_code == 0, done.stderr
    assert [path.name for path in Path("kept").iterdir()] == ["result.nc"]
    assert library.open("kept").scenario.changes == {"speed": "150 km/h"}


def test_a_run_that_stopped_is_continued_in_its_own_folder(
    arcless: Arcless, short: Path, finished: Path
) -> None:
    assert arcless("run", short, "--out", "part", *BRIEF).exit_code == 0
    refused(arcless("run", short, "--out", "part"), "stopped early", "`arcless resume part`")
    shutil.copytree(finished, "kept")
    refused(arcless("resume", "part", "--out", "kept"), "a run is in this folder")
    words = ("resume", "part", "--until", "80 m", "--quiet")
    assert arcless(*words, "--out", "kept", "--overwrite").exit_code == 0
    assert arcless(*words, "--out", "part").exit_code == 0
    assert arcless("resume", "part", "--no-report", "--quiet").exit_code in RAN
    assert library.open("part").is_complete


def test_reports_replace_their_own(arcless: Arcless, finished: Path) -> None:
    shutil.copytree(finished, "kept")
    Path("kept/report.html").write_text("old")
    assert arcless("report", "kept").exit_code == 0
    assert Path("kept/report.html").read_text("utf-8").rstrip().endswith("</html>")
    for name in ("one", "other"):  # which do not have one page
        shutil.copy("kept/result.nc", f"{name}.nc")
        assert f"wrote {name}.html" in arcless("report", f"{name}.nc").stdout


def test_a_folder_of_a_study_takes_no_run_and_the_reverse(
    arcless: Arcless, short: Path, finished: Path, never: None
) -> None:
    Path("study").mkdir()
    Path("study/study.json").write_text("{}")
    refused(arcless("run", short, "--out", "study"), "a study is in this folder")
    shutil.copytree(finished, "kept")
    done = arcless("study", "run", "speed-sweep", "--out", "kept")
    refused(done, "kept: a run is in this folder")
    for word in ("status", "report", "resume", "trials"):
        refused(arcless("study", word, "kept"), "kept: run in place of a study", "arcless report")
        refused(arcless("study", word, "kept/result.nc"), "run in place of a study")
    for words in (("report",), ("assess",), ("resume",), ("explain",)):
        done = arcless(*words, "study")
        refused(done, "study: study in place of a run", "arcless study report study")


def test_two_at_once_cannot_have_one_folder(arcless: Arcless, short: Path, never: None) -> None:
    Path("out").mkdir()
    lock = hidden_files.claim_folder(Path("out"))
    assert lock is not None
    for words in ((), ("--overwrite",)):
        done = arcless("run", short, "--out", "out", *words)
        refused(done, "out: another process writes into the output folder")
    hidden_files.release(lock)
    assert list(Path("out").iterdir()) == []


def test_one_of_two_processes_is_refused(short: Path, tmp_path: Path) -> None:
    codes: list[int] = []

    def run() -> None:
        words = ("run", short, "--out", tmp_path / "out", "--no-report", "--quiet")
        done = subprocess.run(command(*words), capture_output=True, check=False, timeout=120)
        codes.append(done.returncode)

    both = [threading.Thread(target=run) for _ in range(2)]
    for one in both:
        one.start()
    for one in both:
        one.join()
    # Either is the first; where it is done before the other begins, that finds its run.
    assert sorted(code in RAN for code in codes) == [False, True]
    assert 2 in codes
    names = sorted(path.name for path in (tmp_path / "out").iterdir())
    assert names == ["assessment.json", "result.nc"]
    assert library.open(tmp_path / "out").is_complete


def test_a_run_that_comes_while_another_computes_is_kept(
    arcless: Arcless, short: Path, finished: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from arcless.cli.output import outcome

    write = outcome.write

    def late(*arguments: object, **options: object) -> object:
        shutil.copy(finished / "result.nc", "out/result.nc")  # as no Arcless does: without the lock
        return write(*arguments, **options)  # type: ignore[arg-type]

    monkeypatch.setattr(outcome, "write", late)
    refused(arcless("run", short, "--out", "out", *BRIEF), "a run is in this folder")
    assert library.open("out").is_complete
    assert [path.name for path in Path("out").iterdir()] == ["result.nc"]


def test_the_list(arcless: Arcless, short: Path, finished: Path) -> None:
    shutil.copytree(finished, "runs/mine")
    assert arcless("run", short, *BRIEF, "--speed", "150 km/h").exit_code == 0
    Path("runs/bad.nc").write_text("no result")
    Path("runs/study").mkdir()
    Path("runs/study/study.json").write_text("{}")
    done = arcless("runs")
    assert done.exit_code == 0, done.stderr
    lines = done.stdout.splitlines()
    (mine,) = [line for line in lines if line.endswith("  mine")]
    kept = json.loads((finished / "assessment.json").read_text("utf-8"))
    (pantograph,) = kept["pantographs"]
    numbers = [f"{pantograph[key]:.1f}" for key in ("mean_force_N", "std_force_N")]
    assert re.search(rf"(not )?met +160 +{numbers[0]} +{numbers[1]} ", mine)
    assert lines[lines.index(mine) + 1] == "    scenario short"
    (part,) = [line for line in lines if line.endswith("  short-speed=150_km-h")]
    assert "stopped early" in part
    assert any("unreadable: cannot read the result file" in line for line in lines)
    assert "runs/study is a study: `arcless study status runs/study`" in done.stderr
    data = json.loads(arcless("runs", "--json").stdout)
    assert data == [one.to_dict() for one in library.runs()]
    by_path = {one["path"]: one for one in data}
    assert by_path["runs/short-speed=150_km-h"]["changes"] == {"speed": "150 km/h"}
    assert by_path["runs/mine"]["pantographs"][0]["std_force_N"] == pantograph["std_force_N"]
    text = GUIDE.read_text("utf-8")
    keys = {*by_path["runs/mine"], *by_path["runs/mine"]["pantographs"][0]}
    assert [key for key in sorted(keys) if f"`{key}`" not in text] == []


def test_a_list_of_nothing(arcless: Arcless) -> None:
    done = arcless("runs")
    assert (done.exit_code, done.stdout) == (0, "")
    assert "no runs below runs" in done.stderr
    assert json.loads(arcless("runs", "--json").stdout) == []
    refused(arcless("runs", "absent"), "absent: no such folder")
    Path("file").touch()
    refused(arcless("runs", "file"), "file: no such folder: got a file")


def test_names_that_steer_a_terminal_are_not_printed(arcless: Arcless, finished: Path) -> None:
    shutil.copytree(finished, "runs/red\x1b[31m")
    assert "\x1b" not in arcless("runs").stdout


def test_the_list_waits_for_no_slow_library(finished: Path) -> None:
    modules = modules_of("runs", finished)
    assert not {name.partition(".")[0] for name in modules} & (SLOW - {"h5py"})
    assert not modules & OF_OTHERS


def test_a_problem_is_replayed_by_its_folder(arcless: Arcless) -> None:
    Path("left").mkdir()
    refused(arcless("replay", "left"), "got none", "arcless-lcp-*.json")
    problem = {"kind": "lcp", "H": [[2.0]], "w": [-1.0], "links": ["contact"]}
    Path("left/arcless-lcp-one.json").write_text(json.dumps(problem))
    by_folder = arcless("replay", "left")
    assert by_folder.exit_code == 0
    assert by_folder.stdout == arcless("replay", "left/arcless-lcp-one.json").stdout
    Path("left/arcless-lcp-two.json").write_text(json.dumps(problem))
    refused(arcless("replay", "left"), "got 2 of them")


def test_the_worked_case_of_the_guide(arcless: Arcless) -> None:
    text = GUIDE.read_text("utf-8")
    (commands,) = re.findall(r"```sh\n(.*?)```", text, re.DOTALL)
    (printed,) = re.findall(r"```text\n(.*?)```", text, re.DOTALL)
    said = ""
    for line in commands.splitlines():
        words, _, expected = line.partition("#")
        done = arcless(*shlex.split(words)[1:])
        assert done.exit_code in ((2,) if "refused" in expected else RAN), (line, done.output)
        said += done.output
    date = re.compile(r"\d{4}-\d\d-\d\d \d\d:\d\d")
    found = [date.sub("DATE", line.rstrip()) for line in said.splitlines()]
    for line in printed.splitlines():
        assert date.sub("DATE", line.rstrip()) in found, line
    (code,) = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    exec(compile(code, str(GUIDE), "exec"), {})
