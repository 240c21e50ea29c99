"""The conclusions of the founding paper, checked on its worked example (PRAKS).

The text of the paper that we have gives conclusions and captions, no curves: only the conclusions
can be checked, in the words in which this project states them.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from arcless.display.numbers import signed
from arcless.model import load
from arcless.validate.hanger_joints import PIECE, JointChanges
from arcless.validate.observation import SMALLEST_GAP, Observation
from arcless.validate.reference import INSIDE, VERIFIED, Range
from arcless.validate.rows import Progress, Row, part

if TYPE_CHECKING:
    from arcless.results import Result

SCENARIOS = ("praks-180", "praks-250", "praks-340", "praks-360")
FAST = 300 / 3.6  # m/s: the paper has gaps at 340 and 360 km/h, contact at 180 and 250 km/h
SOURCE = (
    "G. N. Kolesnikov, D. A. Kuvshinov, about 2009, UDC 519.61, as this project states it. The "
    "conclusions were read there (A); how they are measured, and the limits, are ours. The curves "
    "of the paper's figures are not in the text we have and are not compared"
)

# A force that varies with the place as a sine, whatever its period, has around its steepest places
# at most √2 of its own root mean square: changes twice as fast at joints are another thing.
FASTER = 2.0

_ASSUMED = (
    "assumed, as the paper is silent: sections and masses of the wires, hangers in the middle of "
    "the span that do not slacken, 2.5 kg of fittings at each joint, no damping, no friction"
)
JOINTS, INTERVAL, GAPS = (
    "1 force changes fast at hanger joints",
    "2 interval of the force widens with speed",
    "3 gaps at high speed",
)
CONCLUSIONS: dict[str, tuple[str, str]] = {
    JOINTS: (
        "Unfiltered force, its change over each 0.25 m of the section. Located: around every "
        "joint, up to halfway to the next, the fastest change is within 0.5 m of it. Fast: the "
        "changes within 0.5 m of joints are at least twice those elsewhere, root mean square.",
        f"Rigid contact and the paper's scheme; {_ASSUMED}.",
    ),
    INTERVAL: (
        "Highest less lowest unfiltered force of the section, strictly increasing.",
        f"Rigid contact and the paper's scheme; {_ASSUMED}.",
    ),
    GAPS: (
        "Lowest unfiltered force above zero at 180 and 250 km/h; a gap in the section at 340 and "
        "360 km/h.",
        "Needs the fittings: without their mass no gap at any of the speeds. Rigid contact and the "
        f"paper's scheme, which damps and so hides gaps; {_ASSUMED}.",
    ),
}


def rows(observations: Sequence[Observation]) -> list[Row]:
    """Hold observations at increasing speeds against the three conclusions."""
    made = [row for seen in observations for row in _joint_rows(seen)]
    below = 0.0
    for seen in observations:
        made.append(_interval_row(seen, below))
        below = seen.width
    return made + [_gap_row(seen) for seen in observations]


def held(rows_: Sequence[Row]) -> dict[str, bool]:
    """Say of each conclusion whether all of its rows hold."""
    return {
        conclusion: all(row.verdict == INSIDE for row in rows_ if row.case == conclusion)
        for conclusion in CONCLUSIONS
    }


def runs(progress: Progress | None = None) -> "list[Result]":
    """Run the worked example at its four speeds.

    Parameters
    ----------
    progress : callable, optional
        Called with the done fraction and what is being done.
    """
    from arcless.simulate import run as simulate

    count = len(SCENARIOS)
    return [
        simulate(load(name), progress=part(progress, index / count, (index + 1) / count))
        for index, name in enumerate(SCENARIOS)
    ]


def _row(conclusion: str, allowed: Range, value: float, note: str) -> Row:
    checked, assumption = CONCLUSIONS[conclusion]
    return Row.of(conclusion, allowed, value, note=note, checked=checked, assumption=assumption)


def _joint_rows(seen: Observation) -> list[Row]:
    changes = seen.changes
    count = len(changes.joints)
    what = f"{seen.kmh}: change at joints over change elsewhere"
    ratio = Range(
        "joint_change_ratio", f"{what}, lowest of {count} joints", "", 1.0, None, VERIFIED,
        strict=True,
    )  # fmt: skip
    rms = Range(
        "joint_change_rms_ratio", f"{what}, root mean square", "", FASTER, None, VERIFIED,
    )  # fmt: skip
    sizes = f"{changes.near:.1f} N at joints, {changes.elsewhere:.1f} N elsewhere, over {PIECE} m"
    return [
        _row(JOINTS, ratio, changes.least_ratio if count else 0.0, _places(changes)),
        _row(JOINTS, rms, changes.rms_ratio, sizes),
    ]


def _places(changes: JointChanges) -> str:
    """Say where the force changes fastest."""
    if not changes.joints:
        return "no hanger joint in the section"
    away = [joint.fastest - joint.x for joint in changes.joints]
    most = changes.largest
    return (
        f"located at {changes.located} of {len(away)} joints, {signed(min(away), 2)} to "
        f"{signed(max(away), 2)} m from them; largest: {signed(most.change)} N at "
        f"{most.place:.2f} m, joint at {most.x:g} m"
    )


def _interval_row(seen: Observation, below: float) -> Row:
    allowed = Range(
        "force_interval_N", f"{seen.kmh}: width of the interval of the contact force", "N", below,
        None, VERIFIED, strict=True,
    )  # fmt: skip
    return _row(INTERVAL, allowed, seen.width, f"{seen.low:.1f} to {seen.high:.1f} N")


def _gap_row(seen: Observation) -> Row:
    lost = f"contact lost during {seen.loss:.2f} % of the time"
    if seen.speed > FAST:
        allowed = Range(
            "max_gap_mm", f"{seen.kmh}: maximum gap", "mm", SMALLEST_GAP, None, VERIFIED,
            strict=True, digits=3,
        )  # fmt: skip
        places = ", ".join(f"{x:.2f}" for x in seen.gaps_at)
        return _row(GAPS, allowed, seen.gap, f"at {places} m; {lost}" if places else lost)
    allowed = Range(
        "unfiltered_min_force_N", f"{seen.kmh}: minimum contact force", "N", 0.0, None, VERIFIED,
        strict=True,
    )  # fmt: skip
    return _row(GAPS, allowed, seen.low, lost)
