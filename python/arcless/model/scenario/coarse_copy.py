"""A coarse copy of a run: nearly the same mean forces for a quarter to a third of the price.

A mean force hardly depends on elements and steps: forces do their work on points that yield as
those of the line do, however long the elements are, and no wave carries a mean away. Of the same
static force the means of a run and of its copy, over the same instants, differ by

    explicit steps, elements and step twice as long          0.001 … 0.018 N
    a matrix with residual flexibility, elements 1.5 times,
    step twice as long, schemes that hardly damp             0.001 … 0.014 N

on the shipped lines at their speeds (docs/decisions/0045-search-on-a-coarse-copy.md). What is
missing here differs by more: updated kinematics by 1 N, schemes that damp and elements without
residual flexibility by 0.1 N.
"""

from typing import TYPE_CHECKING

from arcless.model.scenario.stepping import (
    LONGEST_OF_CHAIN,
    LONGEST_OF_CUBIC,
    LONGEST_STEP,
    ROUNDING,
    stable_step,
    too_stiff_along,
)
from arcless.model.settings.run_settings import Output
from arcless.model.settings.schemes import (
    EXPLICIT,
    GeneralisedAlpha,
    HilberHughesTaylor,
    Newmark,
    Scheme,
    Trapezoidal,
)

if TYPE_CHECKING:
    from arcless.model.scenario.scenario import Scenario

# Factors of elements and step, and the longest that were measured, in m and s.
LONGER_CHAIN, LONGER_CUBIC, LONGER_STEP = 2.0, 1.5, 2.0
MOST_OF_CHAIN, MOST_OF_CUBIC = LONGER_CHAIN * LONGEST_OF_CHAIN, LONGER_CUBIC * LONGEST_OF_CUBIC
MOST_STEP = LONGER_STEP * LONGEST_STEP
# Steps per period of the low-pass, at least: the filter needs more than two.
PER_PERIOD = 5.0
# A copy that costs more than this of its run saves too little.
MOST_SHARE = 0.5
# Parameters of schemes that hardly damp: those they have by default, or less.
LEAST_RADIUS, LEAST_ALPHA, UNDAMPED_GAMMA = 0.9, -0.05, 0.5


def coarse(scenario: "Scenario") -> "Scenario | None":
    """Return a coarse copy of a scenario, which records every step; None where none serves.

    Its elements and its step follow from the line and from those of the scenario alone: so
    scenarios that share a line share the line of their copies.
    """
    taken, step = scenario.stepping, scenario.time_step_s
    explicit = taken.scheme.name == EXPLICIT
    if not (explicit or (taken.residual_flexibility is True and _hardly_damps(taken.scheme))):
        return None
    longer, most = (LONGER_CHAIN, MOST_OF_CHAIN) if explicit else (LONGER_CUBIC, MOST_OF_CUBIC)
    own = taken.contact_wire_element_m, taken.messenger_wire_element_m
    lengths = [max(length, min(longer * length, most)) for length in own]
    longest = min(LONGER_STEP * step, MOST_STEP)
    if explicit:
        longest = min(longest, stable_step(scenario, lengths))
    too_dear = own[0] * step > MOST_SHARE * ROUNDING * lengths[0] * longest
    if too_dear or PER_PERIOD * longest * scenario.analysis.low_pass > 1.0:
        return None
    lengthened = {"contact_wire_element": lengths[0], "messenger_wire_element": lengths[1]}
    solver = taken.model_copy(update={**lengthened, "time_step": longest})
    copied = scenario.model_copy(
        update={"solver": solver, "output": Output(), "certainty": None},
    )
    return None if explicit and too_stiff_along(copied, longest) else copied


def _hardly_damps(scheme: Scheme) -> bool:
    match scheme:
        case GeneralisedAlpha():
            return scheme.spectral_radius >= LEAST_RADIUS
        case HilberHughesTaylor():
            return scheme.alpha >= LEAST_ALPHA
        case Newmark():
            return scheme.gamma == UNDAMPED_GAMMA
        case _:
            return isinstance(scheme, Trapezoidal)
