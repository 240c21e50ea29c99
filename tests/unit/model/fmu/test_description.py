"""Descriptions of FMUs: read without any of their code."""

import zipfile
from pathlib import Path

import pytest

from arcless.errors import ModelError
from arcless.model.fmu import description
from arcless.model.fmu.description import read_description
from tests.support import fmus


def described(folder: Path, text: str) -> description.FmuDescription:
    return read_description(fmus.undescribed(folder, text))


@pytest.mark.parametrize("fmi", [2, 3])
def test_both_versions_say_the_same(tmp_path: Path, fmi: int) -> None:
    found = described(tmp_path, fmus.description(fmi, strips=2))
    assert (found.version, found.model, found.token) == (fmi, "pantograph", fmus.TOKEN)
    assert found.keeps_state
    assert found.internal_step_s is None
    force = found.variables["contact_force_2"]
    assert (force.reference, force.causality, force.is_real) == (11, "input", True)
    assert force.unit is not None
    assert (force.unit.exponents, force.unit.factor) == ((1, 1, -2, 0, 0, 0, 0, 0), 1.0)
    assert found.platforms == ("linux64",)


@pytest.mark.parametrize("fmi", [2, 3])
def test_a_unit_may_come_with_the_declared_type(tmp_path: Path, fmi: int) -> None:
    inside = '<Real unit="N"/>' if fmi == 2 else ""
    simple = f'<SimpleType name="Force">{inside}</SimpleType>'
    kind = simple if fmi == 2 else '<Float64Type name="Force" unit="N"/>'
    text = fmus.description(fmi, units={"contact_force": None})
    text = text.replace(
        "<ModelVariables>", f"<TypeDefinitions>{kind}</TypeDefinitions><ModelVariables>"
    )
    text = _typed(text, fmi)
    unit = described(tmp_path, text).variables["contact_force"].unit
    assert unit is not None
    assert unit.name == "N"


def _typed(text: str, fmi: int) -> str:
    name = 'name="contact_force" valueReference="10" causality="input"'
    if fmi == 2:
        return text.replace(f"{name}><Real", f'{name}><Real declaredType="Force"')
    return text.replace(name, f'{name} declaredType="Force"')


def test_an_array_of_fmi_3_is_told(tmp_path: Path) -> None:
    text = fmus.description(3).replace(
        '<Float64 name="contact_force" valueReference="10" causality="input" unit="N" start="0"/>',
        '<Float64 name="contact_force" valueReference="10" causality="input" unit="N" start="0 0">'
        '<Dimension start="2"/></Float64>',
    )
    assert described(tmp_path, text).variables["contact_force"].is_array


def test_the_internal_step_is_read(tmp_path: Path) -> None:
    found = described(tmp_path, fmus.description(3, attributes='fixedInternalStepSize="5e-4"'))
    assert found.internal_step_s == 5e-4


@pytest.mark.parametrize(
    ("machine", "system", "folders"),
    [
        ("x86_64", "linux", ("linux64", "x86_64-linux")),
        ("AMD64", "win32", ("win64", "x86_64-windows")),
        ("arm64", "darwin", ("darwin64", "aarch64-darwin")),
    ],
)
def test_folders_of_libraries(
    monkeypatch: pytest.MonkeyPatch, machine: str, system: str, folders: tuple[str, str]
) -> None:
    monkeypatch.setattr(description.platform, "machine", lambda: machine)
    monkeypatch.setattr(description.sys, "platform", system)
    assert (description.own_platform(2), description.own_platform(3)) == folders


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("no XML", "a modelDescription.xml that is not XML"),
        ('<fmiModelDescription fmiVersion="1.0"/>', 'got "1.0", expected 2.0 or 3.0'),
        ("<other/>", 'got the element "other", expected 2.0 or 3.0'),
        ('<fmiModelDescription fmiVersion="2.0"><ModelExchange/></fmiModelDescription>',
         "not an FMU for co-simulation: got model exchange alone"),
        (fmus.description().replace('valueReference="10"', 'valueReference="ten"'),
         'a modelDescription.xml with "ten" in place of a number'),
    ],
)  # fmt: skip
def test_what_is_no_fmu(tmp_path: Path, text: str, words: str) -> None:
    with pytest.raises(ModelError) as caught:
        described(tmp_path, text)
    assert words in str(caught.value)


def test_an_archive_must_have_a_description(tmp_path: Path) -> None:
    file = tmp_path / "empty.fmu"
    with zipfile.ZipFile(file, "w") as archive:
        archive.writestr("else.txt", "")
    with pytest.raises(ModelError, match="an archive without modelDescription"):
        read_description(file)
    file.write_bytes(b"PK no archive")
    with pytest.raises(ModelError, match="cannot be read as a zip archive"):
        read_description(file)
    with pytest.raises(ModelError, match="No such file"):
        read_description(tmp_path / "missing.fmu")
