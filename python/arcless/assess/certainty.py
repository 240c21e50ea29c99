"""Certainty of an assessed number: its spread over starts, and its error of discretisation.

A run is one draw: begun elsewhere within a span, which nobody can prefer, it gives another number.
With N draws x₁ … x_N, of which x₁ is the run's own, and their mean x̄,

    s² = Σ (xᵢ − x̄)²/(N − 1),      spread = t s,

t the quantile of Student's distribution with N − 1 degrees of freedom that leaves 2.5 % on each
side. A single draw lies within t s of the mean over all starts with a probability of 95 %: what is
reported is one draw, no mean, so s is not divided by √N. That holds for numbers that scatter as the
normal distribution has it; extremes do so roughly, and as all starts lie within one span they are
bounded, so 95 % is rather too little said than too much. Half of the range would cover less, and
would grow with N.

    discretisation = |x₁ − y|

with y from the same start and force by the other family of elements, refined.

The second is an error whose size and sign are known at one start, and which is not taken off: it
is the same for all starts and does not average out. So both are added, not their squares (GUM,
JCGM 100:2008, F.2.4.5, from memory): uncertainty = spread + discretisation. A verdict on value and
limit is formed from the difference of both, run by run, for both may go up together.
"""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from math import cos, pi, sin, sqrt
from typing import Any

from arcless.assess.statistics import PantographAssessment

COVERAGE = 0.95
# Numbers of the whole run that are assessed; the others are given, or counts of the computation.
RUN_KEYS = ("max_uplift_at_support_mm", "slack_droppers_max", "min_dropper_force_N")
# Attributes of a result that say how the runs were made.
METHOD_KEYS = ("starts_m", "static_force_N", "other_family", "wall_time_s", "notes")
# Halvings of an interval of angles: to rounding.
HALVINGS = 60


@dataclass(frozen=True)
class Certainty:
    """Certainty of one number, in its own unit; None where that is not known."""

    spread: float | None
    discretisation: float | None

    @property
    def uncertainty(self) -> float | None:
        """Sum of the known parts; None where both are unknown."""
        known = [part for part in (self.spread, self.discretisation) if part is not None]
        return sum(known) if known else None


def certainty(own: float, others: Sequence[float | None], refined: float | None) -> Certainty:
    """Return how sure a number is.

    Parameters
    ----------
    own
        The run's own.
    others
        From the other starts; None where a run has none.
    refined
        From the run's own start by the other family of elements, refined.
    """
    # Counted from the run's own, so that equal numbers have no spread by rounding.
    draws = [0.0, *(value - own for value in others if value is not None)]
    spread = None
    if len(draws) > 1:
        mean = sum(draws) / len(draws)
        variance = sum((value - mean) ** 2 for value in draws) / (len(draws) - 1)
        spread = student_factor(len(draws) - 1) * sqrt(variance)
    return Certainty(spread, None if refined is None else abs(own - refined))


def student_factor(freedom: int, coverage: float = COVERAGE) -> float:
    """Return t so that Student's distribution has the share `coverage` within ± t.

    Notes
    -----
    With t = √ν tan θ the share is a finite sum (Abramowitz & Stegun 26.7.3 and 26.7.4), which rises
    with θ: found by halving. Written here because importing SciPy's takes longer than a run.
    """
    low, high = 0.0, pi / 2
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if _share(middle, freedom) < coverage else (low, middle)
    return sqrt(freedom) * sin(low) / cos(low)


def _share(angle: float, freedom: int) -> float:
    """Return the share of Student's distribution within ± √ν tan of an angle."""
    odd = freedom % 2
    if freedom == 1:
        return 2.0 * angle / pi
    term, total = (cos(angle) if odd else 1.0), 0.0
    for j in range(2 + odd, freedom + 1, 2):
        total += term
        term *= (j - 1) / j * cos(angle) ** 2
    return 2.0 / pi * (angle + sin(angle) * total) if odd else sin(angle) * total


# Name of a criterion, and of its pantograph; None for the whole run.
Judged = tuple[str, str | None]
# Value and limit of a criterion.
Pair = tuple[float | None, float | None]


@dataclass(frozen=True)
class Draw:
    """Data kept of an assessed run: its numbers, and value and limit of each criterion."""

    pantographs: dict[str, dict[str, float | None]]
    run: dict[str, float | None]
    criteria: dict[Judged, Pair]

    def to_dict(self) -> dict[str, Any]:
        """Return it as plain data."""
        rows = [[*name, *pair] for name, pair in self.criteria.items()]
        return {"pantographs": self.pantographs, "run": self.run, "criteria": rows}

    @classmethod
    def from_dict(cls, data: Mapping[str, Any]) -> "Draw":
        """Return what `to_dict` returned."""
        pairs = {(name, whose): (value, limit) for name, whose, value, limit in data["criteria"]}
        return cls(data["pantographs"], data["run"], pairs)


@dataclass(frozen=True)
class Draws:
    """Additional runs: from the other starts, and by the other family of elements."""

    starts: Sequence[Draw]
    refined: Draw | None

    @classmethod
    def of(cls, facts: Mapping[str, Any]) -> "Draws":
        """Return what a result has of them."""
        for key in METHOD_KEYS:
            _ = facts[key]
        refined = facts["refined"]
        starts = [Draw.from_dict(each) for each in facts["draws"]]
        return cls(starts, None if refined is None else Draw.from_dict(refined))

    def of_pantograph(self, own: PantographAssessment) -> dict[str, dict[str, float | None]]:
        """Return how sure each number of a pantograph is."""
        rows = [each.pantographs.get(own.name, {}) for each in self.starts]
        refined = None if self.refined is None else self.refined.pantographs.get(own.name, {})
        return _of_each(numbers_of(own), rows, refined)

    def of_run(self, own: Mapping[str, float | None]) -> dict[str, dict[str, float | None]]:
        """Return how sure each number of the whole run is."""
        refined = None if self.refined is None else self.refined.run
        kept = {key: own[key] for key in RUN_KEYS}
        return _of_each(kept, [each.run for each in self.starts], refined)

    def of_criterion(self, judged: Judged, own: Pair) -> Certainty | None:
        """Return how sure the difference of value and limit is; None where there is none."""
        mine = _difference(own)
        if mine is None:
            return None
        others = [_difference(each.criteria.get(judged)) for each in self.starts]
        refined = None if self.refined is None else _difference(self.refined.criteria.get(judged))
        return certainty(mine, others, refined)


def numbers_of(pantograph: PantographAssessment) -> dict[str, float | None]:
    """Return the numbers of a pantograph by key."""
    return {
        key: value for key, value in vars(pantograph).items() if key not in ("name", "certainty")
    }


def _of_each(
    own: Mapping[str, float | None],
    others: Sequence[Mapping[str, float | None]],
    refined: Mapping[str, float | None] | None,
) -> dict[str, dict[str, float | None]]:
    return {
        key: asdict(
            certainty(
                value,
                [each.get(key) for each in others],
                None if refined is None else refined.get(key),
            )
        )
        for key, value in own.items()
        if value is not None
    }


def _difference(pair: Pair | None) -> float | None:
    if pair is None or pair[0] is None or pair[1] is None:
        return None
    return pair[0] - pair[1]
