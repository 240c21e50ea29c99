"""Remarks about a fitted receptance: what a user should know before such a model is run."""

from math import isinf

import numpy as np

from arcless.pantograph.receptance.fit import Fit
from arcless.pantograph.receptance.measured import listed

# Misfits below are none that a test bench would notice, whatever their pattern.
NEGLIGIBLE = 1e-3
# Standard deviations of the correlation of neighbouring misfits beyond which it is no chance.
NO_CHANCE = 4.0
# Contact forces are assessed up to here (low-pass of EN 50317).
ASSESSED_HZ = 20.0
# ± over value from which a mass or a spring is said to be uncertain.
UNSURE = 0.2
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
            f"a mode at {listed(np.array(beyond))} lies above the data, which end at {high:g} Hz:"
            " only its flexibility below was measured"
        )
    below = [one.frequency_Hz for one in fit.modes if 0.0 < one.frequency_Hz < low]
    if below:
        found.append(
            f"a mode at {listed(np.array(below))} lies below the data, which begin at {low:g} Hz:"
            " the spring to the base follows from its tail"
        )
    return found


def _of_parameters(fit: Fit) -> list[str]:
    if fit.chain.kind == "full" and fit.chain.order > 2:
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
    found = []
    if unsure:
        found.append(
            f"the data hardly determine {', '.join(unsure)} (counted from the base): other chains"
            " fit nearly as well, and differ outside of the data"
        )
    base = next(one for one in fit.parameters if one.kind == "stiffness")
    if base.sure > base.value:
        found.append(
            f"the spring to the base, {base.value:.3g} ± {base.sure:.2g} N/m, cannot be told from"
            " none: it decides how the force changes with the height of the wire, and is better"
            " measured at rest"
        )
    return found


def _of_phases(fit: Fit) -> list[str]:
    outside = fit.data.outside
    bad = outside > 0.0
    if not np.any(bad):
        return []
    return [
        f"{int(bad.sum())} of {bad.size} phases lie outside of −180° to 0, by"
        f" {np.degrees(outside.max()):.1f}° at most: taken for noise"
    ]
