"""Run the reference cases and compare."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Self

from arcless.errors import ModelError
from arcless.model import Scenario, load
from arcless.validate.reference import CASES, DROPPERS, OUTSIDE, Case, Range

SUITES = ("en50318", "seed", "all")
Progress = Callable[[float, str], None]


@dataclass(frozen=True, slots=True)
class Row:
    """One comparison: `value` against `low` … `high`, all in `unit`; verdict as in `Range`."""

    case: str
    key: str
    quantity: str
    unit: str
    value: float | None
    low: float
    high: float
    mark: str
    verdict: str

    @property
    def violates(self) -> bool:
        """Whether the value is outside of a range that was read in a source."""
        return self.verdict == OUTSIDE

    @classmethod
    def of(cls, case: str, allowed: Range, value: float | None) -> Self:
        """Compare a value with what is allowed."""
        return cls(
            case=case,
            key=allowed.key,
            quantity=allowed.label,
            unit=allowed.unit,
            value=value,
            low=allowed.low,
            high=allowed.high,
            mark=allowed.mark,
            verdict=allowed.verdict(value),
        )


def run(which: str = "all", progress: Progress | None = None) -> list[Row]:
    """Run the reference cases of a suite.

    Parameters
    ----------
    which : {"en50318", "all"}
        The suite. This version holds one; "all" runs every suite that exists.
    progress : callable, optional
        Called with the done fraction and what is being done.

    Returns
    -------
    list of Row
        One row per published range.
    """
    if which not in ("en50318", "all"):
        raise ModelError(
            "reference cases",
            got=f"`{which}`",
            expected="`en50318` or `all`",
            hint="the cases of the published seed method are not part of this version",
        )
    steps = len(CASES) + 1
    rows = _dropper_rows(_part(progress, 0, steps))
    for index, case in enumerate(CASES, start=1):
        rows += _case_rows(case, _part(progress, index, steps))
    return rows


def compare(case: Case, assessment: dict[str, Any]) -> list[Row]:
    """Hold an assessment against each range of a case.

    The ranges are published for one pantograph: the first one is compared.
    """
    values = {**assessment, **assessment["pantographs"][0]}
    return [Row.of(case.title, allowed, values[allowed.key]) for allowed in case.ranges]


def case_of(scenario: Scenario) -> Case | None:
    """Find the ranges published for a scenario; none if it differs from the shipped one."""
    for case in CASES:
        if scenario.name == case.scenario and _same(scenario, load(case.scenario)):
            return case
    return None


def _same(one: Scenario, other: Scenario) -> bool:
    # What is recorded, and a note that it was set, change no result; everything else may.
    ignored = {"output", "provenance"}
    return one.model_dump(exclude=ignored) == other.model_dump(exclude=ignored)


def _case_rows(case: Case, progress: Progress | None) -> list[Row]:
    from arcless.simulate import run as simulate

    result = simulate(load(case.scenario), progress=progress)
    return compare(case, result.assessment.to_dict())


def _dropper_rows(progress: Progress | None) -> list[Row]:
    from arcless.simulate import statics

    droppers = statics(load(DROPPERS.scenario), progress=progress).to_dict()["droppers"]
    middle = (1 + max(dropper["span"] for dropper in droppers)) // 2
    found = [dropper["length_m"] for dropper in droppers if dropper["span"] == middle]
    pairs = zip(found, DROPPERS.lengths, strict=True)
    return [
        Row.of(
            DROPPERS.title,
            Range(
                key="length_m",
                label=f"length of dropper {number}, span {middle}",
                unit="m",
                low=published - DROPPERS.tolerance,
                high=published + DROPPERS.tolerance,
                mark=DROPPERS.mark,
            ),
            value,
        )
        for number, (value, published) in enumerate(pairs, start=1)
    ]


def _part(progress: Progress | None, index: int, steps: int) -> Progress | None:
    """Map the progress of one case onto its share of the whole."""
    if progress is None:
        return None
    whole = progress
    return lambda fraction, text: whole((index + fraction) / steps, text)
