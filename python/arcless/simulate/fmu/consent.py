"""Consent to run the code of FMUs: nothing of them is loaded without it."""

import os

from arcless.errors import FmuError
from arcless.model import Scenario

ENVIRONMENT = "ARCLESS_ALLOW_FMU"


def is_allowed(*, given: bool) -> bool:
    """Return whether FMUs may run: as asked for, or by the environment."""
    return given or os.environ.get(ENVIRONMENT) == "1"


def check_consent(scenario: Scenario, *, allow_fmu: bool) -> None:
    """Refuse a scenario with an FMU unless it may run.

    Raises
    ------
    FmuError
        A pantograph is an FMU, and nobody has said that its code may run.
    """
    if is_allowed(given=allow_fmu):
        return
    for index, placement in enumerate(scenario.pantographs):
        fmu = placement.model.fmu
        if fmu is not None:
            raise FmuError(
                f"pantograph {placement.name} is an FMU, and FMUs are not allowed to run",
                where=f"pantographs.{index}.model.fmu",
                got=f"{fmu.file}, SHA-256 {fmu.sha256 or 'not known'}",
                expected="`--allow-fmu`, `allow_fmu=True`, or the environment variable"
                f" {ENVIRONMENT}=1",
                hint="its code runs with all rights that you have: allow it where you know where"
                " it comes from",
            )
