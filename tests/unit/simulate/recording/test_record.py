"""Channels of the core's record and variables of a result: none is lost between them."""

from functools import cache
from typing import Any

import numpy as np

from arcless import _core
from arcless.dataset.schema import VARIABLES
from arcless.simulate.recording import contacts, record
from arcless.simulate.runs.job import Job
from tests.support.small import laid_out, small

# Series that become variables together with others, or labels of dimensions.
COMBINED = {"time", "line_time", "masses", *contacts.REDUCTIONS}
# Motion of the wires, which its layout takes apart: see test_motion.py.
MOTION = {"motion_time", "motion_first"}
# Extremes that attributes and warnings tell of.
TOLD = {"stop_max", "law_ranges"}
ENERGY = "energy_"


@cache
def stepped() -> tuple[Job, dict[str, Any]]:
    job = laid_out(small(**{"output.energy": "always", "output.points": [100.0]}))
    return job, job.step([120.0], full=True, until=20)


def test_every_channel_of_the_core_is_a_variable() -> None:
    _, raw = stepped()
    arrays = {name for name, values in raw.items() if isinstance(values, np.ndarray)}
    named = {variable.channel for variable in VARIABLES.values() if variable.channel}
    assert named | COMBINED | TOLD | MOTION | {"motion"} == arrays
    assert not named & (COMBINED | TOLD)
    of_rows = {variable.channel for variable in record.OF_ROWS.values()}
    assert of_rows | COMBINED | MOTION == set(_core.SERIES)


def test_every_energy_of_the_core_is_a_variable() -> None:
    _, raw = stepped()
    known = [name.removeprefix(ENERGY) for name in VARIABLES if name.startswith(ENERGY)]
    assert list(raw["energy"]) == known


def test_supplied_energies_stand_against_all_others() -> None:
    _, raw = stepped()
    energies = dict(raw["energy"])
    residual = energies.pop("residual")
    signed = [-v if name.startswith("work_") else v for name, v in energies.items()]
    # Sums of the same 15 numbers.
    np.testing.assert_allclose(sum(signed), residual, rtol=0, atol=1e-12)
    assert any(np.any(values != 0.0) for values in signed)


def test_droppers_are_put_in_their_own_order() -> None:
    job, raw = stepped()
    found = record.dynamic_variables(raw, job.found, job.scenario)
    links = [dropper.link for dropper in job.found.mesh.droppers]
    flat = raw["link_force"].reshape(len(raw["line_time"]), -1)
    for row, values in enumerate(found["dropper_force"]):
        assert values.tolist() == [flat[row, link] for link in links]
    assert found["dropper_force_max"].tolist() == [raw["link_max"][link] for link in links]
    assert found["point_uplift"].shape == (len(raw["line_time"]), 1)


def test_a_part_without_a_row_has_no_variables_of_the_line() -> None:
    job, raw = stepped()
    rows = record.OF_ROWS.values()
    of_line = ["line_time", *(v.channel for v in rows if v.dims[0] == "line_time")]
    none: Any = {name: np.zeros(0) for name in of_line}
    found = record.series({**raw, **none, "energy": {}}, job.found, job.scenario)
    assert {"contact_force", "position", "speed"} <= set(found)
    assert not [name for name in found if VARIABLES[name].dims[0] == "line_time"]
