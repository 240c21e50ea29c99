"""The page on loads and stress: its commands run, and print what is shown."""

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from arcless.cli.app import app
from tests.pages.test_export_and_own_models import blocks, run

PAGE = "supports-and-stress.md"


def test_the_page(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    printed = ""
    for _, language, text in blocks(PAGE):
        if language == "sh":
            printed = run(text)
        elif language == "python":
            capsys.readouterr()
            exec(compile(text, PAGE, "exec"), {})
            printed = capsys.readouterr().out
        else:
            assert printed.startswith(text)
    assert "S_eq" in printed
    assert Path("statics.html").is_file()


def test_the_page_names_what_there_is() -> None:
    from arcless.dataset.recorded_series import series_of

    page = (Path(__file__).parents[2] / "docs/guide" / PAGE).read_text("utf-8")
    assert all(f"`{name}`" in page for name in series_of("support"))
    told = CliRunner().invoke(app, ["statics", "en50318-ac-simple-320", "--json", "--quiet"])
    found = json.loads(told.stdout)
    own = ("span", "tension_length", "from_m", "to_m", "wire", "area_mm2")
    keys = {key for part in ("spans", "wires") for key in found[part][0]} - set(own)
    assert all(f"`{key}`" in page for key in keys)
