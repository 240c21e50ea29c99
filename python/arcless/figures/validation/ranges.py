"""Values of all cases in their published ranges, in one figure."""

from collections.abc import Sequence

import numpy as np

from arcless.figures.description import Axis, Bars, Figure, Layer, Points, Rules, Segments, Tip
from arcless.figures.validation.compared import Compared, State, state_of

# Ends of the axis, in parts of the range: what is further away is drawn there.
LOW, HIGH = -0.75, 1.75
ROW, FRAME = 27, 70
# Half of the height of a band, in rows.
HALF = 0.32
_NAMES: dict[State, str] = {
    "met": "inside", "not_met": "outside", "open": "unverified and outside, or too close to tell",
}  # fmt: skip


def in_range(row: Compared, value: float | None) -> float | None:
    """Return where a value lies in its range: 0 at the lower bound, 1 at the upper one.

    None for a range with one bound, and without a value. In a range of one number that number is
    in the middle, and all others are as far outside as the axis goes.
    """
    if value is None or row.low is None or row.high is None:
        return None
    if row.high > row.low:
        return (value - row.low) / (row.high - row.low)
    return 0.5 if value == row.low else HIGH if value > row.low else LOW


def overview(rows: Sequence[Compared], decides: Sequence[bool]) -> Figure | None:
    """Return all values with two bounds by their place in the range, a row for each case.

    Parameters
    ----------
    rows
        The comparisons.
    decides
        For each of them, whether its range decides something.

    Returns
    -------
    Figure or None
        None where no range has two bounds.
    """
    kept = [
        (row, place, counts) for row, counts in zip(rows, decides, strict=True)
        if (place := in_range(row, row.value)) is not None
    ]  # fmt: skip
    if not kept:
        return None
    # The first case stands at the top.
    cases = list(dict.fromkeys(row.case for row, _, _ in kept))[::-1]
    layers: list[Layer] = [
        Bars(np.zeros(len(cases)), np.ones(len(cases)), np.arange(len(cases)) - HALF,
             np.arange(len(cases)) + HALF, colour="met", alpha=0.12, name="range"),
        Rules(axis="x", at=np.array([0.0, 1.0]), colour="limit", width=1.0, dash="dashed"),
        *_whiskers(kept, cases),
        *_marks(kept, cases),
    ]  # fmt: skip
    outside = [row for row, _, _ in kept if state_of(row.verdict) == "not_met"]
    return Figure(
        "values-in-range", "Values in their published ranges",
        Axis("place in the range", "", LOW - 0.05, HIGH + 0.05),
        Axis("", "", -0.6, len(cases) - 0.4, categories=tuple(cases)), layers,
        caption="0 is the lower bound, 1 the upper one. Circles: verified ranges. Diamonds:"
        " ranges from memory, not checked in the standard; they do not count.",
        alt=f"{len(kept)} values of {len(cases)} cases in their ranges; {len(outside)} are outside"
        " of a verified range.",
        height=FRAME + ROW * len(cases),
    )  # fmt: skip


def _whiskers(kept: Sequence[tuple[Compared, float, bool]], cases: list[str]) -> list[Layer]:
    known = [
        (cases.index(row.case), in_range(row, row.value - row.uncertainty),
         in_range(row, row.value + row.uncertainty))
        for row, _, _ in kept
        if row.value is not None and row.uncertainty is not None and row.low != row.high
    ]  # fmt: skip
    if not known:
        return []
    y, low, high = (np.array(values, dtype=float) for values in zip(*known, strict=True))
    ends = (np.clip(low, LOW, HIGH), y, np.clip(high, LOW, HIGH), y)
    return [Segments(*ends, colour="soft", width=2.0, alpha=0.7, name="± certainty")]


def _marks(kept: Sequence[tuple[Compared, float, bool]], cases: list[str]) -> list[Layer]:
    layers: list[Layer] = []
    for counts in (False, True):
        for state, name in _NAMES.items():
            own = [(row, place) for row, place, c in kept
                   if c == counts and state_of(row.verdict) == state]  # fmt: skip
            if not own:
                continue
            found = [row for row, _ in own]
            tips = (
                Tip("", [row.case for row in found], form=""),
                Tip("", [f"{row.quantity}: {_value(row)}" for row in found], form=""),
                Tip(
                    "range", [f"{row.limit} {row.unit} (mark {row.mark})" for row in found], form=""
                ),
                Tip("verdict", [row.verdict for row in found], form=""),
            )
            layers.append(
                Points(
                    np.clip(np.array([place for _, place in own]), LOW, HIGH),
                    np.array([float(cases.index(row.case)) for row in found]),
                    colour=state, name=name, tips=tips, alpha=0.85, size=9.0 if counts else 8.0,
                    shape="circle" if counts else "diamond",
                )
            )  # fmt: skip
    return layers


def _value(row: Compared) -> str:
    sure = "" if row.uncertainty is None else f" ± {row.uncertainty:.{row.digits}f}"
    return f"{row.value:.{row.digits}f}{sure} {row.unit}".rstrip()
