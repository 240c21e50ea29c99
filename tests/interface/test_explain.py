"""`arcless explain`: what it prints and writes, its guide, and what it refuses."""

import json
import re
import shlex
from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import Result

from tests.interface.test_start import OF_OTHERS, SLOW, modules_of

GUIDE = Path(__file__).parents[2] / "docs" / "guide" / "why-sigma.md"
Run = Callable[..., Result]


def test_sentences_tables_page_and_data(arcless: Run, finished: Path, tmp_path: Path) -> None:
    done = arcless("explain", finished, "--out", "page.html")
    assert done.exit_code == 0, done.output
    for words in (
        "σ is ",
        "Parts of the variance σ²",
        "span passing",
        "Largest deviations from F_m",
    ):
        assert words in done.stdout
    assert "wrote page.html" in done.stdout
    page = (tmp_path / "page.html").read_text("utf-8")
    data = json.loads(arcless("explain", finished, "--json").stdout)
    for text in data["sentences"]:
        assert text in page
    (one,) = data["pantographs"]
    numbers = json.loads((finished / "assessment.json").read_text("utf-8"))["pantographs"][0]
    assert one["std_force_N"] == pytest.approx(numbers["std_force_N"], rel=1e-12)  # rounding
    variance = sum(part["variance_N2"] for part in one["groups"])
    assert variance == pytest.approx(numbers["std_force_N"] ** 2, rel=1e-9)  # rounding
    assert data["sensitivities"] is None


def test_the_file_is_as_good_as_the_folder(arcless: Run, finished: Path) -> None:
    by_file = arcless("explain", finished / "result.nc")
    assert by_file.stdout == arcless("explain", finished).stdout


def test_the_report_has_the_same_sentences(arcless: Run, finished: Path) -> None:
    page = (finished / "report.html").read_text("utf-8")
    for text in json.loads(arcless("explain", finished, "--json").stdout)["sentences"]:
        assert text in page


def test_sensitivities_are_asked_for(arcless: Run, finished: Path) -> None:
    done = arcless("explain", finished, "--sensitivity", "--step", "2", "--json", "--quiet")
    assert done.exit_code == 0, done.output
    data = json.loads(done.stdout)
    known = data["sensitivities"]
    assert known["step_percent"] == 2.0
    assert known["runs"] == 1 + 4 * len(known["parameters"])
    assert {"dropper stiffness", "tension of the contact wire"} <= {
        one["parameter"] for one in known["parameters"]
    }
    assert len(data["sentences"]) == 3
    text = GUIDE.read_text("utf-8")
    assert [key for key in keys_of(data) if f"`{key}`" not in text] == []


def keys_of(data: object) -> set[str]:
    """Return all keys of plain data."""
    if isinstance(data, dict):
        return set(data).union(*map(keys_of, data.values()))
    return set().union(*map(keys_of, data)) if isinstance(data, list) else set()


@pytest.mark.evidence
def test_the_worked_case_of_the_guide(arcless: Run) -> None:
    text = GUIDE.read_text("utf-8")
    commands = re.findall(r"```sh\n(.*?)```", text, re.DOTALL)
    printed = re.findall(r"```text\n(.*?)```", text, re.DOTALL)
    assert len(commands) == len(printed) == 2
    for block, lines in zip(commands, printed, strict=True):
        for line in block.splitlines():
            done = arcless(*shlex.split(line)[1:])
            assert done.exit_code in (0, 3), done.output
        for line in lines.splitlines():
            assert line in done.stdout.splitlines()
    assert Path("why.html").is_file()
    (code,) = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    exec(compile(code, str(GUIDE), "exec"), {})


def refused(done: Result, *words: str) -> None:
    assert done.exit_code == 2, done.output
    assert not done.stdout
    for word in words:
        assert word in done.stderr


def test_what_is_refused(arcless: Run, short: Path, finished: Path, tmp_path: Path) -> None:
    refused(arcless("explain", "nowhere"), "nowhere")
    refused(arcless("explain", short), "short.yaml")
    refused(
        arcless("explain", finished, "--sensitivity", "--step", "80"), "got 80 %", "0.1 to 30 %"
    )
    refused(
        arcless("explain", finished, "--out", tmp_path / "no" / "page.html"), "cannot be written"
    )


def test_a_short_section_is_refused_before_anything_is_run(
    arcless: Run, short: Path, tmp_path: Path
) -> None:
    done = arcless(
        "run", short, "--set", "analysis.from=130 m", "--set", "analysis.to=180 m",
        "--out", "brief", "--quiet",
    )  # fmt: skip
    assert done.exit_code in (0, 3), done.output
    refused(arcless("explain", "brief", "--sensitivity"), "too short", "at least 2 spans")
    page = (tmp_path / "brief" / "report.html").read_text("utf-8")
    assert "Contributions to σ" not in page


def test_a_run_that_stopped_early_says_so(arcless: Run, short: Path) -> None:
    done = arcless("run", short, "--until", "170 m", "--out", "part", "--quiet")
    assert done.exit_code == 0, done.output
    done = arcless("explain", "part")
    if done.exit_code == 0:
        assert "the run stopped early" in done.stdout
    else:
        refused(done, "too short")


def test_it_loads_nothing_that_runs(finished: Path) -> None:
    modules = modules_of("explain", finished)
    assert not {name.partition(".")[0] for name in modules} & (SLOW - {"h5py"})
    assert not modules & OF_OTHERS
