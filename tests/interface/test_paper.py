"""`--pdf`: reports on paper by the command line, and what is refused."""

from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import Result

from tests.support.pdf import text_of

pytest.importorskip("typst", reason="typst is not installed")
Run = Callable[..., Result]


def test_the_report_of_a_run(arcless: Run, finished: Path, tmp_path: Path) -> None:
    before = {file.name: file.stat().st_mtime_ns for file in finished.iterdir()}
    done = arcless(
        "report", finished, "--pdf", "run.pdf", "--field", "author=A. Smith", "--field", "Project=7"
    )
    assert done.exit_code == 0, done.output
    assert done.stdout == "wrote run.pdf\n"
    assert {file.name: file.stat().st_mtime_ns for file in finished.iterdir()} == before
    text = text_of(tmp_path / "run.pdf")
    for word in ("A. Smith", "Project", "Signature".lower(), "Defaults of Arcless", "page 2 of"):
        assert word in text
    assert "The command that computes this run" in text


@pytest.mark.evidence
def test_page_and_file_together(arcless: Run, finished: Path, tmp_path: Path) -> None:
    done = arcless("report", finished, "--out", "run.html", "--pdf", "run.pdf")
    assert done.stdout == "wrote run.html\nwrote run.pdf\n"
    assert (tmp_path / "run.html").read_bytes().startswith(b"<!DOCTYPE html>")
    assert (tmp_path / "run.pdf").read_bytes().startswith(b"%PDF-1.7")


@pytest.mark.evidence
def test_an_old_file_is_replaced_and_the_new_one_is_always_the_same(
    arcless: Run, finished: Path, tmp_path: Path
) -> None:
    file = tmp_path / "run.pdf"
    found = []
    for name in ("result.nc", ""):
        file.write_text("old")
        assert arcless("report", finished / name, "--pdf", "run.pdf").exit_code == 0
        found.append(file.read_bytes())
    assert found[0] == found[1]
    assert [one.name for one in tmp_path.iterdir()] == ["run.pdf"]


@pytest.mark.evidence
def test_the_comparison(arcless: Run, finished: Path, short: Path, tmp_path: Path) -> None:
    arcless("run", short, "--set", "speed=140 km/h", "--out", "slower", "--no-report", "--quiet")
    done = arcless("compare", finished, "slower", "--pdf", "both.pdf")
    assert done.exit_code == 0, done.output
    assert done.stdout.endswith("wrote both.pdf\n")
    assert "speed 140 km/h" in text_of(tmp_path / "both.pdf")
    assert not list(tmp_path.glob("*.html"))


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("--pdf", "run.txt"), "expected a name that ends in .pdf"),
        (("--pdf", "none/run.pdf"), "no folder"),
        (("--pdf", "run.pdf", "--field", "author"), "expected name=value"),
        (("--field", "author=A"), "give --pdf FILE"),
    ],
)
def test_refused_before_anything_is_read(
    arcless: Run, tmp_path: Path, words: tuple[str, ...], told: str
) -> None:
    for command in (("report", "no-run"), ("compare", "no-run", "no-other"),
                    ("study", "report", "no-study")):  # fmt: skip
        done = arcless(*command, *words)
        assert done.exit_code == 2
        assert told in str(done.exception or "") + done.output
    assert not list(tmp_path.iterdir())
