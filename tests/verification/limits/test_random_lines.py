"""Random lines as they are computed by default

What a stranger writes must be computed as well as what is shipped. Each seed is a valid scenario:
simple, stitched and compound lines, twin contact wires with paired and single droppers, overlaps,
trolley wires on bridles and conductor rails, planar and in space, straight and in curves, below one
to three pantographs, at 35 to 70 % of the wave speed (`tests/support/random_lines.py` draws them
around shipped lines, within the bands in which a published form does not warn). Nothing is said of
the solver, so the scheme, its elements and its step are those that a file without `solver` gets.

The limit: cubic elements of 0.36 m and 0.72 m with residual flexibility, generalised-α of 0.5 ms,
and chains of point masses every 0.15 m, explicit steps of 0.25 ms, both finer where they do not
agree. They share no error of discretisation: what one misses under point forces the other has too
much of, waves run too fast in one and too slowly in the other, and one damps what the other keeps.
Where they agree within half a percent, their mean is the limit. Static forces are found once.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any
from unittest.mock import patch

import pytest

from tests.support.against_limit import compare
from tests.support.faults import Fault
from tests.support.limit_rows import record
from tests.support.random_lines import label_of, scenario_of

SEEDS = range(40)
# Changes by dotted path to what is asked for; partners put faults here.
ASKED: dict[str, Any] = {}


@pytest.mark.evidence
@pytest.mark.parametrize("seed", SEEDS)
def test_random_line(evidence: Any, seed: int) -> None:
    record(evidence, f"seed {seed}, {label_of(seed)}", compare(scenario_of(seed), ASKED))


CUBIC = {
    "solver.scheme": "generalised-alpha",
    "solver.residual_flexibility": False,
    "solver.contact_wire_element": 1.45,
    "solver.messenger_wire_element": 2.9,
}
CHAINS = {
    "solver.scheme": "central-difference",
    "solver.contact_wire_element": 0.9,
    "solver.messenger_wire_element": 1.2,
}


@contextmanager
def heavier(seed: int) -> Iterator[None]:
    """Ask for a contact wire that is 2 % heavier."""
    mass = scenario_of(seed).line.contact_wire.mass
    with patch.multiple(__name__, ASKED={"line.contact_wire.mass": 1.02 * mass}):
        yield


FAULTS = [
    Fault("cubic elements of 1.45 m and 2.9 m that miss point forces",
          patch.multiple(__name__, ASKED=CUBIC), test_random_line, seed=0, slow=True),
    Fault("point masses every 0.9 m and 1.2 m", patch.multiple(__name__, ASKED=CHAINS),
          test_random_line, seed=2, slow=True),
    Fault("contact wire 2 % heavier", heavier(4), test_random_line, seed=4, slow=True),
]  # fmt: skip
