"""Tables of the guides to line types and simple lines: lines at rest, and runs on them."""

from functools import cache
from typing import Any

import numpy as np
from validation.runs import run, table

import arcless
from arcless.simulate import StaticsResult, statics

STITCHED = "norway-s25-250"
PLAIN_STITCHED = {"line.stitch_wire": None}
TROLLEY, RAILS = "trolley-bridles-60", [f"conductor-rail-{number}-120" for number in (1, 2, 3)]
PLAIN_TROLLEY = {"line.bridle": None, "line.steady_arm": {"kind": "none"}}
RAIL_SPEEDS = (80, 100, 120, 140, 160)
STITCH_HEAD = ("", "stitched", "without")
TROLLEY_HEAD = ("", "trolley wire", "on bridles")
RAIL_HEAD = ("", "case 1", "case 2", "case 3")


@cache
def at_rest(name: str) -> StaticsResult:
    return statics(arcless.load(name))


def row(name: str, values: list[Any], digits: int, unit: str = "") -> list[str]:
    return [name, *(f"{value:.{digits}f}{unit}" for value in values)]


def stitched_at_rest() -> str:
    found = at_rest(STITCHED), statics(arcless.load(STITCHED).with_(**PLAIN_STITCHED))
    e = [1e3 * np.array(one.elasticity_m_per_N) for one in found]
    uneven = [1e2 * one.elasticity_nonuniformity for one in found]
    rows = [
        row("elasticity at the support, mm/N", [one[0] for one in e], 2),
        row("elasticity in the middle of the span, mm/N", [one[len(one) // 2] for one in e], 2),
        row("lowest elasticity, mm/N", [one.min() for one in e], 2),
        row("non-uniformity, %", uneven, 0),
    ]
    return table(STITCH_HEAD, rows)


def stitched_in_runs() -> str:
    found = [run(STITCHED, changes).assessment for changes in ({}, PLAIN_STITCHED)]
    forces = [one.pantographs[0] for one in found]
    (mean,) = {f"{one.mean_force_N:.1f}" for one in forces}
    uplift = "highest uplift at a support, mm"
    rows = [
        row(f"σ at 250 km/h and a mean force of {mean} N, N", [f.std_force_N for f in forces], 1),
        row("lowest force after the low-pass, N", [f.min_force_N for f in forces], 0),
        row(uplift, [one.max_uplift_at_support_mm for one in found], 0),
    ]
    return table(STITCH_HEAD, rows)


def trolley_at_rest() -> str:
    found = statics(arcless.load(TROLLEY).with_(**PLAIN_TROLLEY)), at_rest(TROLLEY)
    highest, lowest = ([1e3 * f(one.elasticity_m_per_N) for one in found] for f in (max, min))
    rows = [
        row(
            "sag (maximum less minimum height), mm",
            [1e3 * one.contact_wire_sag_m for one in found],
            0,
        ),
        row("highest elasticity, mm/N", highest, 2),
        row("lowest elasticity, mm/N", lowest, 2),
    ]
    return table(TROLLEY_HEAD, rows)


def trolley_in_runs() -> str:
    found = [run(TROLLEY, changes).assessment for changes in (PLAIN_TROLLEY, {})]
    forces = [one.pantographs[0] for one in found]
    rows = [
        row("σ at 60 km/h and 80 N, N", [force.std_force_N for force in forces], 1),
        row("highest force after the low-pass, N", [force.max_force_N for force in forces], 0),
    ]
    return table(TROLLEY_HEAD, rows)


def rails_at_rest() -> str:
    found = [at_rest(name) for name in RAILS]
    highest, lowest = ([1e6 * f(one.elasticity_m_per_N) for one in found] for f in (max, min))
    rows = [
        row(
            "sag (maximum less minimum height) in the middle span, mm",
            [1e3 * one.contact_wire_sag_m for one in found],
            1,
        ),
        row("highest elasticity, µm/N", highest, 1),
        row("lowest elasticity, µm/N", lowest, 2),
        row("first natural frequency, Hz", [one.natural_frequencies_Hz[0] for one in found], 2),
    ]
    return table(RAIL_HEAD, rows)


def rails_in_runs() -> str:
    rows = []
    for speed in RAIL_SPEEDS:
        found = [run(name, {"speed": f"{speed} km/h"}).assessment for name in RAILS]
        sigmas = [one.pantographs[0].std_force_N for one in found]
        rows.append(row(f"σ at {speed} km/h, N", sigmas, 1))
    return table(RAIL_HEAD, rows)


QUICK = {
    "line-types": {"stitched": stitched_at_rest},
    "simple-lines": {"trolley": trolley_at_rest, "rails": rails_at_rest},
}
SLOW = {
    "line-types": {"stitched-runs": stitched_in_runs},
    "simple-lines": {"trolley-runs": trolley_in_runs, "rails-runs": rails_in_runs},
}
