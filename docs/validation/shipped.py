"""Tables of the page lines: shipped lines against what is published about them."""

from typing import Any

import numpy as np
from validation.runs import run, table

import arcless
from arcless.simulate import StaticsResult, statics

# Line, its scenario, what is known of the elasticity in mm/N (low, high), mark and source.
ELASTICITIES = (
    ("germany-re-200", "germany-re-200-200", (0.9, 1.1), "C", "two values, 0.9 and 1.1"),
    ("norway-s25", "norway-s25-250", (0.55, 0.55), "C", "its relative Re 250, 0.55"),
    ("germany-re-330", "germany-re-330-300", (0.40, 0.40), "C", "0.40, non-uniformity 8 %"),
)
STITCHED = ("norway-s20a", "norway-s25", "norway-s35", "germany-re-200", "germany-re-330",
            "china-stitched-350", "sweden-syt-7.0-9.8")  # fmt: skip
# Adif: uplift at the steady arm with two pantographs at the highest speed, in mm (A, S13).
UPLIFTS = (("spain-ca-200-200", 46.0), ("spain-ca-220-220", 43.0))
# The first is what the TSI asks for at these speeds.
UPLIFT_SPACINGS = (85.0, 100.0, 200.0)


def at_rest(line: str, **changes: Any) -> StaticsResult:
    """The initial configuration of a shipped line, changes by dotted path below ``line``."""
    base = arcless.load("norway-s25-250").with_(line=line)
    return statics(base.with_(**{f"line.{path}": value for path, value in changes.items()}))


def elasticity_table() -> str:
    rows = []
    for line, _, known, mark, words in ELASTICITIES:
        e = 1e3 * np.array(at_rest(line).elasticity_m_per_N)
        inside = f"{e[0]:.2f}", f"{e[len(e) // 2]:.2f}", f"{e.min():.2f}", f"{e.max():.2f}"
        middle = f"{e.mean():.2f}"
        rows.append(
            (line, words, mark, *inside, middle, f"{100 * (e.mean() / np.mean(known) - 1):+.0f}")
        )
    head = (
        "line",
        "known, mm/N",
        "mark",
        "support",
        "mid-span",
        "lowest",
        "highest",
        "mean",
        "mean, %",
    )
    return table(head, rows)


def stitch_table() -> str:
    rows = []
    for line in STITCHED:
        with_, without = at_rest(line), at_rest(line, stitch_wire=None)
        e, plain = (1e3 * np.array(found.elasticity_m_per_N) for found in (with_, without))
        rows.append(
            (
                line,
                f"{e[0]:.2f}",
                f"{plain[0]:.2f}",
                f"{e[len(e) // 2]:.2f}",
                f"{plain[len(plain) // 2]:.2f}",
                f"{100 * with_.elasticity_nonuniformity:.0f}",
                f"{100 * without.elasticity_nonuniformity:.0f}",
            )
        )
    head = ("line", "support", "without", "mid-span", "without", "u %", "without")
    return table(head, rows)


def pair(scenario: str, spacing: float | None) -> float:
    """Highest uplift at a support in mm with one pantograph, or with two so far apart in m."""
    one = arcless.load(scenario).to_dict()["pantographs"][0]
    place = [one] if spacing is None else [one, {**one, "name": "P2", "distance": spacing}]
    result = run(
        scenario, {"pantographs": place, "output": {"line_every": 1000, "droppers": False}}
    )
    uplift = result.assessment.max_uplift_at_support_mm
    assert uplift is not None
    return uplift


def uplift_table() -> str:
    rows = [
        (
            arcless.load(scenario).line.name,
            f"{published:.0f}",
            f"{pair(scenario, None):.0f}",
            *(f"{pair(scenario, spacing):.0f}" for spacing in UPLIFT_SPACINGS),
        )
        for scenario, published in UPLIFTS
    ]
    head = ("line", "published, mm", "one", *(f"two, {s:g} m apart" for s in UPLIFT_SPACINGS))
    return table(head, rows)


TABLES = {"elasticity": elasticity_table, "stitch": stitch_table, "uplift": uplift_table}
