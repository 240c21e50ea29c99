"""Warnings about a scenario or a line: allowed values that deserve a word to the user."""

from collections.abc import Sequence
from itertools import pairwise
from math import atan, hypot, log1p, pi

from arcless.model.advice.gradients import gradient_warnings
from arcless.model.advice.lateral_deviation import deviation_warnings
from arcless.model.advice.plausibility import line_plausibility, pantograph_plausibility
from arcless.model.advice.speeds import speed_warnings
from arcless.model.advice.wire_ends import end_notices
from arcless.model.line.line import Line
from arcless.model.line.parts.geometry import ASSUMED_SUPPLY
from arcless.model.scenario.scenario import Scenario
from arcless.model.scenario.scenario_data import Analysis
from arcless.model.settings.run_settings import ONE_ELEMENT

# Updated kinematics of lumped wires, PRAKS line at 340 km/h, 1 ms, no mass at the joints: runs with
# a spectral radius of 0.95 and more grow without bound, with 0.9 and less they do not. The members
# of the other families that damp the highest frequencies as much.
STEADY_RADIUS, STEADY_ALPHA, STEADY_GAMMA = 0.9, -0.05, 0.55
# Rigid contact in the AC-simple case at 1 ms: share of open steps 6 % with a spectral radius of 0,
# 12 % with 0.2, 32 % with 0.4, 78 % with 0.9; 0.5 % with Newmark's gamma = 1 (first order).
QUIET_RADIUS = 0.1
QUIET_GAMMA = 0.9
# Backward differences have the spectral radius 0 at infinite frequency.
QUIET_SCHEMES = {"backward-difference"}
# The shipped lines damp their waves by 0.1 to 1.9 % of critical, below 20 Hz: a scheme that adds
# more than that makes another line of them.
LOUD_DAMPING = 0.02
# Elements that are longer than those of the rule by this share are told.
LONG_ELEMENT = 1.25
# Whole spans of a section that nobody chose, below which its σ depends on which spans they are.
# Larger, a line of 8 spans, of which 4 are taken, is warned of; smaller, σ of two or three spans is
# taken for that of the line.
FEW_SPANS = 4
# In m: below any span, above what sums of their lengths are off.
ROUNDING = 1e-6
# A tenth of the static forces of pantographs, 60 to 120 N.
LOST_FORCE = 10.0
# Half of what a point of a chain yields less than the wire, 0.8 µm/N: what is stiffer does not get
# its residual flexibility in full (docs/theory/wires.md). In N/m.
STIFFEST_ARM = 1e6


def scenario_warnings(scenario: Scenario) -> list[str]:
    """Return one sentence for each thing that runs but is probably not meant.

    Parameters
    ----------
    scenario : Scenario
        A validated scenario.

    Returns
    -------
    list of str
        Empty when there is nothing to say.
    """
    return [
        *speed_warnings(scenario),
        *_about_section(scenario),
        *_about_line(scenario),
        *_about_track(scenario),
        *pantograph_plausibility(scenario),
        *_about_contact(scenario),
        *_about_scheme(scenario),
        *_about_solver(scenario),
    ]


def _about_section(scenario: Scenario) -> list[str]:
    supports = scenario.line.support_positions()
    (first, last), (start, end) = scenario.analysis_range(), scenario.travel_range()
    end -= scenario.pantographs[-1].distance
    found = []
    analysis = scenario.analysis
    if analysis.spans is None and scenario.default_section() is None:
        found.append("analysis: the line is too short for inner spans; all of the travel is taken")
    elif not _is_chosen(analysis) and (few := _whole_spans(supports, first, last)) < FEW_SPANS:
        found.append(
            f"analysis: {first:g} to {last:g} m is judged, {few} whole"
            f" span{'s' * (few != 1)} of {len(supports) - 1}:"
            " the inner half, never the first or last two spans, cut to what every pantograph"
            " travels; give the line more spans, or the section as analysis.spans"
        )
    elif first < supports[min(2, len(supports) - 1)] or last > supports[max(-3, -len(supports))]:
        found.append(
            "analysis: the section reaches into the first or last two spans of the line, where its"
            " ends and the start of the run disturb the forces"
        )
    if first < start or last > end:
        found.append(
            f"analysis: the section {first:g} to {last:g} m is not travelled in full by every"
            f" pantograph; all of them travel {start:g} to {end:g} m"
        )
    if scenario.speed_profile is not None:
        times, speeds = scenario.speed_profile.time, scenario.speed_profile.speed
        way = sum(
            (later - earlier) * (left + right) / 2
            for (earlier, later), (left, right) in zip(
                pairwise(times), pairwise(speeds), strict=True
            )
        )
        if start + way < last:
            found.append(
                f"speed_profile: it ends at {start + way:.4g} m, before the first pantograph has"
                f" left the section at {last:g} m; give it more time, or the section an earlier end"
            )
    return found


def _is_chosen(analysis: Analysis) -> bool:
    return not (analysis.spans is None and analysis.from_ is None and analysis.to is None)


def _whole_spans(supports: Sequence[float], first: float, last: float) -> int:
    """Return how many spans lie within a section in m whole, to a rounding error."""
    begin, end = first - ROUNDING, last + ROUNDING
    return sum(left >= begin and right <= end for left, right in pairwise(supports))


def _about_line(scenario: Scenario) -> list[str]:
    return _line_warnings(scenario.line)


def line_warnings(line: Line) -> list[str]:
    """Return one sentence for each thing about a line that is allowed but deserves a word."""
    return [*_line_warnings(line), *deviation_warnings(line)]


def _line_warnings(line: Line) -> list[str]:
    found = [*line_plausibility(line), *end_notices(line)]
    if line.design.supply is None:
        found.append(
            f"line.design.supply: not given; the limits of force are shown for {ASSUMED_SUPPLY} and"
            " decide nothing"
        )
    if line.steady_arm.kind == "arm" and not any(line.geometry.stagger_contact_wire):
        found.append(
            "line.geometry.stagger_contact_wire: without stagger the steady arms carry nothing"
        )
    arm = line.steady_arm
    if arm.kind == "spring" and arm.vertical_stiffness > STIFFEST_ARM:
        found.append(
            f"line.steady_arm.vertical_stiffness: {arm.vertical_stiffness:g} N/m holds the"
            " contact wire as a mast would (real arms: 0.1 to 3 kN/m); forces hold, uplift there is"
            " not resolved below 0.2 mm"
        )
    return found


def _about_track(scenario: Scenario) -> list[str]:
    line, found = scenario.line, deviation_warnings(scenario.line, scenario.pantographs)
    if not line.geometry.height_changes:
        return found
    found += gradient_warnings(line, scenario.top_speed)
    start = line.geometry.contact_wire_height
    largest = max((abs(height - start) for height in line.contact_wire_heights()), default=0.0)
    for index, placement in enumerate(scenario.pantographs):
        masses = placement.model.masses
        lost = largest * ((masses[0].stiffness or 0.0) if masses else 0.0)
        if lost > LOST_FORCE:
            found.append(
                f"pantographs.{index}.model.masses.0.stiffness: the base spring of {placement.name}"
                f" changes its force by {lost:.0f} N over a change of height of {largest:.3g} m; a"
                " lifting device keeps it: give this stiffness as 0"
            )
    return found


def _about_contact(scenario: Scenario) -> list[str]:
    scheme = scenario.stepping.scheme
    quiet = (
        (scheme.name == "generalised-alpha" and scheme.spectral_radius <= QUIET_RADIUS)
        or (scheme.name == "newmark" and scheme.gamma >= QUIET_GAMMA)
        or scheme.name in QUIET_SCHEMES
    )
    if scenario.contact.law == "rigid" and not quiet:
        return [
            f"contact.law: rigid contact rings at the step frequency with the scheme {scheme.name};"
            " unfiltered force and loss of contact mean nothing then; take spectral_radius 0,"
            " backward differences, or a compliant contact"
        ]
    return []


def backward_difference_damping(angle: float) -> float:
    """Return the share of critical damping that backward differences add to an oscillation.

    Parameters
    ----------
    angle : float
        ωh, circular frequency times time step, above 0.

    Notes
    -----
    The undamped oscillator, ((1 − 1/z)/h)² + ω² = 0, has the roots z = (1 ± iωh)/(1 + ω²h²): in a
    step the amplitude shrinks by |z| = (1 + ω²h²)^(−½) and the phase turns by arctan ωh. A damped
    oscillation does the same when ζ/√(1 − ζ²) = −ln|z| / arg z; for small ωh, ζ ≈ ωh/2.
    """
    decay, turn = log1p(angle * angle) / 2, atan(angle)
    return decay / hypot(decay, turn)


def _about_scheme(scenario: Scenario) -> list[str]:
    return [*_about_growth(scenario), *_about_numerical_damping(scenario)]


def _about_growth(scenario: Scenario) -> list[str]:
    solver = scenario.stepping
    scheme = solver.scheme
    lively = (
        (scheme.name == "generalised-alpha" and scheme.spectral_radius > STEADY_RADIUS)
        or (scheme.name == "hht" and scheme.alpha > STEADY_ALPHA)
        or (scheme.name == "newmark" and scheme.gamma < STEADY_GAMMA)
        or scheme.name == "trapezoidal"
    )
    if solver.kinematics == "linearised" or solver.wires == "hermite" or not lively:
        return []
    return [
        "solver.scheme: with updated kinematics each step is linear about its start, and the finest"
        f" motions of lumped wires can grow with {scheme.name} as given; take a spectral_radius of"
        f" at most {STEADY_RADIUS:g}, or compare with linearised kinematics"
    ]


def _about_numerical_damping(scenario: Scenario) -> list[str]:
    if scenario.stepping.scheme.name != "backward-difference":
        return []
    frequency, step = scenario.analysis.low_pass, scenario.time_step_s
    damping = backward_difference_damping(2 * pi * frequency * step)
    if damping <= LOUD_DAMPING:
        return []
    return [
        f"solver.scheme: backward differences with a step of {1e3 * step:.3g} ms damp {frequency:g}"
        f" Hz by {damping:.1%} of critical and may hide gaps; compare with a shorter"
        " solver.time_step or the scheme generalised-alpha"
    ]


def _lacks_residual_flexibility(scenario: Scenario) -> bool:
    """Return whether cubic elements that could have residual flexibility are run without it.

    The numbers of the warning are those of docs/validation/in-space.md.
    """
    solver = scenario.stepping
    could = solver.wires == "hermite" and solver.kinematics == "linearised"
    return could and solver.residual_flexibility is False and len(scenario.pantographs) > 1


def _about_solver(scenario: Scenario) -> list[str]:
    solver, found = scenario.stepping, []
    way = scenario.top_speed * scenario.time_step_s
    if solver.time_step != ONE_ELEMENT and way > solver.contact_wire_element_m / 2:
        found.append(
            f"solver.time_step: the pantograph moves {way:.2g} m in a step, more than half an"
            f" element of the contact wire ({solver.contact_wire_element_m:g} m)"
        )
    choice = scenario.choice
    if _lacks_residual_flexibility(scenario):
        found.append(
            "solver.residual_flexibility: without it σ of a trailing pantograph is too low, by 10 %"
            " with cubic elements of 0.72 m and by 3 % with 0.36 m on the line AC simple; leave it"
            " out, and it is chosen"
        )
    if solver.kinematics == "updated":
        return found  # the published method, with the elements that it was published with
    elements = [("contact_wire_element", solver.contact_wire_element_m, choice.contact_wire)]
    if scenario.line.messenger_wire is not None:
        of_messenger = solver.messenger_wire_element_m, choice.messenger_wire
        elements.append(("messenger_wire_element", *of_messenger))
    found += [
        f"solver.{name}: {element:g} m is more than the {rule:g} m that forces within 1 % need with"
        f" {'point masses' if solver.wires == 'lumped' else 'cubic elements'} at this speed; leave"
        " it out, and it is chosen"
        for name, element, rule in elements
        if element > LONG_ELEMENT * rule
    ]
    return found
