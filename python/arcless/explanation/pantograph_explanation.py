"""Force of one pantograph over the section → its explanation."""
# ruff: noqa: N815 - the names carry their units

from dataclasses import asdict, dataclass, fields
from math import sqrt
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.assess.section import FEWEST_SPANS, counted_spans, too_short
from arcless.errors import ExplanationError
from arcless.explanation import places, words
from arcless.explanation.landmarks import Landmarks
from arcless.explanation.parts import (
    Group,
    Mode,
    OrderShare,
    Place,
    SpanDeviation,
    Trace,
)
from arcless.explanation.sensitivity import Sensitivities
from arcless.explanation.shares import Shares
from arcless.explanation.signals.line_coordinate import LineCoordinate
from arcless.explanation.signals.orders import ABOVE_LOW_PASS, fit, orders
from arcless.explanation.signals.remainder import Lines
from arcless.explanation.signals.span_deviations import deviations
from arcless.pantograph.natural_modes import PantographMode

Floats = NDArray[np.float64]

# Deviation in N below which a force is constant: shares of it would be shares of rounding.
CONSTANT = 1e-6


@dataclass(frozen=True)
class Passage:
    """Filtered force of one pantograph inside the analysis section.

    Attributes
    ----------
    name
        Name of the pantograph.
    position, force
        Position in m and filtered force in N, at equal time steps.
    rate_Hz, low_pass_Hz
        Recording rate, and cut-off of the filter.
    speed
        Mean speed in m/s.
    ends
        Ends in m of the part of the section that it ran over.
    spans
        Number and ends of the whole spans in it.
    modes
        Natural modes of the pantograph on the line.
    """

    name: str
    position: Floats
    force: Floats
    rate_Hz: float
    low_pass_Hz: float
    speed: float
    ends: tuple[float, float]
    spans: list[tuple[int, float, float]]
    modes: list[PantographMode]


@dataclass(frozen=True)
class PantographExplanation:
    """Explanation of σ of one pantograph.

    Attributes
    ----------
    name
        Name of the pantograph.
    mean_force_N, std_force_N
        Of the filtered force, as assessed.
    spans_in_section
        Length of the section in spans.
    groups
        Four parts of the variance that add up to it.
    orders
        Orders of spans and droppers, the longest wave first.
    modes
        Natural modes of the pantograph on the line.
    by_span
        Deviation in each whole span.
    worst
        Largest deviations from the mean, the largest first.
    irregular
        Largest deviations from what repeats.
    trace
        Signals behind them; no part of `to_dict`.
    """

    name: str
    mean_force_N: float
    std_force_N: float
    spans_in_section: float
    groups: tuple[Group, ...]
    orders: tuple[OrderShare, ...]
    modes: tuple[Mode, ...]
    by_span: tuple[SpanDeviation, ...]
    worst: tuple[Place, ...]
    irregular: tuple[Place, ...]
    trace: Trace

    def sentences(self, sensitivities: Sensitivities | None = None) -> list[str]:
        """Return the explanation in words: share, place and, where computed, change."""
        said = [
            words.largest_share(self.std_force_N, self.groups),
            words.where_worst(self.worst, self.irregular),
        ]
        if sensitivities is not None:
            said.append(words.strongest_change(sensitivities, self.name))
        return said

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, ready for JSON."""
        names = [one.name for one in fields(self) if one.name != "trace"]
        found: dict[str, Any] = {name: getattr(self, name) for name in names}
        return {
            name: [asdict(one) for one in value] if isinstance(value, tuple) else value
            for name, value in found.items()
        }


def explained(passage: Passage, line: LineCoordinate, marks: Landmarks) -> PantographExplanation:
    """Explain the deviation of one pantograph's force.

    Raises
    ------
    ExplanationError
        The section has less than two spans, or the force is constant.
    """
    deviation = passage.force - passage.force.mean()
    variance = float(np.mean(deviation**2))
    count = float(np.ptp(line.spans(np.array(passage.ends))))
    _check(passage, count, variance)
    begin, end = passage.ends
    mean_span = (end - begin) / count
    highest = ABOVE_LOW_PASS * passage.low_pass_Hz
    taken = orders(line, begin, end, highest * mean_span / passage.speed)
    if not taken:
        raise ExplanationError(
            "spans pass faster than the low-pass lets through",
            where=f"pantograph {passage.name}",
            got=f"{passage.speed / mean_span:.3g} spans a second",
            expected=f"at most {highest:g}",
            hint="raise `analysis.low_pass`",
        )
    intervals = line.intervals(passage.position) if line.droppers.size > 1 else 0.0 * deviation
    split = fit(deviation, line.spans(passage.position), intervals, taken)
    own = [one for one in passage.modes if one.frequency.middle <= highest]
    lines = Lines.of(split.remainder, passage.rate_Hz)
    shares = Shares(split, lines, own, mean_span, passage.speed)
    x, force = passage.position, passage.force
    numbers = zip(passage.spans, deviations(x, force, passage.spans), strict=True)
    return PantographExplanation(
        name=passage.name,
        mean_force_N=float(force.mean()),
        std_force_N=sqrt(variance),
        spans_in_section=count,
        groups=shares.groups(),
        orders=shares.orders(line.intervals_per_span(begin, end)),
        modes=shares.modes(),
        by_span=tuple(SpanDeviation(*span, float(value)) for span, value in numbers),
        worst=places.worst(marks, x, force, mean_span),
        irregular=places.irregular(marks, x, force, split.remainder, mean_span),
        trace=Trace(
            x, split.remainder, shares.lines.frequency, shares.lines.variance, shares.owner
        ),
    )


def _check(passage: Passage, spans: float, variance: float) -> None:
    if too_short(spans):
        begin, end = passage.ends
        raise ExplanationError(
            "the section is too short to tell what repeats",
            where=f"pantograph {passage.name}",
            got=f"{begin:g} to {end:g} m, {counted_spans(spans)}",
            expected=f"at least {FEWEST_SPANS:g} spans",
            hint="set `analysis.from` and `analysis.to`, and let the run continue to the end",
        )
    if sqrt(variance) < CONSTANT:
        raise ExplanationError(
            "the contact force is constant",
            where=f"pantograph {passage.name}",
            got=f"σ = {sqrt(variance):.1e} N",
            expected=f"at least {CONSTANT:g} N",
        )
