"""Sentences of an explanation, from its numbers alone."""

from collections.abc import Sequence
from math import hypot

from arcless.explanation.parts import Group, Place
from arcless.explanation.sensitivity import Sensitivities

# A share stands out if it is larger than the next by so many standard uncertainties of the
# difference. Smaller, chance is told as a cause; larger, clear cases stay open.
CLEAR = 2.0


def largest_share(std_force_N: float, groups: Sequence[Group]) -> str:
    """Return what the largest share of σ² is, at which frequency and wavelength."""
    first, second = sorted(groups, key=lambda one: -one.share_percent)[:2]
    begin = f"σ is {std_force_N:.1f} N"
    if first.uncertainty_percent is None or second.uncertainty_percent is None:
        return f"{begin}; the section is too short to state the uncertainty of its shares."
    apart = first.share_percent - second.share_percent
    if apart <= CLEAR * hypot(first.uncertainty_percent, second.uncertainty_percent):
        both = " and ".join(f"{one.name} {share(one)}" for one in (first, second))
        return f"{begin}, and no share of its variance stands out: {both}."
    found = first.strongest
    assert found is not None, "the largest share has a variance"
    wavelength = "" if found.wavelength_m is None else f", wavelength {found.wavelength_m:.1f} m"
    mode = "" if found.mode is None else f", in the band of pantograph mode {found.mode}"
    return (
        f"{begin}; the largest share of its variance is {first.name}, {share(first)}. Its strongest"
        f" wave has {found.share_percent:.0f} % at {found.frequency_Hz:.2f} Hz{wavelength}{mode}."
    )


def share(one: Group) -> str:
    """Return the share of a group with its uncertainty, with decimals where that is small."""
    unsure = one.uncertainty_percent
    if unsure is None:
        return f"{one.share_percent:.0f} %"
    decimals = 0 if unsure >= 1.0 else 1
    return f"{one.share_percent:.{decimals}f} ± {unsure:.{decimals}f} %"


def where_worst(worst: Sequence[Place], irregular: Sequence[Place]) -> str:
    """Return where the force deviates most, and what differs from span to span."""
    place = worst[0]
    size = f"{abs(place.deviation_N):.0f} N {_side(place)} F_m"
    text = f"The force deviates most at {place_words(place)}: {size}"
    outstanding = [one for one in irregular if one.stands_out]
    if not outstanding:
        return f"{text}; no place stands out from what repeats."
    other = outstanding[0]
    return (
        f"{text}; from what repeats it differs most at {place_words(other)}:"
        f" {abs(other.deviation_N):.0f} N {_side(other)} what repeats."
    )


def _side(place: Place) -> str:
    return "above" if place.deviation_N > 0.0 else "below"


def place_words(place: Place) -> str:
    """Return position, span, what is nearest, and what is not as designed there."""
    span = "" if place.span is None else f", span {place.span}"
    changed = "" if place.as_built is None else f" (as built: {place.as_built})"
    return f"{place.position_m:.1f} m{span}, {place.where}{changed}"


def strongest_change(sensitivities: Sensitivities, pantograph: str) -> str:
    """Return which change lowers σ of a pantograph most."""
    found = sensitivities.strongest(pantograph)
    if found is None:
        return "No varied parameter lowers σ by more than the uncertainty of the difference."
    parameter, effect = found
    step = sensitivities.step_percent
    unsure = step * effect.uncertainty
    decimals = 1 if unsure >= 0.1 else 2  # noqa: PLR2004 - ± 0.0 would say nothing
    return (
        f"Among the varied parameters, {step:g} % {effect.better} {parameter.parameter} lowers σ"
        f" most: by {effect.lowers_percent:.{decimals}f} ± {unsure:.{decimals}f} %."
    )
