"""`arcless report --animation`: what is written, and what is said where it cannot be."""

from collections.abc import Callable
from pathlib import Path

from typer.testing import Result

Run = Callable[..., Result]


def test_a_run_without_recorded_motion(arcless: Run, finished: Path) -> None:
    page = (finished / "report.html").read_bytes() if (finished / "report.html").exists() else None
    done = arcless("report", finished, "--animation")
    assert done.exit_code == 2
    assert "the run has no recorded motion" in done.stderr
    assert "--set output.motion=true" in done.stderr
    assert "Traceback" not in done.stderr
    now = (finished / "report.html").read_bytes() if (finished / "report.html").exists() else None
    assert now == page


def test_the_help_says_what_a_run_needs(arcless: Run) -> None:
    words = " ".join(arcless("report", "--help").stdout.split())
    assert "--animation" in words
    assert "output.motion=true" in words.replace("│ │ ", "")
