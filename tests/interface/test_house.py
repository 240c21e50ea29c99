"""The files around the package: targets of make, links of pages, folders of tests."""

import re
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
TARGETS = re.findall(r"^([a-z]+):.* ## ", (ROOT / "Makefile").read_text("utf-8"), re.MULTILINE)


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


def test_every_target_is_listed_and_expands() -> None:
    assert len(TARGETS) > 5
    listed = make("help").stdout
    assert all(f"make {target}" in listed for target in TARGETS)
    assert make("--dry-run", *TARGETS).returncode == 0


def test_the_demo_replaces_its_own_run() -> None:
    said = make("--dry-run", "demo").stdout
    assert "arcless run en50318-ac-simple-320 " in said and " --overwrite " in said


@pytest.mark.parametrize("tool", ["python", "rust"])
def test_a_tool_that_is_missing_stops_make(poor_path: Path, tool: str) -> None:
    done = make(f"check-{tool}", path=str(poor_path))
    assert done.returncode != 0
    assert "Traceback" not in done.stderr


def test_a_tool_that_is_too_old_stops_make(poor_path: Path) -> None:
    for name, says in (("python3", "Python 3.9.2"), ("cargo", ""), ("rustc", "rustc 1.60.0 (a)")):
        old = poor_path / name
        old.write_text(f'#!/bin/sh\n[ "$1" = --version ] && echo {says!r} && exit 0\nexit 1\n')
        old.chmod(0o755)
    assert make("check-python", "PYTHON=python3", path=str(poor_path)).returncode != 0
    assert make("check-rust", path=str(poor_path)).returncode != 0


def test_links_lead_to_files_that_exist() -> None:
    for page in (ROOT / "README.md", *(ROOT / "docs").rglob("*.md")):
        for target in re.findall(r"\]\(([^)#:]+)\)", page.read_text("utf-8")):
            assert (page.parent / target).exists(), f"{page}: {target}"


def test_every_page_is_reached_from_the_index() -> None:
    docs = ROOT / "docs"
    reached: set[Path] = set()
    todo = [docs / "index.md"]
    while todo:
        page = todo.pop()
        if page in reached:
            continue
        reached.add(page)
        # Pages that list others; a link in the text of a guide is no way to find a page.
        if page.name == "index.md":
            targets = re.findall(r"\]\(([^)#:]+)\)", page.read_text("utf-8"))
            todo += [path for t in targets if (path := (page.parent / t).resolve()).suffix == ".md"]
    assert set(docs.rglob("*.md")) <= reached


def test_folders_of_unit_tests_are_those_of_the_package() -> None:
    tests, package = ROOT / "tests" / "unit", ROOT / "python" / "arcless"
    folders = {path.parent.relative_to(tests) for path in tests.rglob("test_*.py")}
    assert len(folders) > 10
    assert not {folder for folder in folders if not (package / folder).is_dir()}
