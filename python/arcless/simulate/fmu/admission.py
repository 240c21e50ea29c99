"""Admission of FMUs to a run: none is loaded without consent, nor where it does not fit."""

import os
from dataclasses import dataclass
from pathlib import Path

from arcless.errors import FmuError, ModelError
from arcless.model import Scenario
from arcless.model.fmu.checks import checked
from arcless.model.fmu.description import FmuDescription
from arcless.model.fmu.mapping import PantographFmu
from arcless.simulate.setup.trajectory import time_of_balance

ENVIRONMENT = "ARCLESS_ALLOW_FMU"
# A communication step may miss a multiple of the internal one by rounding of what is written.
_MULTIPLE = 1e-6


@dataclass(frozen=True)
class FmuPlace:
    """Place of an FMU in a run.

    Attributes
    ----------
    name, field
        Name of the pantograph, and where its FMU stands in the scenario.
    step_s
        Time step in s.
    balance
        Part of a step after which the scheme balances forces, 1 at its end.
    """

    name: str
    field: str
    step_s: float
    balance: float


def places_of(scenario: Scenario) -> list[tuple[PantographFmu, FmuPlace] | None]:
    """Return the FMU of each pantograph of a scenario, and its place; None of those inside."""
    return [
        None
        if placement.model.fmu is None
        else (
            placement.model.fmu,
            FmuPlace(
                placement.name,
                f"pantographs.{index}.model.fmu",
                scenario.time_step_s,
                time_of_balance(scenario.stepping.scheme),
            ),
        )
        for index, placement in enumerate(scenario.pantographs)
    ]


def check_admitted(scenario: Scenario, *, allow_fmu: bool) -> None:
    """Refuse a scenario with an FMU that may not run, or does not fit.

    Raises
    ------
    FmuError
        Nobody has said that its code may run.
    ModelError
        It is not what the model says, or cannot take the time step.
    """
    allowed = allow_fmu or os.environ.get(ENVIRONMENT) == "1"
    for fmu, place in filter(None, places_of(scenario)):
        if not allowed:
            raise FmuError(
                f"pantograph {place.name} is an FMU, and FMUs are not allowed to run",
                where=place.field,
                got=f"{fmu.file}, SHA-256 {fmu.sha256 or 'not known'}",
                expected="`--allow-fmu`, `allow_fmu=True`, or the environment variable"
                f" {ENVIRONMENT}=1",
                hint="its code runs with all rights that you have: allow it where you know where"
                " it comes from",
            )
        check_fit(fmu, place)


def check_saved(scenario: Scenario) -> None:
    """Refuse FMUs where a run is to stop early: their state is in their process alone.

    Raises
    ------
    FmuError
        A pantograph is an FMU.
    """
    for _, place in filter(None, places_of(scenario)):
        raise FmuError(
            "a run with an FMU cannot stop early and continue later",
            where=place.field,
            got="an FMU, whose state is in its process alone",
            expected="a pantograph of masses or matrices",
            hint="run it in one piece, without `until`",
        )


def check_fit(fmu: PantographFmu, place: FmuPlace, file: Path | None = None) -> FmuDescription:
    """Return the description of an FMU that a run can use; `file` is a copy of it.

    Raises
    ------
    ModelError
        It is not what the model says, or cannot take the time step.
    """
    try:
        description = checked(fmu, file)
    except ModelError as error:
        error.where = f"{place.field}.{'.'.join(str(part) for part in error.field)}"
        raise
    internal = description.internal_step_s
    if internal:
        ratio = place.step_s / internal
        if round(ratio) < 1 or abs(ratio - round(ratio)) > _MULTIPLE * ratio:
            raise ModelError(
                "a time step that the FMU cannot take",
                where="solver.time_step",
                got=f"{1e3 * place.step_s:g} ms",
                expected=f"a multiple of {1e3 * internal:g} ms, the internal step of the FMU of"
                f" {place.name}",
            )
    return description
