"""Shipped scenarios as they are shipped

Every shipped scenario, with the scheme, elements and step that it has or gets by default, against
its limit as in Random lines. Left out are those whose subject is another scheme: the published
method with its own elements and updated geometry.
"""

from typing import Any
from unittest.mock import patch

import pytest

import arcless
from arcless.model.shipped.library import shipped
from tests.support.against_limit import compare
from tests.support.faults import Fault
from tests.support.limit_rows import record

# Those of the published method begin with its name.
NAMES = [name for name in shipped("scenario") if not name.startswith("praks")]
ASKED: dict[str, Any] = {}


@pytest.mark.evidence
@pytest.mark.parametrize("name", NAMES)
def test_shipped_scenario(evidence: Any, name: str) -> None:
    record(evidence, name, compare(arcless.load(name), ASKED))


LONG: dict[str, tuple[str, dict[str, Any]]] = {
    "elements of a conductor rail of 4 m": (
        "conductor-rail-1-120",
        {"solver.contact_wire_element": 4.0},
    ),
    "messenger wire in links of 1.5 m": (
        "en50318-ac-simple-320-planar",
        {"solver.scheme": "central-difference", "solver.messenger_wire_element": 1.5},
    ),
}
FAULTS = [
    Fault(what, patch.multiple(__name__, ASKED=asked), test_shipped_scenario, name=name, slow=True)
    for what, (name, asked) in LONG.items()
]  # fmt: skip
