"""Indicators of runs side by side, their differences to the first run, and verdicts.

With the spreads s₁, s₂ and the errors of discretisation e₁, e₂ of two numbers, as
assess/certainty.py defines them, their difference is sure to

    u = √(s₁² + s₂²) + e₁ + e₂.

Spreads are of draws that know nothing of each other, so their squares add up; errors of
discretisation have a size and a sign each, which may be opposite (GUM, JCGM 100:2008, 5.1.2 and
F.2.4.5, from memory). A difference that is no larger than u is too close to tell.
"""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from math import hypot
from typing import Any

from arcless.assess import Assessment, Criterion, decimals_of, uncertainty_of, verdict_of
from arcless.assess.quantities import OF_LINE, OF_PANTOGRAPH, WEAR, Quantity, label_of
from arcless.comparison.subjects.runs import Slot

Values = tuple[float | None, ...]
# A first value below this part of its unit has no percentage: it is zero with rounding errors.
ZERO = 1e-9


@dataclass(frozen=True)
class Indicator:
    """A quantity of a pantograph, or of the line, in each run.

    Attributes
    ----------
    key, label, unit, decimals
        The quantity, by the vocabulary of assessments.
    pantograph
        Name of the pantograph; None for a number of the line.
    values
        Of each run; None where it has none.
    uncertainties
        Half widths in the same unit; None where nobody asked for the certainty.
    differences
        Values less that of the first run; None where one of them is missing.
    percents
        Differences in % of the size of the first value; None also where that is zero, and for
        quantities that are percentages.
    difference_uncertainties
        Half widths of the differences in the same unit; None where one of the two runs has no
        certainty, and for the first run.
    """

    key: str
    label: str
    unit: str
    decimals: int
    pantograph: str | None
    values: Values
    uncertainties: Values
    differences: Values
    percents: Values
    difference_uncertainties: Values

    def too_close_to_tell(self, run: int) -> bool:
        """Return whether the difference of a run is no larger than its uncertainty.

        Numbers that are sure and equal, such as two zeros, are equal: nothing is to tell.
        """
        difference, most = self.differences[run], self.difference_uncertainties[run]
        return bool(difference is not None and most and abs(difference) <= most)


@dataclass(frozen=True)
class Judged:
    """A criterion in each run; `limits`, `values` and `verdicts` are None where a run lacks it."""

    name: str
    title: str
    unit: str
    decimals: int
    pantograph: str | None
    values: Values
    limits: Values
    verdicts: tuple[str | None, ...]
    fails: tuple[bool, ...]


def indicators(assessments: Sequence[Assessment], slots: Sequence[Slot]) -> list[Indicator]:
    """Return the numbers of each pantograph, then those of the line."""
    first = assessments[0]
    found = []
    for slot in slots:
        parts = [
            None if place is None else one.pantographs[place]
            for one, place in zip(assessments, slot.places, strict=True)
        ]
        worn = any(p is not None and p.wear_mechanical_mm3_km is not None for p in parts)
        for key, quantity in {**OF_PANTOGRAPH, **(WEAR if worn else {})}.items():
            found.append(_indicator(first, key, quantity, slot.name, parts))
    for key, quantity in OF_LINE.items():
        found.append(_indicator(first, key, quantity, None, assessments))
    return [one for one in found if any(value is not None for value in one.values)]


def judged(assessments: Sequence[Assessment], slots: Sequence[Slot]) -> list[Judged]:
    """Return the criteria in the order of the assessments, each with its verdicts."""
    # A criterion of a pantograph stands under the name of its slot.
    tables: list[dict[tuple[str, str | None], Criterion]] = []
    for run, one in enumerate(assessments):
        names = {one.pantographs[place].name: slot.name
                 for slot in slots if (place := slot.places[run]) is not None}  # fmt: skip
        tables.append({
            (c.name, None if c.pantograph is None else names[c.pantograph]): c
            for c in one.criteria
        })  # fmt: skip
    found = []
    for key in dict.fromkeys(key for table in tables for key in table):
        row = [table.get(key) for table in tables]
        any_one = next(one for one in row if one is not None)
        found.append(
            Judged(
                any_one.name, any_one.title, "" if any_one.unit == "1" else any_one.unit,
                max(decimals_of(asdict(one)) for one in row if one is not None), key[1],
                tuple(None if one is None else one.value for one in row),
                tuple(None if one is None else one.limit for one in row),
                tuple(None if one is None else verdict_of(asdict(one)) for one in row),
                tuple(one is not None and one.fails for one in row),
            )
        )  # fmt: skip
    return found


def _indicator(
    first: Assessment, key: str, quantity: Quantity, pantograph: str | None, parts: Sequence[Any]
) -> Indicator:
    values = tuple(None if part is None else getattr(part, key) for part in parts)
    certainties = [None if part is None else (part.certainty or {}).get(key) for part in parts]
    sure = tuple(uncertainty_of(one) for one in certainties)
    unsure = tuple(_unsure(certainties[0], one) if run else None
                   for run, one in enumerate(certainties))  # fmt: skip
    differences = tuple(_difference(values[0], value) for value in values)
    percents = tuple(_percent(values[0], one, quantity.unit) for one in differences)
    label = label_of(key, low_pass_Hz=first.low_pass_Hz, band_split_Hz=first.band_split_Hz)
    return Indicator(key, label, quantity.unit, quantity.decimals, pantograph, values, sure,
                     differences, percents, unsure)  # fmt: skip


def _difference(first: float | None, value: float | None) -> float | None:
    return None if first is None or value is None else value - first


def _unsure(
    first: Mapping[str, float | None] | None, other: Mapping[str, float | None] | None
) -> float | None:
    """Return u of the difference of two numbers; None where one has no certainty."""
    if uncertainty_of(first) is None or uncertainty_of(other) is None:
        return None
    (s1, e1), (s2, e2) = (
        ((one or {}).get("spread") or 0.0, (one or {}).get("discretisation") or 0.0)
        for one in (first, other)
    )
    return hypot(s1, s2) + e1 + e2


def _percent(first: float | None, difference: float | None, unit: str) -> float | None:
    if first is None or difference is None or unit == "%" or abs(first) < ZERO:
        return None
    return 100.0 * difference / abs(first)
