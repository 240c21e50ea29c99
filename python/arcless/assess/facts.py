"""Facts that criteria are judged by: supply, speeds, space, and collector heads, from a result."""

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from arcless.assess.rules import DECIDING, SAME_SPEED_KM_H, Facts, HeadLimit
from arcless.model.line.parts.geometry import ASSUMED_SUPPLY
from arcless.model.pantograph.pantograph import lateral_limit

if TYPE_CHECKING:
    from arcless.dataset.plain_dataset import Dataset

# Above this an uplift is told: more than twice the 120 mm that lines are built for. Assumed.
LARGEST_USUAL_UPLIFT_MM = 250.0


def criteria_facts(facts: Mapping[str, Any], speed: Any, uplift_mm: float | None) -> Facts:
    """Return the facts that the criteria are judged by.

    Parameters
    ----------
    facts
        Metadata of the result.
    speed
        Speed in m/s at the samples in the section.
    uplift_mm
        Highest uplift at a support inside the section.
    """
    scenario = facts["scenario"]
    design = scenario["line"]["design"]
    space, supply = design["uplift_space"], design["supply"]
    return Facts(
        supply=supply or ASSUMED_SUPPLY,
        supply_given=supply is not None,
        speed_km_h=3.6 * float(np.mean(speed)),
        wave_speed_use=_wave_speed_use(float(np.max(speed)), facts),
        uplift_mm=uplift_mm,
        uplift_space_mm=None if space is None else 1e3 * space,
        uplift_limited=design["uplift_limited"],
        heads=_heads(scenario["pantographs"]),
    )


def supply_notes(facts: Facts, field: str = "line.design.supply") -> list[str]:
    """Say that the limits are those of a supply that nobody gave in a field."""
    if facts.supply_given:
        return []
    return [
        f"{field} is not given: the limits that depend on it are those of {facts.supply},"
        " and decide nothing (mark assumed)"
    ]


def speed_notes(facts: Facts) -> list[str]:
    """Say that a speed above a boundary of classes has the limits of those up to it."""
    boundary = facts.class_speed_km_h
    if facts.speed_km_h <= boundary + SAME_SPEED_KM_H:
        return []
    return [
        f"the speed, {facts.speed_km_h:.9g} km/h, is within {facts.speed_known_to_km_h:g} km/h of"
        f" {boundary:g} km/h: the limits are those of speeds up to {boundary:g} km/h"
    ]


def uplift_notes(uplift_mm: float | None) -> list[str]:
    """Say that an uplift is beyond what lines in service have."""
    if uplift_mm is None or uplift_mm <= LARGEST_USUAL_UPLIFT_MM:
        return []
    return [
        f"an uplift of {uplift_mm:.0f} mm at a support is beyond what lines have in service, up to"
        f" {LARGEST_USUAL_UPLIFT_MM:g} mm: check forces, tensions and units"
    ]


def lateral_mm(
    dataset: "Dataset", column: int, inside: NDArray[np.bool_], sway_m: float
) -> float | None:
    """Return the largest distance of the contact wire from the middle of a head, sway included.

    Parameters
    ----------
    dataset
        The result.
    column
        Number of the pantograph, from 0.
    inside
        Samples at which it is inside the section.
    sway_m
        How far the head moves across the track by itself, in m.

    Returns
    -------
    float or None
        In mm, over all contacts of the pantograph; None of a planar run.
    """
    if "contact_lateral" not in dataset:
        return None
    places = [dataset["contact_lateral"].values[inside, column]]
    if "wire_contact_lateral" in dataset:
        name = str(dataset["pantograph"].values[column])
        own = [str(each).startswith(f"{name} strip ") for each in dataset["contact"].values]
        places.append(dataset["wire_contact_lateral"].values[inside][:, own])
    farthest = max(float(np.nanmax(np.abs(each), initial=0.0)) for each in places)
    if farthest == 0.0:  # to the last bit: a wire that moves across the track is never there
        return None
    return 1e3 * (farthest + sway_m)


def _wave_speed_use(speed: float, facts: Mapping[str, Any]) -> float | None:
    """Return speed over wave speed of the wire as computed; None of a rail, which has none.

    Results of earlier versions do not name the wave speed: of a line as designed it follows from
    tension and mass; of one as built, with other tensions, it is not known.
    """
    wave, scenario = facts.get("wave_speed_m_s"), facts["scenario"]
    wire = scenario["line"]["contact_wire"]
    if wave is None and wire["tension"] and not _as_built(scenario):
        wave = math.sqrt(wire["tension"] / wire["mass"])
    return None if wave is None else speed / wave


def _as_built(scenario: Mapping[str, Any]) -> bool:
    from arcless.model.as_built.as_built import AsBuilt

    given = scenario.get("as_built")
    return given is not None and not AsBuilt.model_validate(given).is_empty


def _heads(placements: list[dict[str, Any]]) -> dict[str, HeadLimit]:
    found = {}
    for placement in placements:
        model = placement["model"]
        width, range_ = model.get("head_width"), model.get("lateral_range")
        given = "lateral_range" if range_ is not None else "head_width"
        limit = lateral_limit(range_, width)
        if limit is not None:
            found[placement["name"]] = HeadLimit(1e3 * limit, _mark(model, given))
    return found


def _mark(model: Mapping[str, Any], field: str) -> str:
    """Return the mark of a field of a pantograph; what its author gave without one counts as A."""
    entry = (model.get("provenance") or {}).get(field) or {}
    return entry.get("mark") or DECIDING[0]
