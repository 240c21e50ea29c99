"""`arcless compare`: what it prints and writes, its guide, and what it refuses."""

import json
import re
import shlex
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import Result

from tests.interface.test_start import OF_OTHERS, SLOW, modules_of

GUIDE = Path(__file__).parents[2] / "docs" / "guide" / "compare.md"
Run = Callable[..., Result]


@pytest.fixture
def pair(arcless: Run, short: Path, finished: Path, tmp_path: Path) -> tuple[Path, Path]:
    """Return the folders of the short run and of a slower one."""
    slower = tmp_path / "slower"
    done = arcless(
        "run", short, "--set", "speed=140 km/h", "--out", slower, "--no-report", "--quiet"
    )
    assert done.exit_code in (0, 3), done.output
    return finished, slower


def test_tables_page_and_data(arcless: Run, pair: tuple[Path, Path], tmp_path: Path) -> None:
    done = arcless("compare", *pair, "--out", "page.html")
    assert done.exit_code == 0, done.output
    for word in ("Changed fields", "speed 140 km/h", "standard deviation σ", "not judged"):
        assert word in done.stdout
    assert "wrote page.html" in done.stdout
    assert "<canvas" not in (page := (tmp_path / "page.html").read_text("utf-8"))
    assert "Main differences" in page
    data = json.loads(arcless("compare", *pair, "--json").stdout)
    (field,) = data["fields"]
    assert field["values"] == ["160 km/h", "140 km/h"]
    by_key = {one["key"]: one for one in data["indicators"]}
    for place, folder in enumerate(pair):
        numbers = json.loads((folder / "assessment.json").read_text("utf-8"))
        assert by_key["std_force_N"]["values"][place] == numbers["pantographs"][0]["std_force_N"]
        assert (
            by_key["max_uplift_at_support_mm"]["values"][place]
            == numbers["max_uplift_at_support_mm"]
        )


def test_two_runs_with_long_names_fit_eighty_columns(
    arcless: Run, pair: tuple[Path, Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    names = [f"norway-s25-250-speed={v}_km-h,line.contact_wire.tension=15_kN" for v in (160, 140)]
    for name, folder in zip(names, pair, strict=True):
        shutil.copytree(folder, name)
    lines = arcless("compare", *names).stdout.replace("\u00a0", " ").splitlines()
    text = "\n".join(lines)
    assert "…" not in text
    origins = [line for line in lines if "SHA-256" in line]
    assert [one.rpartition(" (")[0] for one in origins] == [
        f"speed {v} km/h: {name}/result.nc" for v, name in zip((160, 140), names, strict=True)
    ]
    assert max(len(line) for line in lines if line not in origins) <= 80
    # The section of each run; value and limit of a criterion with the verdict below; one footnote.
    assert len(re.findall(r"^  speed 1[46]0 km/h .* \d+ to \d+ m ", text, re.M)) == 2
    (row,) = [k for k, line in enumerate(lines) if re.search(r"σ .*\d / \d.*\d / \d", line)
              and "statistical" not in line]  # fmt: skip
    assert len(re.findall(r"met", lines[row + 1])) == 2
    assert text.count("of the unrounded numbers") == 1
    # A difference stands below the value of its run, flush right.
    mean = next(k for k, line in enumerate(lines) if "mean contact force F_m  " in line)
    assert re.fullmatch(r" {30,}[+−]?\d+\.\d \([+−]?\d+\.\d %\)", lines[mean + 1])
    assert len(lines[mean + 1]) == len(lines[mean])


def test_heads_of_the_page_wrap(arcless: Run, pair: tuple[Path, Path], tmp_path: Path) -> None:
    arcless("compare", *pair, "--out", "page.html")
    page = (tmp_path / "page.html").read_text("utf-8")
    assert "table.runs thead th.number { white-space: normal;" in page
    for title in ("Main differences", "Verdicts"):
        assert re.search(
            rf'<h3>{title}</h3>\s*<div class="scroll"><table class="narrow runs">', page
        )


def test_the_file_is_as_good_as_the_folder(arcless: Run, pair: tuple[Path, Path]) -> None:
    files = [folder / "result.nc" for folder in pair]
    assert arcless("compare", *files).stdout == arcless("compare", *pair).stdout


def test_the_guide_names_every_key(arcless: Run, pair: tuple[Path, Path]) -> None:
    text = GUIDE.read_text("utf-8")
    data = json.loads(arcless("compare", *pair, "--json").stdout)
    keys = set(data)
    for part in ("runs", "pantographs", "indicators", "criteria", "fields"):
        keys |= set(data[part][0])
    assert [key for key in sorted(keys) if f"`{key}`" not in text] == []


def test_the_worked_case_of_the_guide(arcless: Run) -> None:
    (commands,) = re.findall(r"```sh\n(.*?)```", GUIDE.read_text("utf-8"), re.DOTALL)
    (printed,) = re.findall(r"```text\n(.*?)```", GUIDE.read_text("utf-8"), re.DOTALL)
    for line in commands.splitlines():
        done = arcless(*shlex.split(line)[1:])
        assert done.exit_code in (0, 3), done.output
    for line in printed.splitlines():
        assert line.rstrip() in done.stdout.splitlines()
    assert Path("compare.html").is_file()
    (code,) = re.findall(r"```python\n(.*?)```", GUIDE.read_text("utf-8"), re.DOTALL)
    exec(compile(code, str(GUIDE), "exec"), {})


def refused(done: Result, *words: str) -> None:
    assert done.exit_code == 2, done.output
    assert not done.stdout
    for word in words:
        assert word in done.stderr


def test_what_is_refused(arcless: Run, finished: Path, short: Path, tmp_path: Path) -> None:
    refused(arcless("compare"), "RUN")
    refused(arcless("compare", finished), "at least two")
    refused(arcless("compare", finished, finished / "result.nc"), "twice")
    refused(arcless("compare", finished, "none.nc"), "none.nc")
    refused(arcless("compare", finished, short), "arcless run")
    (tmp_path / "bad.nc").write_bytes(b"not a result")
    refused(arcless("compare", finished, "bad.nc"), "bad.nc")
    (tmp_path / "study").mkdir()
    (tmp_path / "study" / "journal.db").touch()
    refused(arcless("compare", finished, "study"), "arcless study report")
    (tmp_path / "empty").mkdir()
    refused(arcless("compare", finished, "empty"), "empty")
    copies = [shutil.copy(finished / "result.nc", tmp_path / f"{i}.nc") for i in range(7)]
    refused(arcless("compare", *copies, "--out", "page.html"), "at most 6")
    assert not (tmp_path / "page.html").exists()
    refused(arcless("compare", *copies[:2], "--out", "no/page.html"), "no/page.html")


def test_a_run_that_stopped_is_refused(arcless: Run, finished: Path, short: Path) -> None:
    arcless("run", short, "--until", "120 m", "--out", "stopped", "--quiet")
    refused(arcless("compare", finished, "stopped"), "arcless resume")


def test_tables_wait_for_no_slow_library(finished: Path, tmp_path: Path) -> None:
    copy = shutil.copy(finished / "result.nc", tmp_path / "copy.nc")
    modules = modules_of("compare", finished, copy)
    assert not {name.partition(".")[0] for name in modules} & (SLOW - {"h5py", "scipy"})
    assert not modules & OF_OTHERS
