"""A pantograph that is an FMU: what `arcless check` says before any code of it is loaded."""

from pathlib import Path
from typing import Any

import pytest

import arcless
from arcless.errors import ModelError
from arcless.model.fmu.checks import checked, digest_of, factor_of
from arcless.model.fmu.mapping import PantographFmu
from tests.support import fmus

PANTOGRAPH = """\
format: arcless-pantograph/1
name: from-elsewhere
fmu:
  file: pantograph.fmu
  speed: speed
  parameters: {hardening: 2e6}
static_force: 120 N
"""


def write(folder: Path, text: str = PANTOGRAPH, fmi: int = 2, **described: Any) -> Path:
    platforms = ("linux64", "x86_64-linux", "aarch64-linux", "darwin64", "aarch64-darwin")
    fmus.undescribed(folder, fmus.description(fmi, **described), platforms)
    file = folder / "pantograph.yaml"
    file.write_text(text, encoding="utf-8")
    return file


def complaint(folder: Path, text: str = PANTOGRAPH, fmi: int = 2, **described: Any) -> str:
    with pytest.raises(ModelError) as caught:
        arcless.load_pantograph(write(folder, text, fmi, **described))
    return str(caught.value).replace(str(folder), "DIR")


@pytest.mark.parametrize("fmi", [2, 3])
def test_a_pantograph_file_with_an_fmu(tmp_path: Path, fmi: int) -> None:
    found = arcless.load_pantograph(write(tmp_path, fmi=fmi))
    assert found.fmu is not None
    assert found.fmu.sha256 == digest_of(tmp_path / "pantograph.fmu")
    assert (found.size, found.raised, found.heights) == (1, (1.0,), [0])
    assert found.in_words() == ["FMU pantograph.fmu"]
    again = arcless.load_pantograph(found.to_dict())
    assert again == found


def test_a_text_is_the_file(tmp_path: Path) -> None:
    text = PANTOGRAPH.replace(
        "  file: pantograph.fmu\n  speed: speed\n  parameters: {hardening: 2e6}\n", ""
    ).replace("fmu:", "fmu: pantograph.fmu")
    found = arcless.load_pantograph(write(tmp_path, text))
    assert found.fmu is not None
    assert Path(found.fmu.file) == tmp_path / "pantograph.fmu"
    assert found.fmu.contact_force == ("contact_force",)


WRONG: dict[str, tuple[dict[str, Any], str]] = {
    "unit": (
        {"units": {"contact_force": "m"}},
        "DIR/pantograph.yaml:3: fmu.contact_force: a variable of another unit: got contact_force in"
        ' "m", expected a unit of a force, such as N',
    ),
    "no unit": (
        {"units": {"strip_height": None}},
        "DIR/pantograph.yaml:3: fmu.strip_height: a variable without a unit: got strip_height, to"
        " which the FMU gives none, expected a unit of a length; hint: give it one in the program"
        " that made the FMU; or assume_units: true, where it is m",
    ),
    "causality": (
        {"causalities": {"contact_force": "output"}},
        "DIR/pantograph.yaml:3: fmu.contact_force: a variable of another causality: got"
        " contact_force, output, expected input; hint: an output of the line is an input of the"
        " FMU, and the reverse",
    ),
    "state": (
        {"keeps_state": False},
        "DIR/pantograph.yaml:3 (DIR/pantograph.fmu): fmu.strip_mass: an FMU whose state cannot be"
        " saved: got a description without canGetAndSetFMUState, expected an FMU that can be"
        " evaluated for several forces in one step, or strip_mass; hint: export it with saved"
        " states; with strip_mass its heights are extrapolated from step to step, which is less"
        " exact",
    ),
    "tool": (
        {"attributes": 'needsExecutionTool="true"'},
        "DIR/pantograph.yaml:4 (DIR/pantograph.fmu): fmu.file: not an FMU that runs by itself: got"
        " needsExecutionTool, expected an FMU with its own solver; hint: export it as a stand-alone"
        " FMU",
    ),
}


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("case", WRONG)
def test_what_is_wrong_is_told_with_its_line(tmp_path: Path, case: str, fmi: int) -> None:
    described, words = WRONG[case]
    assert complaint(tmp_path, fmi=fmi, **described) == words


def test_a_library_for_this_machine(tmp_path: Path) -> None:
    file = write(tmp_path)
    fmus.undescribed(tmp_path, fmus.description(), ("mars64", "win32"))
    with pytest.raises(
        ModelError, match="no library for this machine: got mars64, win32, expected"
    ):
        arcless.load_pantograph(file)


@pytest.mark.parametrize(
    ("changed", "words"),
    [
        (("speed: speed", "speed: sped"),
         'fmu): fmu.speed: no such variable in the FMU: got "sped", expected a name of its'
         " description; hint: did you mean speed?"),
        (("hardening:", "hardness:"), 'fmu.parameters.hardness: no such variable in the FMU'),
        (("hardening:", "strip_height:"),
         "fmu.parameters.strip_height: a variable in two roles: got strip_height as strip_height"
         " and in parameters, expected a variable for each"),
        (("speed: speed", "speed: static_force"),
         "fmu.speed: a variable of another causality: got static_force, parameter, expected input"),
        (("speed: speed", "speed: contact_force"),
         "fmu.speed: a variable in two roles: got contact_force as contact_force and speed"),
        (("speed: speed", "strip_mass: 7 kg"),
         "fmu.strip_mass: a mass that is not used: got 7 kg"),
        (("speed: speed", "sha256: " + 64 * "a"), "fmu.sha256: another FMU than the model"),
        (("speed: speed", "contact_force: [a, b]"),
         "fmu.contact_force: wrong number of names: got 2, expected 1, one for each strip_height"),
        (("speed: speed", "contact_force: [a, b]\n  strip_height: [c, d]"),
         "fmu.strip_offset: wrong number of values: got 0, expected 2, one for each strip"),
        (("pantograph.fmu", "missing.fmu"), "fmu.file: not a file that can be read"),
        (("static_force: 120 N", "masses: [{mass: 1 kg, stiffness: 0, damping: 0}]"),
         "both masses and fmu given"),
        (("static_force: 120 N",
          "head: {strip_spacing: 1 m, half_length: 1 m, mass: 1 kg, stiffness: 1 N/m, damping: 0}"),
         "a head on an FMU"),
    ],
)  # fmt: skip
def test_a_mapping_that_does_not_fit(tmp_path: Path, changed: tuple[str, str], words: str) -> None:
    assert words in complaint(tmp_path, PANTOGRAPH.replace(*changed))


@pytest.mark.parametrize("defined", [True, False])
def test_units_are_converted(tmp_path: Path, defined: bool) -> None:
    units = {"contact_force": "kN", "strip_height": "mm"}
    file = write(tmp_path, units=units, defined=defined)
    fmu = arcless.load_pantograph(file).fmu
    assert fmu is not None
    known = checked(fmu).variables
    assert factor_of(known["contact_force"], "N") == pytest.approx(1e3, rel=1e-15)
    assert factor_of(known["strip_height"], "m") == pytest.approx(1e-3, rel=1e-15)
    assert factor_of(known["speed"], "m/s") == 1.0


def test_units_may_be_assumed(tmp_path: Path) -> None:
    text = PANTOGRAPH.replace("speed: speed", "assume_units: true")
    units = {"contact_force": None, "strip_height": None}
    assert arcless.load_pantograph(write(tmp_path, text, units=units)).fmu is not None


SCENARIO = """\
format: arcless-scenario/1
name: mine
line: ac-simple-55
pantographs:
  - {model: pantograph.yaml, static_force: 120 N}
speed: 200 km/h
"""


@pytest.mark.parametrize(
    ("changed", "words"),
    [
        ("mean_force: 100 N",
         "scenario.yaml:5: pantographs.0.mean_force: the FMU has no variable for it: expected"
         " model.fmu.static_force, the name of a variable of the FMU; hint: name one, or leave"
         " mean_force out"),
        ("static_force: 100 N, roof_motion: {time: [0, 900], displacement: [0, 0]}",
         "pantographs.0.roof_motion: the FMU has no variable for it"),
        ("static_force: 100 N, controller: {sample_time: 5 ms, pid: {target: 1}}",
         "pantographs.0.controller: the FMU has no variable for it"),
    ],
)  # fmt: skip
def test_what_an_fmu_has_no_variable_for(tmp_path: Path, changed: str, words: str) -> None:
    write(tmp_path)
    file = tmp_path / "scenario.yaml"
    file.write_text(SCENARIO.replace("static_force: 120 N", changed), encoding="utf-8")
    with pytest.raises(ModelError) as caught:
        arcless.load(file)
    assert words in str(caught.value)


def test_a_scenario_may_set_fields_of_it(tmp_path: Path) -> None:
    write(tmp_path)
    file = tmp_path / "scenario.yaml"
    file.write_text(SCENARIO, encoding="utf-8")
    changed = arcless.load(file).with_(**{"pantographs.0.fmu.parameters.hardening": 3e6})
    fmu = changed.pantographs[0].model.fmu
    assert isinstance(fmu, PantographFmu)
    assert fmu.parameters == {"hardening": 3e6}
    assert fmu.sha256 == digest_of(tmp_path / "pantograph.fmu")
    data = arcless.load(file).to_dict()
    (tmp_path / "pantograph.fmu").unlink()
    assert arcless.load(data).to_dict() == data  # a result is opened where the FMU is not
