"""Tables of an explanation as text: contributions, places, modes, sensitivities."""

from collections.abc import Sequence
from typing import Any

from arcless.display.numbers import number
from arcless.explanation.pantograph_explanation import PantographExplanation
from arcless.explanation.parts import Place
from arcless.explanation.sensitivity import LEAST, Sensitivities

NONE = "–"
# Titles of the columns of `group_rows`.
GROUPS = (
    "part", "share of σ², %", "± %", "root, N", "strongest at, Hz", "wavelength, m", "its share, %",
)  # fmt: skip
# Explanation of the tables, the same on pages and on paper.
READS = (
    "The parts add up to the variance σ²; their roots do not add up to σ. Waves that repeat from "
    "span to span are span passing if they are longer than two dropper intervals, and dropper "
    "passing if they are shorter. Waves that do not repeat belong to the bands of the pantograph "
    "modes or to the rest. Modes also amplify repeating waves; the last column includes them. ± is "
    "the standard uncertainty due to the length of the section."
)


def tables(
    pantographs: Sequence[PantographExplanation], known: Sensitivities | None
) -> list[dict[str, Any]]:
    """Return sentences and tables of each pantograph as rows of text."""
    return [
        {
            "name": one.name,
            "sentences": one.sentences(known),
            "groups": group_rows(one),
            "modes": mode_rows(one),
            "worst": place_rows(one.worst),
            "irregular": place_rows(one.irregular),
        }
        for one in pantographs
    ]


def group_rows(one: PantographExplanation) -> list[list[str]]:
    """Return name, share, its uncertainty, part of σ, frequency and wavelength of each group."""
    rows = []
    for group in one.groups:
        strongest = group.strongest
        where = [NONE, NONE, NONE]
        if strongest is not None:
            where = [
                number(strongest.frequency_Hz, 2),
                number(strongest.wavelength_m, 1),
                number(strongest.share_percent, 1),
            ]
        rows.append([
            group.name, number(group.share_percent, 1), number(group.uncertainty_percent, 1),
            number(group.std_N, 1), *where,
        ])  # fmt: skip
    return rows


def mode_rows(one: PantographExplanation) -> list[list[str]]:
    """Return number, frequency, band, damping, own share and share in the band of each mode."""
    return [
        [
            str(mode.number), number(mode.frequency_Hz, 2),
            f"{number(mode.band_Hz[0], 2)} to {number(mode.band_Hz[1], 2)}",
            number(mode.damping_ratio, 2), number(mode.share_percent, 1),
            number(mode.in_band_percent, 1),
        ]
        for mode in one.modes
    ]  # fmt: skip


def place_rows(places: Sequence[Place]) -> list[list[str]]:
    """Return position, span, force, deviation, what is nearest, what is not as designed."""
    return [
        [
            number(place.position_m, 1), NONE if place.span is None else str(place.span),
            number(place.force_N, 1), ("+" if place.deviation_N > 0 else "")
            + number(place.deviation_N, 1),
            place.where, place.as_built or "",
        ]
        for place in places
    ]  # fmt: skip


def sensitivity_rows(known: Sensitivities | None) -> list[list[str]]:
    """Return parameter, pantograph, % of σ per %, its uncertainty, and a remark."""
    if known is None:
        return []
    rows = []
    for one in known.parameters:
        if not one.effects:
            rows.append([one.parameter, "", NONE, NONE, one.note])
        for effect in one.effects:
            remark = "" if effect.significant else "not larger than its uncertainty"
            if abs(effect.percent_per_percent) < LEAST:
                remark = f"below {LEAST:g}"
            elif effect.significant and not effect.linear:
                remark = f"not linear: {_slope(effect.below)} below, {_slope(effect.above)} above"
            rows.append([
                one.parameter, effect.pantograph, _slope(effect.percent_per_percent),
                number(effect.uncertainty, 2), remark,
            ])  # fmt: skip
    return rows


def _slope(value: float) -> str:
    """Return a slope with two decimals; one that rounds to zero has no sign."""
    return number(value if abs(value) >= LEAST / 2.0 else 0.0, 2)
