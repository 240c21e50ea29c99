"""Description of a model → modelDescription.xml of FMI 2.0 and 3.0.

Elements and attributes follow the standards: FMI 2.0.4 (2022), section 4.3, and FMI 3.0.1 (2023),
section 2.4. Every variable is a real number; its value reference is its number in the model.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal
from xml.etree import ElementTree

from arcless import _core

Version = Literal[2, 3]
VERSIONS: tuple[Version, ...] = (2, 3)
# Name of the library in an FMU, which both versions call the model identifier.
IDENTIFIER = "arcless_loop"
# Exponents of base units, by the attributes of both versions.
UNITS: dict[str, dict[str, int]] = {
    "s": {"s": 1},
    "m": {"m": 1},
    "m/s": {"m": 1, "s": -1},
    "N": {"kg": 1, "m": 1, "s": -2},
    "N/m": {"kg": 1, "s": -2},
    "m/N": {"kg": -1, "s": 2},
    "1": {},
}
CATEGORIES = {
    "logStatusDiscard": "A step that could not be taken, or a value that there is not",
    "logStatusError": "Requests that are wrong",
    "logStatusFatal": "A fault of Arcless",
}


@dataclass(frozen=True)
class Variable:
    """A variable of a model: number, name, unit, description, role, value at the start.

    `is_prediction` is true for outputs that follow from the inputs of the step that comes.
    """

    number: int
    name: str
    unit: str
    description: str
    role: str
    start: float
    is_prediction: bool


@dataclass(frozen=True)
class Description:
    """Description of a model.

    Attributes
    ----------
    token
        Text that belongs to this model alone.
    step_length
        Length of a step in s.
    variables
        Variables by their numbers.
    title, about
        Name of the model, and a sentence about it.
    stop_time
        End of the travel of the scenario in s.
    """

    token: str
    step_length: float
    variables: Sequence[Variable]
    title: str
    about: str
    stop_time: float

    def of_role(self, role: str) -> list[Variable]:
        """Return the variables of a role: independent, input, output or constant."""
        return [variable for variable in self.variables if variable.role == role]


def describe(model: bytes, title: str, about: str, stop_time: float) -> Description:
    """Return the description of a model, with a title, a sentence and the time of its end in s."""
    found: dict[str, Any] = _core.described(model)
    variables = [Variable(number, *each) for number, each in enumerate(found["variables"])]
    return Description(found["token"], found["step_length"], variables, title, about, stop_time)


def model_description(description: Description, version: Version) -> bytes:
    """Return modelDescription.xml for a version of the FMI."""
    root = _fmi2(description) if version == 2 else _fmi3(description)  # noqa: PLR2004
    ElementTree.indent(root)
    text: str = ElementTree.tostring(root, "unicode")
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{text}\n'.encode()


def _fmi2(d: Description) -> ElementTree.Element:
    root = _root(d, "2.0", guid=d.token)
    root.set("numberOfEventIndicators", "0")
    _add(
        root,
        "CoSimulation",
        modelIdentifier=IDENTIFIER,
        canHandleVariableCommunicationStepSize="true",
        canGetAndSetFMUstate="true",
        canSerializeFMUstate="true",
        canNotUseMemoryManagementFunctions="true",
    )
    _add_common(root, d)
    variables = ElementTree.SubElement(root, "ModelVariables")
    for variable in d.variables:
        scalar = _add(variables, "ScalarVariable", **_head(variable))
        real = _add(scalar, "Real", unit=variable.unit)
        if variable.role in ("input", "constant"):
            real.set("start", repr(variable.start))
    structure = ElementTree.SubElement(root, "ModelStructure")
    outputs = ElementTree.SubElement(structure, "Outputs")
    unknowns = ElementTree.SubElement(structure, "InitialUnknowns")
    for variable in d.of_role("output"):
        # Numbers of elements in the list of variables begin with 1.
        _add(outputs, "Unknown", index=variable.number + 1, **_depends(d, variable, 1))
        _add(unknowns, "Unknown", index=variable.number + 1)
    return root


def _fmi3(d: Description) -> ElementTree.Element:
    root = _root(d, "3.0", instantiationToken=d.token)
    _add(
        root,
        "CoSimulation",
        modelIdentifier=IDENTIFIER,
        canGetAndSetFMUState="true",
        canSerializeFMUState="true",
        canHandleVariableCommunicationStepSize="true",
        fixedInternalStepSize=repr(d.step_length),
    )
    _add_common(root, d)
    variables = ElementTree.SubElement(root, "ModelVariables")
    for variable in d.variables:
        real = _add(variables, "Float64", **_head(variable), unit=variable.unit)
        if variable.role in ("input", "constant"):
            real.set("start", repr(variable.start))
    structure = ElementTree.SubElement(root, "ModelStructure")
    for variable in d.of_role("output"):
        depends = _depends(d, variable, 0)
        _add(structure, "Output", valueReference=variable.number, **depends)
    for variable in d.of_role("output"):
        _add(structure, "InitialUnknown", valueReference=variable.number)
    return root


def _root(d: Description, version: str, **token: str) -> ElementTree.Element:
    attributes = {
        "fmiVersion": version,
        "modelName": d.title,
        **token,
        "description": d.about,
        "generationTool": f"Arcless {_core.__version__}",
        "variableNamingConvention": "structured",
    }
    return ElementTree.Element("fmiModelDescription", attributes)


def _add_common(root: ElementTree.Element, d: Description) -> None:
    """Add units, categories of messages, and the experiment of the scenario."""
    units = ElementTree.SubElement(root, "UnitDefinitions")
    used = {variable.unit for variable in d.variables}
    for name, exponents in UNITS.items():
        if name in used:
            unit = _add(units, "Unit", name=name)
            _add(unit, "BaseUnit", **{base: str(n) for base, n in exponents.items()})
    categories = ElementTree.SubElement(root, "LogCategories")
    for name, about in CATEGORIES.items():
        _add(categories, "Category", name=name, description=about)
    _add(
        root,
        "DefaultExperiment",
        startTime="0.0",
        stopTime=repr(d.stop_time),
        stepSize=repr(d.step_length),
    )


def _head(variable: Variable) -> dict[str, str]:
    """Return the attributes of a variable that both versions call alike."""
    is_constant = variable.role == "constant"
    head = {
        "name": variable.name,
        "valueReference": str(variable.number),
        "description": variable.description,
        "causality": "local" if is_constant else variable.role,
        "variability": "constant" if is_constant else "continuous",
    }
    if is_constant:
        head["initial"] = "exact"
    if variable.role == "output":
        head["initial"] = "calculated"
    return head


def _depends(d: Description, variable: Variable, first: int) -> dict[str, str]:
    """Return the inputs that an output follows from at the same time; `first` is their number 0."""
    inputs = [each.number + first for each in d.of_role("input")] if variable.is_prediction else []
    return {"dependencies": " ".join(str(number) for number in inputs)}


def _add(parent: ElementTree.Element, tag: str, /, **attributes: object) -> ElementTree.Element:
    return ElementTree.SubElement(
        parent, tag, {name: str(value) for name, value in attributes.items()}
    )
