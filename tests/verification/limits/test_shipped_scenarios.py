"""Shipped scenarios as they are shipped

Every shipped scenario, with the scheme, elements and step that it has or gets by default, against
its limit as in Random lines. Left out are those whose subject is another scheme: the published
method with its own elements and updated geometry.
"""

from typing import Any

import pytest

import arcless
from arcless.model.shipped.library import shipped
from tests.support.against_limit import compare
from tests.support.limit_rows import record

# Those of the published method begin with its name.
NAMES = [name for name in shipped("scenario") if not name.startswith("praks")]
ASKED: dict[str, Any] = {}


@pytest.mark.evidence
@pytest.mark.parametrize("name", NAMES)
def test_shipped_scenario(evidence: Any, name: str) -> None:
    record(evidence, name, compare(arcless.load(name), ASKED))
