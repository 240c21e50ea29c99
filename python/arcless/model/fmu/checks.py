"""Checks of a pantograph's FMU against its description, before any of its code is loaded."""

import hashlib
from pathlib import Path

from arcless.errors import ModelError
from arcless.model.fields.part import nearest
from arcless.model.fmu.description import (
    FmuDescription,
    FmuUnit,
    FmuVariable,
    own_platform,
    read_description,
)
from arcless.model.fmu.mapping import START, PantographFmu, Role
from arcless.units import KINDS, plain, show, to_si

# Exponents of kg, m and s of the units that variables are needed in.
_EXPONENTS = {"N": (1, 1, -2), "m": (0, 1, 0), "m/s": (0, 1, -1)}


def digest_of(file: Path) -> str:
    """Return the SHA-256 of a file in hexadecimal digits.

    Raises
    ------
    ModelError
        The file cannot be read.
    """
    try:
        with file.open("rb") as stream:
            return hashlib.file_digest(stream, "sha256").hexdigest()
    except OSError as error:
        raise ModelError(
            "not a file that can be read", where=str(file), got=error.strerror or str(error)
        ) from error


def checked(fmu: PantographFmu, file: Path | None = None) -> FmuDescription:
    """Return the description of an FMU that a model can use as it says.

    Parameters
    ----------
    fmu
        The FMU of a pantograph.
    file
        Where it is, if not where `fmu` says.

    Raises
    ------
    ModelError
        It is no FMU, another one than the model was made with, has no library for this machine,
        cannot save its state, or a variable is missing or of another causality or unit. The field
        of the error is that of `fmu`.
    """
    found = file or Path(fmu.file)
    _check_digest(fmu, found)
    try:
        description = read_description(found)
    except ModelError as error:
        error.field = ("file",)
        raise
    _check_kind(description)
    _check_state(fmu, description)
    for field, role, name in fmu.used():
        _check_variable(fmu, description, field, role, name)
    for name in fmu.parameters:
        place = ("parameters", name)
        _check_real(_known(description, name, place), START, place)
    return description


def factor_of(variable: FmuVariable, unit: str) -> float:
    """Return the SI value of 1 in the unit of a variable, which is SI where it has none.

    Raises
    ------
    ModelError
        It is the unit of something else.
    """
    own = variable.unit
    if own is None:
        return 1.0
    if own.exponents is None:
        return _named(own, variable, unit)
    if own.exponents != (*_EXPONENTS[unit], *(0,) * (len(own.exponents) - 3)) or own.offset != 0.0:
        raise _wrong_unit(variable, own, unit)
    return own.factor


def _check_digest(fmu: PantographFmu, file: Path) -> None:
    found = digest_of(file)
    if fmu.sha256 is not None and fmu.sha256 != found:
        raise ModelError(
            "another FMU than the model was made with",
            where=str(file),
            got=f"the SHA-256 {found}",
            expected=fmu.sha256,
            hint="give the file that belongs to it; or leave sha256 out, and it is another model",
            field=("sha256",),
        )


def _check_kind(description: FmuDescription) -> None:
    file = str(description.file)
    if description.needs_tool:
        raise ModelError(
            "not an FMU that runs by itself",
            where=file,
            got="needsExecutionTool",
            expected="an FMU with its own solver",
            hint="export it as a stand-alone FMU",
            field=("file",),
        )
    if not description.has_library:
        have = ", ".join(plain(one) for one in description.platforms) or "none"
        raise ModelError(
            "no library for this machine",
            where=file,
            got=have,
            expected=own_platform(description.version),
            hint="export it for this platform, or run it where it has one",
            field=("file",),
        )


def _check_state(fmu: PantographFmu, description: FmuDescription) -> None:
    if not description.keeps_state and fmu.strip_mass is None:
        raise ModelError(
            "an FMU whose state cannot be saved",
            where=str(description.file),
            got="a description without canGetAndSetFMUState",
            expected="an FMU that can be evaluated for several forces in one step, or strip_mass",
            hint="export it with saved states; with strip_mass its heights are extrapolated from"
            " step to step, which is less exact",
            field=("strip_mass",),
        )
    if description.keeps_state and fmu.strip_mass is not None:
        raise ModelError(
            "a mass that is not used",
            got=f"{fmu.strip_mass:g} kg",
            expected="none: this FMU can save its state, so its compliance is measured",
            hint="leave strip_mass out",
            field=("strip_mass",),
        )


def _check_variable(
    fmu: PantographFmu, description: FmuDescription, field: str, role: Role, name: str
) -> None:
    variable = _known(description, name, (field,))
    _check_real(variable, role.causalities, (field,))
    if variable.unit is None and not fmu.assume_units:
        raise ModelError(
            "a variable without a unit",
            got=f"{plain(name)}, to which the FMU gives none",
            expected=f"a unit of {KINDS[role.unit].name}",
            hint="give it one in the program that made the FMU; or assume_units: true, where it is"
            f" {role.unit}",
            field=(field,),
        )
    try:
        factor_of(variable, role.unit)
    except ModelError as error:
        error.field = (field,)
        raise


def _known(description: FmuDescription, name: str, field: tuple[str | int, ...]) -> FmuVariable:
    variable = description.variables.get(name)
    if variable is None:
        raise ModelError(
            "no such variable in the FMU",
            where=str(description.file),
            got=show(name),
            expected="a name of its description",
            hint=nearest(name, list(description.variables)),
            field=field,
        )
    return variable


def _check_real(
    variable: FmuVariable, causalities: tuple[str, ...], field: tuple[str | int, ...]
) -> None:
    name = plain(variable.name)
    if not variable.is_real or variable.is_array:
        raise ModelError(
            "not a real number",
            got=f"{name} of type {variable.kind}{', an array' if variable.is_array else ''}",
            expected="a variable of type Real or Float64 without dimensions",
            field=field,
        )
    if variable.causality not in causalities:
        raise ModelError(
            "a variable of another causality",
            got=f"{name}, {plain(variable.causality)}",
            expected=" or ".join(causalities),
            hint="an output of the line is an input of the FMU, and the reverse",
            field=field,
        )


def _named(own: FmuUnit, variable: FmuVariable, unit: str) -> float:
    """Return the size of a unit that has only a name."""
    try:
        return to_si(f"1 {own.name}", unit)
    except ModelError:
        raise _wrong_unit(variable, own, unit) from None


def _wrong_unit(variable: FmuVariable, own: FmuUnit, unit: str) -> ModelError:
    return ModelError(
        "a variable of another unit",
        got=f"{plain(variable.name)} in {show(own.name)}",
        expected=f"a unit of {KINDS[unit].name}, such as {unit}",
    )
