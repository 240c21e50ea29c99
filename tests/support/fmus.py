"""FMUs for tests: a pantograph in C, compiled, described and packed in many ways."""

import importlib.util
import platform
import shutil
import subprocess
import sys
import tempfile
import zipfile
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import pytest

SOURCE = Path(__file__).parent / "fmu" / "pantograph.c"
TOKEN = "{pantograph}"
UNITS = {"N": "kg m s-2", "m": "m", "m/s": "m s-1", "1": "", "N/m3": "kg m-2 s-2"}
# Name, value reference, causality, unit.
VARIABLES = (
    ("static_force", 1, "parameter", "N"),
    ("start_height", 2, "parameter", "m"),
    ("base_height", 3, "input", "m"),
    ("base_velocity", 4, "input", "m/s"),
    ("speed", 5, "input", "m/s"),
    ("track_position", 6, "input", "m"),
    ("control_force", 7, "input", "N"),
    ("scheme", 8, "parameter", "1"),
    ("hardening", 9, "parameter", "N/m3"),
)

can_compile = pytest.mark.skipif(shutil.which("cc") is None, reason="no C compiler `cc` is there")
can_run = pytest.mark.skipif(
    shutil.which("cc") is None or importlib.util.find_spec("fmpy") is None,
    reason="no C compiler `cc`, or no FMPy (the extra `fmi`)",
)


def own_platform(fmi: int) -> str:
    """Return the folder of libraries of this machine, which is Linux or macOS."""
    system = "darwin" if sys.platform == "darwin" else "linux"
    return (
        f"{system}64" if fmi == 2 else f"{platform.machine().replace('arm64', 'aarch64')}-{system}"
    )


@cache
def library(fmi: int = 2, strips: int = 1, faults: tuple[str, ...] = ()) -> Path:
    """Compile the pantograph once for all tests of a process."""
    folder = Path(tempfile.mkdtemp(prefix="arcless-test-fmu-"))
    out = folder / "pantograph.so"
    flags = [f"-DFMI={fmi}", f"-DSTRIPS={strips}", *(f"-D{fault}" for fault in faults)]
    command = ["cc", "-O2", "-shared", "-fPIC", *flags, "-o", str(out), str(SOURCE), "-lm"]
    subprocess.run(command, check=True, capture_output=True)
    return out


def description(
    fmi: int = 2,
    strips: int = 1,
    *,
    units: Mapping[str, str | None] = {},
    causalities: Mapping[str, str] = {},
    names: Mapping[str, str] = {},
    attributes: str = "",
    keeps_state: bool = True,
    defined: bool = True,
) -> str:
    """Return a modelDescription.xml.

    `units` and `causalities` are of variables that are to be wrong, `names` of those that have
    another name; a unit None is left out. With `defined` false the units have a name alone.
    """
    variables = [
        *VARIABLES,
        *((f"contact_force{_number(i, strips)}", 10 + i, "input", "N") for i in range(strips)),
        *((f"strip_height{_number(i, strips)}", 20 + i, "output", "m") for i in range(strips)),
    ]
    rows = []
    for name, reference, causality, unit in variables:
        given = units.get(name, unit)
        of = "" if given is None else f' unit="{given}"'
        role = causalities.get(name, causality)
        start = "" if role == "output" else ' start="0"'
        rows.append(_variable(fmi, names.get(name, name), reference, role, f"{of}{start}"))
    state, token = ("FMUstate", "guid") if fmi == 2 else ("FMUState", "instantiationToken")
    can = str(keeps_state).lower()
    kinds = {unit: UNITS.get(unit, "") for row in variables for unit in [row[3]]}
    kinds |= {unit: UNITS.get(unit, "K") for unit in units.values() if unit is not None}
    defined_units = "".join(_unit(*each, defined=defined) for each in kinds.items())
    return f"""<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription fmiVersion="{fmi}.0" modelName="pantograph" {token}="{TOKEN}">
  <CoSimulation modelIdentifier="pantograph" canGetAndSet{state}="{can}" canSerialize{state}="{can}"
    {attributes}/>
  <UnitDefinitions>{defined_units}</UnitDefinitions>
  <ModelVariables>{"".join(rows)}</ModelVariables>
  <ModelStructure/>
</fmiModelDescription>
"""


def _number(i: int, strips: int) -> str:
    return f"_{i + 1}" if strips > 1 else ""


def _variable(fmi: int, name: str, reference: int, causality: str, more: str) -> str:
    own = f'name="{name}" valueReference="{reference}" causality="{causality}"'
    if fmi == 2:
        return f"<ScalarVariable {own}><Real{more}/></ScalarVariable>"
    return f"<Float64 {own}{more}/>"


def _unit(name: str, bases: str, *, defined: bool) -> str:
    if not defined:
        return f'<Unit name="{name}"/>'
    factor = {"mm": 1e-3, "kN": 1e3}.get(name, 1.0)
    parts = {"mm": "m", "kN": UNITS["N"]}.get(name, bases).split()
    exponents = " ".join(
        f'{part.rstrip("-0123456789")}="{part[len(part.rstrip("-0123456789")) :] or 1}"'
        for part in parts
    )
    return f'<Unit name="{name}"><BaseUnit {exponents} factor="{factor!r}"/></Unit>'


def pack(file: Path, text: str, libraries: Mapping[str, Path]) -> Path:
    """Write an FMU with a description, and libraries by their folders."""
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("modelDescription.xml", text)
        for folder, own in libraries.items():
            archive.write(own, f"binaries/{folder}/pantograph{own.suffix}")
    return file


def fmu(
    folder: Path, fmi: int = 2, strips: int = 1, faults: tuple[str, ...] = (), **described: Any
) -> Path:
    """Write the FMU of the pantograph into a folder."""
    text = description(fmi, strips, **described)
    built = library(fmi, strips, faults)
    return pack(folder / "pantograph.fmu", text, {own_platform(fmi): built})


def undescribed(folder: Path, text: str, platforms: tuple[str, ...] = ("linux64",)) -> Path:
    """Write an FMU whose libraries are no libraries: nothing may load them."""
    stub = folder / "pantograph.so"
    stub.write_bytes(b"not a library")
    return pack(folder / "pantograph.fmu", text, dict.fromkeys(platforms, stub))


Maker = Callable[..., Path]
