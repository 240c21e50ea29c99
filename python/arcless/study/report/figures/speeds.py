"""Resonance speeds in the report of a study that varies the speed: lines in figures, and a table.

They are those of the scenario that the study varies, at rest: computed when the report is made.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from arcless.errors import ArclessError
from arcless.figures.description import Axis, Layer, Rules, Texts
from arcless.figures.description.layers import Dash
from arcless.figures.description.tokens import of_series
from arcless.study.definition.study import Study
from arcless.study.report.data.record import Column, Record

if TYPE_CHECKING:
    from arcless.simulate import ResonanceSpeeds
    from arcless.simulate.resonance import ResonanceSpeed

FIELD = "speed"
# Kind → legend, colour, dashes.
_STYLES: dict[str, tuple[str, int, Dash]] = {
    "wave speed": ("wave speed", 7, "solid"),
    "span of the line": ("span, line", 2, "dashed"),
    "span and pantograph": ("span, pantograph", 3, "dashed"),
    "droppers and pantograph": ("droppers, pantograph", 4, "dotted"),
    "parametric": ("parametric", 6, "dashed"),
    "spacing, worst": ("spacing, worst", 6, "dashed"),
    "spacing, best": ("spacing, best", 5, "dotted"),
}
# Numbers nearer than this part of the axis stand below one another; part of it that a row has.
_APART, _ROW, _ROWS = 0.02, 0.045, 4
# Fields besides the speed that leave the speeds as they are.
_FORCES = ("static_force", "mean_force")


@dataclass(frozen=True)
class SpeedMarks:
    """Resonance speeds of a study; those inside of its range of speed have a number, from 1."""

    column: Column
    numbered: tuple[tuple[int | None, "ResonanceSpeed"], ...]
    notes: tuple[str, ...]

    def rows(self) -> list[dict[str, str]]:
        """Return the rows of the table."""
        return [
            {
                "number": "" if number is None else str(number),
                "kind": one.kind,
                "name": one.name,
                "speed": self._shown(one.speed.middle),
                "band": self._band(one),
                "formula": one.formula,
                "frequency": "" if one.frequency_Hz is None else f"{one.frequency_Hz:.2f}",
                "about": one.about,
                "source": one.source,
            }
            for number, one in self.numbered
        ]

    def layers(self, axis: Axis) -> list[Layer]:
        """Return the numbered speeds as rules, with their numbers at the top of an axis."""
        drawn = [(number, one) for number, one in self.numbered if number is not None]
        layers: list[Layer] = []
        for kind, (name, place, dash) in _STYLES.items():
            x = [one.speed.middle / self.column.scale for _, one in drawn if one.kind == kind]
            if x:
                layers.append(
                    Rules(axis="x", at=np.array(x), colour=of_series(place), dash=dash,
                          width=1.4, name=name)
                )  # fmt: skip
        x = [one.speed.middle / self.column.scale for _, one in drawn]
        assert axis.high is not None
        assert axis.low is not None
        down = _ROW * (axis.high - axis.low)
        y = [axis.high - down * (row + 0.5) for row in rows_of(x, self._width)]
        numbers = [f"\u2002{number}" for number, _ in drawn]  # next to the line, not on it
        return [*layers, Texts(np.array(x), np.array(y), numbers, colour="soft", align="left")]

    def _shown(self, speed_m_s: float) -> str:
        """Return a speed in the unit of the axis: km/h whole, m/s with a tenth."""
        return f"{speed_m_s / self.column.scale:.{0 if self.column.scale < 1.0 else 1}f}"

    def _band(self, one: "ResonanceSpeed") -> str:
        low, high = one.speed.low, one.speed.high
        return "" if low == high else f"{self._shown(low)} to {self._shown(high)}"

    @property
    def _width(self) -> float:
        return float(np.ptp(self.column.values))


def marks(record: Record) -> SpeedMarks | None:
    """Return the resonance speeds of a study; None where its speed is no variable.

    A line without equilibrium has none, which the notes say: the report is made all the same.
    """
    column = speed_column(record)
    if column is None:
        return None
    from arcless.simulate import ResonanceSpeeds, resonance_speeds
    from arcless.simulate.resonance.speeds import TOO_FAST

    try:
        found = resonance_speeds(record.study.base)
    except ArclessError as error:
        found = ResonanceSpeeds((), (f"no resonance speeds: {error}",))
    spaced = any(axis.field.endswith(".distance") for axis in record.study.axes)
    numbered = _numbered(column, found, spaced=spaced)
    # Of what is far above the speeds of the study nobody asks.
    notes = [note for note in found.notes if note != TOO_FAST]
    return SpeedMarks(column, numbered, (*notes, *_varied(record.study)))


def speed_column(record: Record) -> Column | None:
    """Return the variable that is the speed, where it takes different values."""
    for axis, column in zip(record.study.axes, record.variables, strict=True):
        if axis.field == FIELD and column.words is None and column.varies:
            return column
    return None


def rows_of(places: list[float], width: float) -> list[int]:
    """Return a row for each of some rising places, so that neighbours do not overlap."""
    ends = [-np.inf] * _ROWS
    rows = []
    for x in places:
        free = [row for row in range(_ROWS) if x - ends[row] >= _APART * width]
        row = free[0] if free else int(np.argmin(ends))
        ends[row] = x
        rows.append(row)
    return rows


def _numbered(
    column: Column, found: "ResonanceSpeeds", *, spaced: bool
) -> tuple[tuple[int | None, "ResonanceSpeed"], ...]:
    low, high = (column.scale * float(end(column.values)) for end in (np.nanmin, np.nanmax))
    numbers = iter(range(1, len(found.speeds) + 1))
    return tuple(
        (next(numbers) if low <= one.speed.middle <= high else None, one)
        for one in found.speeds
        if not (spaced and one.kind.startswith("spacing"))
    )


def _varied(study: Study) -> list[str]:
    """Say which other variables the speeds would follow."""
    spaced = [axis.name for axis in study.axes if axis.field.endswith(".distance")]
    notes = [
        f"speeds that follow from the distance of pantographs are left out, as {name} is varied"
        for name in spaced
    ]
    others = [
        axis.name
        for axis in study.axes
        if axis.field.startswith(("line", "as_built", "contact", "pantographs"))
        and not axis.field.endswith(_FORCES)
        and axis.name not in spaced
    ]
    if not others:
        return notes
    return [*notes, f"of the scenario with its own values of {', '.join(others)}, not those varied"]
