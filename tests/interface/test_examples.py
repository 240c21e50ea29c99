"""The examples run as they are printed, with less work where they offer it."""

import importlib.util
import json
from pathlib import Path
from types import ModuleType

import numpy as np
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
        "bench_in_the_loop",
        "control_baselines",
        "controlled",
        "coupled_fmus",
        "figures_for_paper",
        "dropped_beam",  # tests/unit/test_published.py
        "one_run",
        "own_line",
        "sweep_of_speed",
        "tension_coupling",
    }


def test_one_run(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    load("one_run").main(tmp_path)
    assert {path.name for path in tmp_path.iterdir()} == {"result.nc", "report.html"}
    assert "mean force           169.3 N" in capsys.readouterr().out


def test_figures_for_paper(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    load("figures_for_paper").main(tmp_path, "en50318-ac-simple-320-planar")
    assert {path.name for path in tmp_path.iterdir()} == {"lead.svg", "spectrum.pdf", "two.png"}
    assert all(path.stat().st_size > 0 for path in tmp_path.iterdir())
    lines = capsys.readouterr().out.splitlines()
    assert "lead             Contact force around the worst place" in lines
    assert "lateral          none in this run" in lines


def test_sweep_of_speed(capsys: pytest.CaptureFixture[str]) -> None:
    slow, fast = load("sweep_of_speed").main([200, 320])
    assert fast > slow
    assert len(capsys.readouterr().out.splitlines()) == 3


def test_own_line(capsys: pytest.CaptureFixture[str]) -> None:
    result = load("own_line").main()
    assert result.assessment.pantographs[0].contact_loss_percent == 0
    assert "span 6 dropper 6" in capsys.readouterr().out


@pytest.mark.evidence
def test_tension_coupling(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    figure = tmp_path / "figure.svg"
    found = load("tension_coupling").main([10e3, 20e3], str(figure))
    assert figure.stat().st_size > 0
    # A string on hangers is between a free one (z ∝ 1/T) and one on a bed (T^−½); along the wire
    # it is drawn by ½∫z′², between T^−2 and T^−1½.
    assert 2**0.5 < found["z"][0] / found["z"][1] < 2
    assert 2**1.5 < found["drawn"][0] / found["drawn"][1] < 2**2
    # Far below its first longitudinal mode the wire does not stretch: 2 % are left of that.
    assert found["slow"] == pytest.approx([1, 1], abs=0.03)
    assert min(found["r"]) > 0.99
    assert len(capsys.readouterr().out.splitlines()) == 7


def test_controlled(capsys: pytest.CaptureFixture[str]) -> None:
    found = load("controlled").main([0, 40])
    assert found["PID, 0 ms late"] < found["not controlled"] < found["PID, 40 ms late"]
    assert len(capsys.readouterr().out.splitlines()) == 6


@pytest.mark.evidence
def test_control_baselines(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    example, files = load("control_baselines"), []
    case = "en50318-ac-simple-320-planar"
    for folder in (tmp_path / "one", tmp_path / "two"):
        monkeypatch.setattr(example, "LAWS", folder)
        found = example.main(["--learn", "--generations", "1", "2", "--case", case])
        files.append(json.loads((folder / f"{case}.json").read_text("utf-8")))
    assert files[0]["law"] == files[1]["law"]  # the same seed, the same bits
    assert files[0]["about"]["pid"] == files[1]["about"]["pid"]
    assert example.PID_SEES not in files[0]["law"]["observe"]
    # A first guess of the search already damps; ten minutes of it: docs/guide/learning-control.md.
    assert found[case, "learnt"]["std"] < found[case, "none"]["std"]
    assert found[case, "learnt"]["mean"] == pytest.approx(found[case, "none"]["mean"], abs=3.0)
    # In the lead of each of the two runs a line of what it took, a head and four laws.
    assert len(capsys.readouterr().out.splitlines()) == 2 * (1 + 1 + 4)


@pytest.mark.parametrize("case", list(load("control_baselines").CASES))
def test_the_laws_that_are_shipped_are_those_of_their_cases(case: str) -> None:
    example = load("control_baselines")
    law = json.loads((example.LAWS / f"{case}.json").read_text("utf-8"))
    assert law["task"]["scenario"] == case
    assert tuple(law["law"]["observe"]) == example.OBSERVE


@pytest.mark.evidence
def test_bench_in_the_loop(capsys: pytest.CaptureFixture[str]) -> None:
    found = load("bench_in_the_loop").main()
    # Two programs in a loop, one step apart, and one model. The step of delay makes σ larger in
    # proportion to the step: by 1.6 N at 2 ms, 0.7 N here, 0.3 N at 0.5 ms and 0.1 N at 0.25 ms.
    assert np.mean(found["bench"]) == pytest.approx(np.mean(found["run"]), abs=0.5)
    assert np.std(found["bench"]) == pytest.approx(np.std(found["run"]), abs=1.0)
    assert len(capsys.readouterr().out.splitlines()) == 3


def test_coupled_fmus(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    example = load("coupled_fmus")
    monkeypatch.setattr(example, "STIFFNESSES", (50e3,))
    example.main(0.2)
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "contact of 50 kN/m, 200 steps"
    assert len(lines) == 7
    # As in tests/unit/fmi/export/test_coupled.py.
    assert all(float(line.split()[-3]) < 1e-9 for line in lines[1:3])
    assert lines[-1].startswith("  plain exchange every 10 ms: at most ")
