"""Pantographs that are FMUs on the command line: checked without their code, run when allowed."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from typer.testing import Result

import arcless as package
from tests.support import fmus

Arcless = Callable[..., Result]
pytestmark = fmus.can_run
SHORT = Path(__file__).parent / "data" / "short.yaml"
MODEL = """\
format: arcless-pantograph/1
name: from-elsewhere
fmu:
  file: pantograph.fmu
  static_force: static_force
static_force: 80 N
"""


@pytest.fixture
def scenario(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Write a short scenario with an FMU that crashes after half a second into a folder."""
    monkeypatch.delenv("ARCLESS_ALLOW_FMU", raising=False)
    fmus.fmu(tmp_path, faults=("CRASH=0.5",))
    (tmp_path / "pantograph.yaml").write_text(MODEL, encoding="utf-8")
    head, _, rest = SHORT.read_text("utf-8").partition("pantographs:\n")
    tail = rest[rest.index("speed:") :]
    file = tmp_path / "mine.yaml"
    placed = "pantographs:\n  - {model: pantograph.yaml, static_force: 80 N}\n"
    file.write_text(f"{head}{placed}{tail}", encoding="utf-8")
    return file


def test_check_loads_no_code(arcless: Arcless, scenario: Path) -> None:
    folder = scenario.parent
    stub = {"linux64": folder / "stub.so", "darwin64": folder / "stub.so"}
    (folder / "stub.so").write_bytes(b"not a library")
    fmus.pack(folder / "pantograph.fmu", fmus.description(), stub)
    found = arcless("check", scenario)
    assert found.exit_code == 0, found.stderr
    assert "valid scenario `short`" in found.stdout
    found = arcless("check", folder / "pantograph.yaml")
    assert (
        found.stdout
        == f"{folder}/pantograph.yaml: valid pantograph `from-elsewhere`, FMU pantograph.fmu\n"
    )


def test_check_says_what_does_not_fit(arcless: Arcless, scenario: Path) -> None:
    fmus.fmu(scenario.parent, causalities={"strip_height": "input"})
    found = arcless("check", scenario)
    assert found.exit_code == 2
    assert (
        "fmu.strip_height: a variable of another causality: got strip_height, input" in found.stderr
    )


def test_a_run_asks_for_consent_and_tells_a_crash(
    arcless: Arcless, scenario: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(scenario.parent)
    refused = arcless("run", scenario, "--out", "out", "--no-report")
    assert refused.exit_code == 1
    assert "is an FMU, and FMUs are not allowed to run" in refused.stderr
    assert not Path("out").exists()
    crashed = arcless("run", scenario, "--out", "out", "--no-report", "--allow-fmu")
    assert crashed.exit_code == 1
    assert "pantograph P1, t = 0.5 s, 72.22 m" in crashed.stderr
    assert "the FMU is gone: got it crashed (segmentation fault)" in crashed.stderr
    assert not Path("out").exists()


def test_a_run_is_kept_with_its_command(arcless: Arcless, scenario: Path) -> None:
    fmus.fmu(scenario.parent)
    out = scenario.parent / "out"
    found = arcless("run", scenario, "--out", out, "--no-report", "--allow-fmu", "--quiet")
    assert found.exit_code in (0, 3), found.stderr
    kept: Any = package.open(out / "result.nc")
    assert kept.metadata["command"] == f"arcless run {scenario} --allow-fmu"
    assert kept.metadata["fmus"]["P1"]["sha256"] == kept.scenario.pantographs[0].model.fmu.sha256
    assert arcless("report", out).exit_code == 0


@pytest.mark.parametrize("choice", [("--given", "control-force"), ("--pantograph", "P1")])
def test_an_exported_file_holds_no_fmu(
    arcless: Arcless, scenario: Path, choice: tuple[str, str]
) -> None:
    found = arcless("fmu", "export", scenario, "--out", "line.fmu", *choice)
    assert found.exit_code == 2
    assert (
        "pantographs.0.model.fmu: pantograph P1 is an FMU, which an exported file cannot hold: got "
        f"{scenario.parent / 'pantograph.fmu'}, expected a pantograph of masses or matrices; hint: "
        "export the line alone"
    ) in found.stderr
    assert not (scenario.parent / "line.fmu").exists()


@pytest.mark.parametrize("given", ["contact-force", "strip-height"])
def test_its_line_is_exported_without_loading_code(
    arcless: Arcless, scenario: Path, given: str
) -> None:
    folder = scenario.parent
    (folder / "stub.so").write_bytes(b"not a library")
    stub = dict.fromkeys(("linux64", "darwin64"), folder / "stub.so")
    fmus.pack(folder / "pantograph.fmu", fmus.description(), stub)
    found = arcless("fmu", "export", scenario, "--out", folder / "line.loop", "--given", given)
    assert found.exit_code == 0, found.stderr
    assert f"P1.{given.replace('-', '_')}" in found.stdout.splitlines()[0]
