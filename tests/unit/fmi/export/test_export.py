"""Files of exports: what the standard asks of them, variables, the same bytes."""

import ctypes
import json
import re
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import fmpy
import pytest
from fmpy.validation import validate_fmu

import arcless
from arcless import ModelError, OutputError
from arcless.fmi import copy_library, export_fmu, export_model
from arcless.fmi.export import library
from arcless.model import Scenario
from tests.support.exported import driven

Fmu = Callable[..., Path]
Short = Callable[..., Scenario]
CHOICES: list[dict[str, Any]] = [
    {"given": "contact-force"},
    {"given": "strip-height", "travel": "position"},
    {"given": "control-force"},
    {"pantograph": "P1"},
]
HEAD = {
    "strips": 2,
    "strip_spacing": "0.3 m",
    "half_length": "0.6 m",
    "mass": "3 kg",
    "stiffness": "5 kN/m",
    "damping": "10 N s/m",
}


@pytest.mark.parametrize("version", [2, 3])
@pytest.mark.parametrize("choice", CHOICES, ids=[json.dumps(choice) for choice in CHOICES])
def test_fmpy_has_nothing_to_say(fmu: Fmu, version: int, choice: dict[str, Any]) -> None:
    path = fmu(version, **choice)
    assert validate_fmu(str(path)) == []
    with driven(path) as run:
        assert run.fmu.getVersion() == f"{version}.0"
        for variable in run.description.modelVariables:
            assert variable.description
            assert variable.unit or variable.name == "old_weight"
        run.step()
        assert all(abs(value) < 1e9 for value in run.get(*run.outputs()))
        assert run.value("time") == run.h


def test_the_archive_has_what_belongs_in_it(fmu: Fmu) -> None:
    with zipfile.ZipFile(fmu(2)) as file:
        assert file.testzip() is None
        names = set(file.namelist())
    assert {"modelDescription.xml", "resources/model.loop", "documentation/index.html"} <= names
    assert any(name.startswith("binaries/linux64/arcless_loop") for name in names)
    with zipfile.ZipFile(fmu(3)) as file:
        assert any(name.startswith("binaries/x86_64-linux/") for name in file.namelist())


def test_the_same_scenario_gives_the_same_bytes(scenario: Scenario, tmp_path: Path) -> None:
    first = export_fmu(scenario, tmp_path / "a.fmu")
    second = export_fmu(scenario, tmp_path / "b.fmu")
    assert first.path.read_bytes() == second.path.read_bytes()
    other = export_fmu(scenario.with_(speed="250 km/h"), tmp_path / "c.fmu")
    assert other.description.token != first.description.token


def test_a_head_with_two_strips_has_a_matrix(short: Short, fmu: Fmu) -> None:
    given = {"pantographs.0.mean_force": None, "pantographs.0.static_force": 120.0}
    two = short(**given, **{"pantographs.0.model.head": HEAD})
    with driven(fmu(2, of=two)) as run:
        names = [f"compliance[{i},{j}]" for i in (1, 2) for j in (1, 2)]
        w11, w12, w21, w22 = run.get(*names)
        assert 0 < w12 < w11
        # The wire is the same on both sides: Betti's theorem, up to rounding.
        assert w12 == pytest.approx(w21, rel=1e-9)
        assert run.value("P1.strip_2.wire_stiffness") == 1 / w22
    with driven(fmu(2, of=two, given="control-force")) as run:
        run.step()
        parts = run.get("P1.strip_1.contact_force", "P1.strip_2.contact_force")
        assert run.value("P1.contact_force") == sum(parts)
    with driven(fmu(2, of=two, pantograph="P1")) as run:
        s = run.get(*names)
        assert s[1] == pytest.approx(s[2], rel=1e-12)  # rounding of a symmetric matrix


def test_chosen_supports_alone_have_an_uplift(scenario: Scenario, tmp_path: Path) -> None:
    with pytest.raises(ModelError, match=r"--uplift.*`support 99`.*`support 1`"):
        export_fmu(scenario, tmp_path / "a.fmu", supports=["support 99"])
    found = export_fmu(scenario, tmp_path / "a.fmu", supports=["support 3", "support 4"])
    names = [v.name for v in found.description.variables if v.name.endswith(".uplift")]
    assert names == ["support_3.uplift", "support_4.uplift"]


@pytest.mark.parametrize(
    ("choice", "words"),
    [
        ({"given": "force"}, r"--given.*`force`.*`contact-force`"),
        ({"travel": "time"}, r"--travel.*`time`.*`position` or `speed`"),
        ({"pantograph": "P2"}, r"--pantograph.*`P2`.*`P1`"),
        ({"version": 1}, r"--fmi.*1.*2 \(2\.0\) or 3 \(3\.0\)"),
    ],
)
def test_choices_that_there_are_not(
    scenario: Scenario, tmp_path: Path, choice: dict[str, Any], words: str
) -> None:
    with pytest.raises(ModelError, match=words):
        export_fmu(scenario, tmp_path / "a.fmu", **choice)
    assert not (tmp_path / "a.fmu").exists()


def test_what_a_loop_cannot_do_is_refused(scenario: Scenario, tmp_path: Path) -> None:
    shaking = scenario.with_(
        **{"pantographs.0.mean_force": 120.0, "pantographs.0.static_force": None}
    )
    with pytest.raises(ModelError, match="not in a real-time loop"):
        export_fmu(shaking, tmp_path / "a.fmu", given="control-force")
    with pytest.raises(OutputError, match="no folder"):
        export_fmu(scenario, tmp_path / "none" / "a.fmu")


def test_without_a_library_nothing_is_written(
    scenario: Scenario, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(library, "FOLDER", tmp_path / "libraries")
    with pytest.raises(OutputError, match=r"library.*missing.*make build"):
        export_fmu(scenario, tmp_path / "a.fmu")
    assert not (tmp_path / "a.fmu").exists()
    export_model(scenario, tmp_path / "a.loop")  # needs none


def test_the_library_and_its_header_are_copied(tmp_path: Path) -> None:
    names = {path.name for path in copy_library(tmp_path)}
    assert {"libarcless_loop.so", "arcless_loop.h"} <= names
    assert arcless.fmi.copy_library is copy_library


@pytest.mark.parametrize("version", [2, 3])
def test_every_function_of_the_standard_exists(tmp_path: Path, version: int) -> None:
    """Also those of model exchange, which importers may look for when they load the library."""
    header = Path(fmpy.__file__).parent / "c-code" / f"fmi{version}Functions.h"
    names = set(
        re.findall(rf"^#define (fmi{version}\w+) +fmi\w+FullName", header.read_text(), re.M)
    )
    assert len(names) > 40
    copy_library(tmp_path)
    loaded = ctypes.CDLL(str(tmp_path / "libarcless_loop.so"))
    assert {name for name in names if not hasattr(loaded, name)} == set()
