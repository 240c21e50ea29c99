"""Pruning: runs that cannot become good any more are stopped while they step.

The limits of a run are known before its round begins, from the rows of earlier rounds alone: plain
numbers, one for each look, that travel to the workers. So a run is stopped at the same step on
every executor, and in a resumed study.

Sources: Optuna's percentile pruner (Akiba et al., KDD 2019); for a bound by what others improved,
the races of Maron and Moore, Artif. Intell. Rev. 11 (1997) 193.
"""

from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from math import inf
from typing import Annotated, Literal

from pydantic import Field

from arcless.model.fields.part import Part
from arcless.study.journal.row import Row
from arcless.study.optimisation.constraints import Constraint

LOOKS = 10


class _Rule(Part):
    """A rule of pruning."""

    after: int = Field(
        default=10, description="Finished variants before any is compared with them.", ge=2
    )
    looks: int = Field(
        default=LOOKS, description="Parts of the analysis section; looked at after each.",
        ge=2, le=100,
    )  # fmt: skip


class OutOfReach(_Rule):
    """Pruning rule: stop where improving as much as any finished variant did would not suffice."""

    kind: Literal["out-of-reach"] = Field(description="The best is out of reach.")


class Percentile(_Rule):
    """Pruning rule: stop where it is worse than a share of the finished variants were there."""

    kind: Literal["percentile"] = Field(description="Worse than a share of the others.")
    percentile: float = Field(
        default=50.0, description="Share of the finished variants in % that continue.", gt=0, lt=100
    )


Pruning = Annotated[OutOfReach | Percentile, Field(discriminator="kind")]


@dataclass(frozen=True)
class Bar:
    """Limit up to which a run continues at one look: `limit` of a measure that is better small."""

    limit: float
    words: str


@dataclass(frozen=True)
class Comparison:
    """An output, how it is measured, and the bar of each look.

    Attributes
    ----------
    output, sign, constraint
        The measure is sign times the output, or its excess where there is a constraint.
    best_so_far
        Whether the best of the looks so far counts, not the last one.
    bars
        One for each look.
    """

    output: str
    sign: float
    constraint: Constraint | None
    best_so_far: bool
    bars: tuple[Bar, ...] = ()

    def measure(self, value: float) -> float:
        """Return the measure of a value: better when small."""
        return self.sign * value if self.constraint is None else self.constraint.excess(value)


@dataclass(frozen=True)
class Monitoring:
    """Quantities and limits that runs of a round are monitored by; plain data for workers.

    Attributes
    ----------
    looks
        Parts of the section.
    seen
        Outputs whose values so far are kept.
    comparisons
        What they are compared with.
    hard
        Constraints that end a run once they are broken, on outputs that can only get worse.
    """

    looks: int
    seen: tuple[str, ...]
    comparisons: tuple[Comparison, ...]
    hard: tuple[Constraint, ...]


def comparisons(
    rule: "OutOfReach | Percentile",
    objective: tuple[str, float],
    constraints: Sequence[Constraint],
    rows: Sequence[Row],
    feasible: Callable[[Row], bool],
) -> tuple[Comparison, ...]:
    """Return the comparisons that decide about runs of the next round.

    Parameters
    ----------
    rule
        How.
    objective
        Its output, and 1 where small is good, −1 where large is.
    constraints
        Bounds of outputs.
    rows
        Of earlier rounds, in the order of the variants.
    feasible
        Whether a row keeps all constraints.
    """
    aim = Comparison(*objective, None, best_so_far=isinstance(rule, Percentile))
    if isinstance(rule, Percentile):
        return (_percentile(rule, aim, rows, feasible),)
    bounds = [Comparison(one.output, 1.0, one, best_so_far=False) for one in constraints]
    return tuple(_out_of_reach(rule, test, rows, feasible) for test in (aim, *bounds))


def _out_of_reach(
    rule: OutOfReach, test: Comparison, rows: Sequence[Row], feasible: Callable[[Row], bool]
) -> Comparison:
    """Return a test with bars: continue while m_k ≤ best + max_i max(0, m_ik − m_i).

    m_ik is the measure of finished variant i at look k, m_i that at its end. Best is the least m_i
    of the feasible ones; of a constraint, whose measure is its excess, the 0 that is allowed.
    """
    best, start = 0.0, "0 is allowed"
    if test.constraint is None:
        ends = [test.measure(end) for _, end, row in _finished(rows, test.output) if feasible(row)]
        best = min(ends, default=inf)
        start = f"the best has {test.sign * best:.6g}"
    bars = []
    for look in range(rule.looks - 1):
        gains = [
            max(0.0, test.measure(so_far) - test.measure(end))
            for so_far, end, _ in _finished(rows, test.output, look)
        ]
        gain = max(gains, default=0.0)
        words = f"{start}, and none of {len(gains)} improved by more than {gain:.6g} from here"
        bars.append(Bar(best + gain if len(gains) >= rule.after else inf, words))
    return replace(test, bars=tuple(bars))


def _percentile(
    rule: Percentile, test: Comparison, rows: Sequence[Row], feasible: Callable[[Row], bool]
) -> Comparison:
    """Return a test with bars: continue while the best look so far is within a percentile.

    Of variants that break a constraint nothing is learned: their objective may be as good as none
    that is allowed.
    """
    import numpy as np

    bars = []
    for look in range(rule.looks - 1):
        known = [test.measure(so_far) for so_far, _, row in _finished(rows, test.output, look)
                 if feasible(row)]  # fmt: skip
        if len(known) < rule.after:
            bars.append(Bar(inf, ""))
            continue
        limit = float(np.percentile(known, rule.percentile))
        share = f"{rule.percentile:g} % of {len(known)}"
        bars.append(Bar(limit, f"{share} were at {test.sign * limit:.6g} or better here"))
    return replace(test, bars=tuple(bars))


def _finished(
    rows: Iterable[Row], name: str, look: int | None = None
) -> list[tuple[float, float, Row]]:
    """Return the values of an output at a look and at the end, of finished rows that have both."""
    found = []
    for row in rows:
        so_far, end = row.so_far.get(name, []), row.outputs.get(name)
        if row.status != "done" or end is None:
            continue
        value = end if look is None else so_far[look] if look < len(so_far) else None
        if value is not None:
            found.append((value, end, row))
    return found


@dataclass(frozen=True)
class Saving:
    """Steps that a study took, and those that it did not take as runs were stopped.

    A stopped variant would have taken as many runs as the finished ones on average, which is one
    unless a mean force is searched for.
    """

    taken: int
    saved: float

    @classmethod
    def of(cls, rows: Iterable[Row]) -> "Saving":
        """Return the saving of the rows of a study."""
        steps, of_run = Counter[str](), Counter[str]()
        for row in rows:
            steps[row.status] += row.steps
            of_run[row.status] += row.steps_of_run
        return cls.of_counts(steps, of_run)

    @classmethod
    def of_counts(cls, steps: Counter[str], of_run: Counter[str]) -> "Saving":
        """Return the saving from steps taken, and steps of one run each, by status."""
        runs = steps["done"] / of_run["done"] if of_run["done"] else 1.0
        return cls(steps.total(), runs * of_run["pruned"] - steps["pruned"])

    @property
    def percent(self) -> float:
        """Steps saved in % of those that all variants would have taken."""
        return 100.0 * self.saved / (self.taken + self.saved) if self.saved else 0.0
