"""The examples run as they are printed, with less work where they offer it."""

import importlib.util
from pathlib import Path
from types import ModuleType

import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"


def load(name: str) -> ModuleType:
    spec = importlib.util.spec_from_file_location(name, EXAMPLES / f"{name}.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_every_example_is_tested() -> None:
    assert {path.stem for path in EXAMPLES.glob("*.py")} == {
        "one_run",
        "own_line",
        "sweep_of_speed",
    }


def test_one_run(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    load("one_run").main(tmp_path)
    assert {path.name for path in tmp_path.iterdir()} == {"result.nc", "report.html"}
    assert "mean force           169.3 N" in capsys.readouterr().out


def test_sweep_of_speed(capsys: pytest.CaptureFixture[str]) -> None:
    slow, fast = load("sweep_of_speed").main([200, 320])
    assert fast > slow
    assert len(capsys.readouterr().out.splitlines()) == 3


def test_own_line(capsys: pytest.CaptureFixture[str]) -> None:
    result = load("own_line").main()
    assert result.assessment.pantographs[0].contact_loss_percent == 0
    assert "span 6 dropper 6" in capsys.readouterr().out
