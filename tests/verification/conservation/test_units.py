"""Other units of length, mass and time

No equation of the program may know what a metre is. With one metre, kilogram and second written
as λ, μ and τ units, a quantity of dimension m^a kg^b s^c goes in as λ^a μ^b τ^c of it and comes
out so:

    force λ μ τ⁻²,  EA alike,  EI λ³ μ τ⁻²,  wire mass μ λ⁻¹,  stiffness μ τ⁻²,  gravity λ τ⁻²

(dimensional analysis; the columns are listed in `tests/support/scaling.py`). A sum of two terms
that do not belong together, or a constant with a unit, comes out differently. Powers of two are
exact in binary numbers, so the same bits must come out.

All arrays of a line of four spans in space (`tests/support/small.py`: 225 elements, struts,
springs, masses, droppers that go slack) and of a pantograph are scaled, the design is
calculated and the run taken, 1309 steps with the energy balance.

Two places know of units, neither of which touches runs in SI by more than rounding. Newton's
method for the line at rest ends when the largest of all forces in N and couples in N m is
rounding: in other units of length it ends a step earlier or later, and where couples weigh a
thousand times as much it may not see that it is there. And the equilibrium of the pantograph at
the start is a small linear system with springs in N/m beside ones: in which order it is solved,
and so how it rounds, depends on which is larger. The units of mass and time above keep that
order, the decimal ones below do not.
"""

from functools import cache
from typing import Any
from unittest.mock import patch

import numpy as np

from arcless.simulate.runs.job import Job
from tests.support import scaling
from tests.support.faults import Broken, Fault, kept
from tests.support.scaling import Units
from tests.support.small import FORCE, differing, laid_out, small

CASES = {
    "mass": Units(1.0, 2.0**7, 1.0),
    "time": Units(1.0, 1.0, 2.0**-9),
    "mass and time": Units(1.0, 2.0**11, 2.0**-5),
}


@cache
def in_si() -> tuple[Job, dict[str, Any]]:
    job = laid_out(small())
    raw = scaling.run(job, FORCE, Units(1.0, 1.0, 1.0))
    assert raw["slack"].any(), "droppers go slack"
    return job, raw


def test_mass_and_time(evidence: Any) -> None:
    job, raw = in_si()
    for name, units in CASES.items():
        other = scaling.run(job, FORCE, units)
        counts = [differing(raw[key], other[key]) for key in raw]
        evidence.same(
            f"other unit of {name}: forces, places, dropper forces, energies",
            compared=sum(size for size, _ in counts),
            differing=sum(count for _, count in counts),
            reason="powers of two are exact",
        )


def test_length(evidence: Any) -> None:
    job, raw = in_si()
    worst = [
        float(np.max(np.abs(raw["force"] - scaling.run(job, FORCE, units)["force"])))
        for units in (Units(2.0, 1.0, 1.0), Units(8.0, 0.25, 1024.0))
    ]
    evidence.below(
        "other unit of length (1/2 and 1/8 m): largest difference of the contact force",
        max(worst),
        4e-9,
        unit="N",
        reason="Newton's method ends elsewhere within its rounding, 1e-14 m of heights of 5 m,"
        " times 50 kN/m; ten times that",
    )


def test_decimal_units(evidence: Any) -> None:
    job, raw = in_si()
    other = scaling.run(job, FORCE, Units(1.0, 1e-3, 1.0 / 60.0))
    evidence.below(
        "tonnes and minutes: largest difference of the contact force",
        float(np.max(np.abs(raw["force"] - other["force"]))),
        1e-7,
        unit="N",
        reason="every number is rounded anew: heights of 5 m by 2e-13 m after the design, times"
        " 50 kN/m; ten times that",
    )


def counted(kind: str, column: str, powers: scaling.Powers) -> list[Broken]:
    """Take a column of a table for one of another dimension."""
    assert scaling.COLUMNS[kind][column] != powers
    columns = scaling.COLUMNS[kind] | {column: powers}
    return [kept(in_si), patch.dict(scaling.COLUMNS, {kind: columns})]


FAULTS = [
    Fault("EI counted in N m", counted("wires", "bending_stiffness", scaling.ENERGY), test_length),
    Fault("β counted as a number", counted("wires", "beta", scaling.NUMBER), test_mass_and_time),
    Fault("α of the clamps counted as a number", counted("masses", "alpha", scaling.NUMBER),
          test_decimal_units),
]  # fmt: skip
