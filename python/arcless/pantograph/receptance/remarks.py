"""Remarks about a fitted receptance: what a user should know before such a model is run."""

from math import isinf

import numpy as np

from arcless.pantograph.receptance.fitted import Fit
from arcless.pantograph.receptance.least_squares import LEAST_MASS, MOST_DAMPING, MOST_STIFFNESS
from arcless.pantograph.receptance.words import significant

# Misfits below are none that a test bench would notice, whatever their pattern.
NEGLIGIBLE = 1e-3
# Standard deviations of the correlation of neighbouring misfits beyond which it is no chance.
NO_CHANCE = 4.0
# Contact forces are assessed up to here (low-pass of EN 50317).
ASSESSED_HZ = 20.0
# ± over value from which a mass or a spring is said to be uncertain.
UNSURE = 0.2
# Masses up to which M, K and a full damping matrix have no more entries than a receptance has
# coefficients, 4n − 1: 2n + n(n + 1)/2 are 7 of 7 for two masses, and 12 of 11 for three.
UNIQUE = 2
# Phases outside of −180° to 0 by less are no news.
TOLD_DEGREES = 2.0
# Factor within which a parameter is at the bound of a search.
NEAR = 1.05
# Misfit over the given errors from which it is more than noise.
MORE_THAN_NOISE = 1.5


def remarks(fit: Fit) -> list[str]:
    """Return what a user should know about a fit, in sentences without a full stop."""
    return [*_of_misfit(fit), *_of_band(fit), *_of_parameters(fit), *_of_phases(fit)]


def _of_misfit(fit: Fit) -> list[str]:
    found = []
    alike = fit.alike
    if fit.misfit > NEGLIGIBLE and alike > NO_CHANCE / np.sqrt(2.0 * fit.data.frequency.size):
        found.append(
            f"misfits of neighbouring frequencies are alike (correlation {alike:.2f}): the model"
            " lacks something that was measured, and ± takes that for noise"
        )
    over = fit.over_noise
    if over is not None and over > MORE_THAN_NOISE:
        found.append(f"the misfit is {over:.1f} times the errors that are given with the data")
    return found


def _of_band(fit: Fit) -> list[str]:
    low, high = float(fit.data.frequency[0]), float(fit.data.frequency[-1])
    found = []
    if high < ASSESSED_HZ:
        found.append(
            f"the data end at {high:g} Hz; contact forces are assessed up to {ASSESSED_HZ:g} Hz,"
            " where this model was not compared with anything"
        )
    beyond = [mode.frequency_Hz for mode in fit.modes if mode.frequency_Hz > high]
    if beyond:
        found.append(
            f"above the data, which end at {high:g} Hz, the model has {_modes(beyond)}: only the"
            " flexibility below was measured"
        )
    below = [one.frequency_Hz for one in fit.modes if 0.0 < one.frequency_Hz < low]
    if below:
        found.append(
            f"below the data, which begin at {low:g} Hz, the model has {_modes(below)}: the spring"
            " to the base follows from what is left of it above"
        )
    return found


def _modes(frequencies: list[float]) -> str:
    """Return modes by their frequencies in words."""
    words = ", ".join(significant(one, 3) for one in frequencies)
    return f"{'a mode' if len(frequencies) == 1 else 'modes'} at {words} Hz"


def _of_parameters(fit: Fit) -> list[str]:
    if fit.chain.kind == "full" and fit.chain.order > UNIQUE:
        return [
            "with a full damping matrix other masses and springs have the same receptance: what was"
            " measured are the modes and the receptance"
        ]
    unsure = []
    for one in fit.parameters:
        soft = one.kind == "stiffness" and one.place == 1
        if one.kind == "damping" or soft:
            continue  # a small damper may well be none; the spring to the base is told apart
        if isinf(one.sure) or one.sure > UNSURE * one.value:
            unsure.append(f"{one.kind} {one.place}")
    found = _at_bounds(fit)
    if unsure:
        found.append(
            f"the data hardly determine {', '.join(unsure)} (counted from the base): other chains"
            " fit nearly as well, and differ outside of the data"
        )
    base = next(one for one in fit.parameters if one.kind == "stiffness")
    if base.sure > base.value:
        found.append(
            f"the spring to the base, {base.value:.3g} ± {base.sure:.2g} N/m, cannot be"
            " distinguished from none: it decides how the force changes with the height of the"
            " wire, and is better measured at rest"
        )
    return found


def _at_bounds(fit: Fit) -> list[str]:
    """Return a remark about masses and joints that the search would have made nothing or rigid."""
    chain = fit.chain
    found = [f"mass {place + 1}" for place in np.flatnonzero(chain.mass < NEAR * LEAST_MASS)]
    stiff = np.flatnonzero(chain.stiffness * NEAR > MOST_STIFFNESS)
    found += [f"stiffness {place + 1}" for place in stiff]
    if chain.kind == "joints":
        found += [f"damping {i + 1}" for i in np.flatnonzero(chain.damping * NEAR > MOST_DAMPING)]
    if not found:
        return []
    return [
        f"{', '.join(found)} ended at the bounds of the search: the data have one mass less, or a"
        " flexibility without a mass of its own"
    ]


def _of_phases(fit: Fit) -> list[str]:
    outside = np.degrees(fit.data.outside)
    if outside.max() < TOLD_DEGREES:
        return []
    return [
        f"{np.count_nonzero(outside)} of {outside.size} phases lie outside of −180° to 0, by"
        f" {outside.max():.1f}° at most: taken for noise"
    ]
