"""Description of an FMU: what its modelDescription.xml says, without any of its code.

FMI 2.0.4 and 3.0.1, co-simulation. The file is a zip archive with that one description and, for
each platform, a library. Only the description and the names of the other members are read here.
"""

import platform
import sys
import zipfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

from arcless.errors import ModelError
from arcless.units import show

FMI_2 = 2
DESCRIPTION = "modelDescription.xml"
# Descriptions of whole vehicles have some MB; a larger one is no description, but a trap.
MAX_BYTES = 50_000_000
# Names of processors in FMI 3.0, by those that Python has for them.
_PROCESSORS = {"amd64": "x86_64", "x86_64": "x86_64", "arm64": "aarch64", "aarch64": "aarch64"}
_SYSTEMS = {"linux": ("linux", ".so"), "win32": ("windows", ".dll"), "darwin": ("darwin", ".dylib")}
_SYSTEMS_2 = {"linux": "linux", "windows": "win", "darwin": "darwin"}
# Types of real variables, of FMI 2.0 and 3.0.
_REAL = ("Real", "Float64")
BASES = ("kg", "m", "s", "A", "K", "mol", "cd", "rad")


@dataclass(frozen=True)
class FmuUnit:
    """Unit of an FMU: exponents of SI base units, and its size in SI.

    Attributes
    ----------
    name
        As the FMU spells it.
    exponents
        Of kg, m, s, A, K, mol, cd and rad; None where the FMU does not say.
    factor
        SI value of 1 in this unit.
    offset
        SI value of 0 in this unit.
    """

    name: str
    exponents: tuple[int, ...] | None = None
    factor: float = 1.0
    offset: float = 0.0


@dataclass(frozen=True)
class FmuVariable:
    """Variable of an FMU.

    Attributes
    ----------
    name, reference
        Its name, and the number by which the interface knows it.
    kind
        Its type, such as Real or Float64.
    causality
        Such as input, output or parameter.
    unit
        Its unit; None where the FMU gives none.
    is_array
        True of a variable with dimensions.
    """

    name: str
    reference: int
    kind: str
    causality: str
    unit: FmuUnit | None
    is_array: bool

    @property
    def is_real(self) -> bool:
        """True of a floating-point number of double precision."""
        return self.kind in _REAL


@dataclass(frozen=True)
class FmuDescription:
    """Description of an FMU for co-simulation.

    Attributes
    ----------
    file
        The FMU.
    version
        Version of FMI, 2 or 3.
    model
        Name of its library.
    token
        GUID or instantiation token, which the library checks.
    variables
        By their names.
    platforms
        Platforms for which it has a library, as FMI names their folders.
    keeps_state
        True where its state can be saved and restored.
    needs_tool
        True where it only connects to another program.
    internal_step_s
        Step in s of which a communication step must be a multiple; None where it does not say.
    """

    file: Path
    version: int
    model: str
    token: str
    variables: dict[str, FmuVariable]
    platforms: tuple[str, ...]
    keeps_state: bool
    needs_tool: bool
    internal_step_s: float | None

    @property
    def has_library(self) -> bool:
        """True where it has a library for this machine."""
        return own_platform(self.version) in self.platforms


def own_platform(version: int) -> str:
    """Return the folder of FMI 2 or 3 for libraries of this machine."""
    system, _ = _SYSTEMS.get(sys.platform, (sys.platform, ""))
    processor = _PROCESSORS.get(platform.machine().lower(), platform.machine())
    if version != FMI_2:
        return f"{processor}-{system}"
    # FMI 2.0 has one folder for all processors of 64 bits of a system.
    return f"{_SYSTEMS_2.get(system, system)}64"


def read_description(file: Path) -> FmuDescription:
    """Return what an FMU says of itself; none of its code is loaded.

    Raises
    ------
    ModelError
        The file is no FMU for co-simulation of FMI 2.0 or 3.0.
    """
    try:
        with zipfile.ZipFile(file) as archive:
            names = archive.namelist()
            text = _text(archive, file)
    except OSError as error:
        raise _no_fmu(file, error.strerror or str(error)) from error
    except (zipfile.BadZipFile, RuntimeError, NotImplementedError, ValueError) as error:
        raise _no_fmu(file, f"a file that cannot be read as a zip archive ({error})") from error
    try:
        root = ElementTree.fromstring(text)
    except ElementTree.ParseError as error:
        raise _no_fmu(file, f"a {DESCRIPTION} that is not XML ({error})") from error
    version = _version(root, file)
    kind = root.find("CoSimulation")
    if kind is None:
        raise ModelError(
            "not an FMU for co-simulation",
            where=str(file),
            got="model exchange alone" if root.find("ModelExchange") is not None else "neither",
            expected="an FMU with CoSimulation, which brings its own solver",
            hint="export it for co-simulation",
        )
    model = kind.get("modelIdentifier", "")
    of_state = "FMUstate" if version == FMI_2 else "FMUState"
    token = "guid" if version == FMI_2 else "instantiationToken"
    internal = kind.get("fixedInternalStepSize")
    return FmuDescription(
        file=file,
        version=version,
        model=model,
        token=root.get(token, ""),
        variables={one.name: one for one in _variables(root, file)},
        platforms=_platforms(names, model),
        keeps_state=_true(kind, f"canGetAndSet{of_state}"),
        needs_tool=_true(kind, "needsExecutionTool"),
        internal_step_s=None if internal is None else _number(internal, file),
    )


def _text(archive: zipfile.ZipFile, file: Path) -> bytes:
    try:
        size = archive.getinfo(DESCRIPTION).file_size
    except KeyError:
        raise _no_fmu(file, f"an archive without {DESCRIPTION}") from None
    if size > MAX_BYTES:
        raise _no_fmu(file, f"a {DESCRIPTION} of {size / 1e6:.0f} MB")
    return archive.read(DESCRIPTION)


def _no_fmu(file: Path, got: str) -> ModelError:
    expected = f"a zip archive with a {DESCRIPTION} of FMI 2.0 or 3.0"
    return ModelError("not an FMU", where=str(file), got=got, expected=expected)


def _version(root: ElementTree.Element, file: Path) -> int:
    given = root.get("fmiVersion", "")
    major = given.partition(".")[0]
    if root.tag != "fmiModelDescription" or major not in ("2", "3"):
        raise ModelError(
            "not a version of FMI that can be used",
            where=str(file),
            got=show(given) if given else f"the element {show(root.tag)}",
            expected="2.0 or 3.0",
        )
    return int(major)


def _variables(root: ElementTree.Element, file: Path) -> Iterator[FmuVariable]:
    declared = root.iterfind("UnitDefinitions/Unit")
    units = {str(one.get("name")): _unit(one, file) for one in declared}
    types = _types(root)
    for element in root.iterfind("ModelVariables/*"):
        own = element
        if element.tag == "ScalarVariable":  # FMI 2.0: the type is the element inside
            inside = next((e for e in element if e.tag != "Annotations"), None)
            if inside is None:
                continue
            own = inside
        unit = own.get("unit") or types.get(own.get("declaredType", ""))
        yield FmuVariable(
            name=element.get("name", ""),
            reference=int(_number(element.get("valueReference", "nan"), file)),
            kind=own.tag,
            causality=element.get("causality", "local"),
            unit=None if unit is None else units.get(unit, FmuUnit(unit)),
            is_array=element.find("Dimension") is not None,
        )


def _types(root: ElementTree.Element) -> dict[str, str | None]:
    """Return the unit of each declared type, None of one without."""
    found: dict[str, str | None] = {}
    for element in root.iterfind("TypeDefinitions/*"):
        own = element.find("Real") if element.tag == "SimpleType" else element
        if own is not None:
            found[element.get("name", "")] = own.get("unit")
    return found


def _unit(element: ElementTree.Element, file: Path) -> FmuUnit:
    name, base = element.get("name", ""), element.find("BaseUnit")
    if base is None:
        return FmuUnit(name)
    exponents = tuple(int(_number(base.get(one, "0"), file)) for one in BASES)
    factor, offset = (_number(base.get(k, d), file) for k, d in (("factor", "1"), ("offset", "0")))
    return FmuUnit(name, exponents, factor, offset)


def _number(text: str, file: Path) -> float:
    try:
        found = float(text)
    except ValueError:
        found = float("nan")
    if found - found != 0.0:
        raise _no_fmu(file, f"a {DESCRIPTION} with {show(text)} in place of a number")
    return found


def _platforms(names: list[str], model: str) -> tuple[str, ...]:
    endings = [ending for _, ending in _SYSTEMS.values()]
    found = [name.split("/") for name in names]
    return tuple(
        parts[1]
        for parts in found
        if len(parts) == 3 and parts[0] == "binaries"  # noqa: PLR2004 - binaries/PLATFORM/FILE
        if any(parts[2] == f"{model}{ending}" for ending in endings)
    )


def _true(element: ElementTree.Element, name: str) -> bool:
    return element.get(name, "false") in ("true", "1")
