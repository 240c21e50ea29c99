"""The files around the package: Makefile, README, CI script, what is tracked."""

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from arcless.cli.app import app

ROOT = Path(__file__).parents[2]
TARGETS = [
    "build",
    "demo",
    "test",
    "peers",
    "evidence",
    "fuzz",
    "lint",
    "bench",
    "counts",
    "wheel",
    "clean",
]


def make(*words: str, path: str | None = None) -> subprocess.CompletedProcess[str]:
    environment = {"PATH": path} if path else None
    return subprocess.run(
        [str(shutil.which("make")), "--no-print-directory", *words],
        cwd=ROOT,
        env=environment,
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )


@pytest.fixture
def poor_path(tmp_path: Path) -> Path:
    """Return a folder with the plain tools and neither Python nor Rust."""
    for tool in ["sh", "sed", "sort", "printf", "cut", "env", "find", "expand", "grep"]:
        found = shutil.which(tool)
        if found:
            (tmp_path / tool).symlink_to(found)
    return tmp_path


def test_help_lists_every_target() -> None:
    listed = make("help").stdout
    assert all(f"make {target}" in listed for target in TARGETS)


@pytest.mark.parametrize("target", TARGETS)
def test_targets_expand(target: str) -> None:
    assert make("--dry-run", target).returncode == 0


def test_missing_python_is_one_sentence(poor_path: Path) -> None:
    done = make("check-python", path=str(poor_path))
    assert done.returncode != 0
    assert "make: Python 3.11 or newer is missing" in done.stderr + done.stdout


def test_old_python_is_one_sentence(poor_path: Path) -> None:
    old = poor_path / "python3"
    old.write_text('#!/bin/sh\n[ "$1" = --version ] && echo Python 3.9.2 && exit 0\nexit 1\n')
    old.chmod(0o755)
    done = make("check-python", "PYTHON=python3", path=str(poor_path))
    assert "make: Python 3.9.2 is too old" in done.stderr + done.stdout


def test_missing_and_old_rust_are_one_sentence(poor_path: Path) -> None:
    done = make("check-rust", path=str(poor_path))
    assert "the Rust toolchain" in done.stderr + done.stdout
    for tool in ("cargo", "rustc"):
        (poor_path / tool).write_text('#!/bin/sh\necho "rustc 1.60.0 (abc 2022-04-04)"\n')
        (poor_path / tool).chmod(0o755)
    done = make("check-rust", path=str(poor_path))
    assert "make: rustc 1.60.0 is too old" in done.stderr + done.stdout


def test_readme_names_only_what_exists() -> None:
    text = (ROOT / "README.md").read_text("utf-8")
    commands = {command.callback.__name__ for command in app.registered_commands}
    commands |= {group.name for group in app.registered_groups}
    assert set(re.findall(r"`?arcless ([a-z]+)", text)) <= commands
    assert commands <= set(re.findall(r"`arcless ([a-z]+)", text))
    assert set(re.findall(r"\bmake ([a-z]+)", text)) <= set(TARGETS)
    for target in re.findall(r"\]\(([^)#]+)\)", text):
        assert (ROOT / target).exists(), target


def test_docs_link_to_files_that_exist() -> None:
    for page in (ROOT / "docs").rglob("*.md"):
        for target in re.findall(r"\]\(([^)#:]+)\)", page.read_text("utf-8")):
            assert (page.parent / target).exists(), f"{page}: {target}"


def test_every_page_is_reached_from_the_index() -> None:
    docs = ROOT / "docs"
    linked = set(re.findall(r"\]\(([^)#:]+)\)", (docs / "index.md").read_text("utf-8")))
    pages = {str(page.relative_to(docs)) for page in docs.rglob("*.md")} - {"index.md"}
    assert pages <= linked


def test_ci_runs_lint_and_tests() -> None:
    script = (ROOT / ".ci/run").read_text("utf-8")
    assert "set -euo pipefail" in script
    assert script.index("make lint") < script.index("make test")
    assert "make counts" in script
