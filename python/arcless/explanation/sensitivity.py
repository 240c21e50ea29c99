"""Sensitivities of σ, as data: computed by `arcless.sensitivities`, told by an explanation."""

from dataclasses import asdict, dataclass
from typing import Any, Literal

# Least effect in % of σ per % that is one: less is rounding in the table. Larger, weak effects are
# called none; smaller, a zero is called significant.
LEAST = 0.01


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
        Whether it is larger than its uncertainty, and than `LEAST`.
    linear
        Whether the one-sided differences lie within half of it on either side.
    lowers_percent
        How much a whole step in the better direction lowers σ, %; negative where both raise it.
    better
        That direction: ``"less"`` or ``"more"`` of the parameter.
    """

    pantograph: str
    percent_per_percent: float
    uncertainty: float
    below: float
    above: float
    significant: bool
    linear: bool
    lowers_percent: float
    better: Literal["less", "more"]


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
        """Return the parameter whose whole step lowers a pantograph's σ most.

        None where no significant effect lowers it by more than the uncertainty over the step.
        """
        found = [
            (one, effect)
            for one in self.parameters
            for effect in one.effects
            if effect.pantograph == pantograph
            and effect.significant
            and effect.lowers_percent > self.step_percent * effect.uncertainty
        ]
        return max(found, key=lambda pair: pair[1].lowers_percent, default=None)
