"""Choice of what of a scenario is exported, and of what is given from outside."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from arcless.errors import ModelError
from arcless.model import Scenario

Given = Literal["contact-force", "strip-height", "control-force"]
Travel = Literal["position", "speed"]
GIVEN: tuple[Given, ...] = ("contact-force", "strip-height", "control-force")
TRAVELS: tuple[Travel, ...] = ("position", "speed")


@dataclass(frozen=True)
class Choice:
    """Choice of what of a scenario is exported.

    Attributes
    ----------
    given
        Input that presses against the line: contact forces, heights of strips, or controlled forces
        of simulated pantographs.
    travel
        Input that moves the pantographs along the track.
    pantograph
        Name of a pantograph that is exported by itself; None for the line.
    supports
        Names of supports whose uplift is an output; None for all of them.
    """

    given: Given = "contact-force"
    travel: Travel = "speed"
    pantograph: str | None = None
    supports: Sequence[str] | None = None

    def check(self, scenario: Scenario) -> None:
        """Refuse a choice that the scenario does not have.

        Raises
        ------
        ModelError
            No such kind of input, no such pantograph; a pantograph inside that is an FMU.
        """
        _one_of("--given", self.given, GIVEN)
        _one_of("--travel", self.travel, TRAVELS)
        if self.pantograph is not None:
            _one_of("--pantograph", self.pantograph, _names(scenario))
        if self.given == "control-force" or self.pantograph is not None:
            _refuse_fmus(scenario)

    def number(self, scenario: Scenario) -> int:
        """Return the number of the pantograph that is exported by itself."""
        assert self.pantograph is not None
        return _names(scenario).index(self.pantograph)


def _names(scenario: Scenario) -> list[str]:
    return [placement.name for placement in scenario.pantographs]


def _refuse_fmus(scenario: Scenario) -> None:
    """Refuse pantographs that cannot be in the file: nobody but their program knows them."""
    for index, placement in enumerate(scenario.pantographs):
        if placement.model.fmu is not None:
            raise ModelError(
                f"pantograph {placement.name} is an FMU, which an exported file cannot hold",
                where=f"pantographs.{index}.model.fmu",
                got=str(placement.model.fmu.file),
                expected="a pantograph of masses or matrices",
                hint="export the line alone, with `--given contact-force` or `--given"
                " strip-height`, and couple the FMU with it in the other program",
            )


def _one_of(option: str, given: str, known: Sequence[str]) -> None:
    if given not in known:
        raise ModelError(
            "what is to be exported",
            where=option,
            got=f"`{given}`",
            expected=" or ".join(f"`{name}`" for name in known),
        )
