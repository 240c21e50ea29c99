"""Certainty of the numbers of a run, in sentences."""

from collections.abc import Mapping
from typing import Any


def explained(method: Mapping[str, Any], *, with_times: bool = True) -> list[str]:
    """Return how certainty was found, in sentences for a page or a terminal.

    Parameters
    ----------
    method
        `certainty_method` of an assessment.
    with_times
        Whether the times of computing are stated, which differ from machine to machine.
    """
    return [
        "What follows ± is the spread over starts and the error of discretisation, added.",
        "In the criteria, ± is that of the difference between value and limit, because a limit such"
        " as 0.3 F_m differs from run to run as well.",
        *_about_starts(method, with_times=with_times),
        *_about_family(method, with_times=with_times),
    ]


def _about_starts(method: Mapping[str, Any], *, with_times: bool) -> list[str]:
    times, places, factor = method["wall_time_s"], method["starts_m"], method["student_factor"]
    if factor is None:
        return ["No run from another start came to its end, so no spread is known."]
    return [
        f"Spread: {factor:.2f} standard deviations of {method['runs']} runs that begin between"
        f" {min(places):.2f} and {max(places):.2f} m, which covers {method['coverage']:.0%}"
        f" (Student){_took(times['starts'], with_times)}."
    ]


def _about_family(method: Mapping[str, Any], *, with_times: bool) -> list[str]:
    family, seconds = method["other_family"], method["wall_time_s"]["other_family"]
    if family is None:
        return ["The error of discretisation was not requested."]
    wires = "cubic elements" if family["wire_model"] == "hermite" else "point masses"
    return [
        f"Discretisation: the difference to {wires} of {family['contact_wire_element_m']:.3g} m and"
        f" {family['messenger_wire_element_m']:.3g} m with {family['scheme']} steps of"
        f" {1e3 * family['time_step_s']:.3g} ms{_took(seconds, with_times)}."
    ]


def _took(seconds: float, is_told: bool) -> str:
    return f"; {seconds:.1f} s of computing" if is_told else ""
