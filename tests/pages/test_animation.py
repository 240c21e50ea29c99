"""The page on animations: its commands run, and print what is shown."""

import shlex
from pathlib import Path

import pytest
from typer.testing import CliRunner

from arcless.cli.app import app
from tests.pages.test_export_and_own_models import blocks


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Work in an empty folder, with a player that stands for the built one."""
    monkeypatch.chdir(tmp_path)
    from arcless.studio.animation import animation

    player = tmp_path / "player"
    player.mkdir()
    (player / "animation.js").write_text("void 0;")
    (player / "animation.css").write_text("")
    monkeypatch.setattr(animation, "FOLDER", player)


def test_animations() -> None:
    printed = ""
    for _, language, text in blocks("animation.md"):
        if language == "sh":
            for line in text.splitlines():
                done = CliRunner().invoke(app, shlex.split(line)[1:])
                assert done.exit_code in (0, 3), (line, done.stderr)  # 3: a limit is not met
                printed = done.stdout
        elif language == "text":
            assert printed == text
        else:
            exec(compile(text, "animation.md", "exec"), {})
    pages = {name: Path(name).read_text("utf-8") for name in ("run/report.html", "moving.html")}
    assert all('id="animation-data"' in page for page in pages.values())
    assert len(pages["moving.html"]) < len(pages["run/report.html"])
