"""The page on recorded motion: its commands and programs run as they stand there."""

import re
import shlex
from pathlib import Path

import pytest
from typer.testing import CliRunner

from arcless.cli.app import app
from arcless.model.files.yaml_reader import parse
from arcless.model.settings.run_settings import Output

PAGE = Path(__file__).parents[2] / "docs/guide/motion.md"


def test_the_page(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    for language, text in re.findall(r"```(\w+)\n(.*?)```", PAGE.read_text("utf-8"), re.S):
        if language == "sh":
            done = CliRunner().invoke(app, shlex.split(text)[1:])
            assert done.exit_code in (0, 3), done.stderr
            assert Path("moving/result.nc").is_file()
        elif language == "yaml":
            data, _ = parse(text, "page")
            assert Output.model_validate(data["output"]).motion is not None
        else:
            exec(compile(text, str(PAGE), "exec"), names)
    assert "uplift up to" in capsys.readouterr().out


def test_the_size_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    scenario = "en50318-ac-simple-320-planar"
    words = ["run", scenario, "--set", "output.motion=true", "--no-report"]
    done = CliRunner().invoke(app, [*words, "--until", "150 m"])
    told = r"the motion of the wires is recorded every 10 ms: [\d.]+ MB"
    assert re.search(told, done.stderr), done.stderr
