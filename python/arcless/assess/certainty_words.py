"""Certainty of the numbers of a run, in sentences."""

from collections.abc import Mapping
from typing import Any


def explained(method: Mapping[str, Any]) -> list[str]:
    """Return how certainty was found, in sentences for a page or a terminal.

    Parameters
    ----------
    method
        `certainty_method` of an assessment.
    """
    return [
        "What follows ± is the spread over starts and the error of discretisation, added.",
        *_about_starts(method),
        *_about_family(method),
    ]


def _about_starts(method: Mapping[str, Any]) -> list[str]:
    times, places, factor = method["wall_time_s"], method["starts_m"], method["student_factor"]
    if factor is None:
        return ["No run from another start came to its end, so no spread is known."]
    return [
        f"Spread: {factor:.2f} standard deviations of {method['runs']} runs that begin between"
        f" {min(places):.2f} and {max(places):.2f} m, which covers {method['coverage']:.0%}"
        f" (Student); {times['starts']:.1f} s of computing."
    ]


def _about_family(method: Mapping[str, Any]) -> list[str]:
    family, seconds = method["other_family"], method["wall_time_s"]["other_family"]
    if family is None:
        return ["The error of discretisation was not requested."]
    wires = "cubic elements" if family["wire_model"] == "hermite" else "point masses"
    return [
        f"Discretisation: the difference to {wires} of {family['contact_wire_element_m']:.3g} m and"
        f" {family['messenger_wire_element_m']:.3g} m with {family['scheme']} steps of"
        f" {1e3 * family['time_step_s']:.3g} ms; {seconds:.1f} s of computing."
    ]
