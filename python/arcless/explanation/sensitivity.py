"""Sensitivities of σ, as data: computed by `arcless.sensitivities`, told by an explanation."""

from dataclasses import asdict, dataclass
from typing import Any


@dataclass(frozen=True)
class Effect:
    """Relative change of σ of one pantograph over the relative change of a parameter.

    Attributes
    ----------
    pantograph
        Its name.
    percent_per_percent
        Central difference over the whole step, % of σ per % of the parameter.
    uncertainty
        Difference to the central difference over half the step, in the same unit.
    below, above
        One-sided differences over the whole step.
    significant
        Whether it is larger than its uncertainty.
    linear
        Whether the one-sided differences lie within half of it on either side.
    """

    pantograph: str
    percent_per_percent: float
    uncertainty: float
    below: float
    above: float
    significant: bool
    linear: bool


@dataclass(frozen=True)
class Sensitivity:
    """Effect of one parameter on σ.

    Attributes
    ----------
    parameter
        Name in words.
    paths
        Fields of the scenario that were changed together.
    effects
        One for each pantograph; empty where a run failed, and `note` says why.
    note
        What went wrong; empty where nothing did.
    """

    parameter: str
    paths: tuple[str, ...]
    effects: tuple[Effect, ...]
    note: str = ""


@dataclass(frozen=True)
class Sensitivities:
    """Sensitivities of σ to parameters of line and pantographs.

    Attributes
    ----------
    step_percent
        Whole step of the differences in % of each parameter.
    runs
        Number of runs that were made.
    parameters
        The parameters, in the order in which they were varied.
    left_out
        Sentences on what could not be varied.
    """

    step_percent: float
    runs: int
    parameters: tuple[Sensitivity, ...]
    left_out: tuple[str, ...]

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, ready for JSON."""
        return asdict(self)

    def strongest(self, pantograph: str) -> tuple[Sensitivity, Effect] | None:
        """Return the parameter with the largest significant effect on a pantograph's σ."""
        found = [
            (one, effect)
            for one in self.parameters
            for effect in one.effects
            if effect.pantograph == pantograph and effect.significant
        ]
        return max(found, key=lambda pair: abs(pair[1].percent_per_percent), default=None)
