"""Two pantographs below each shipped line, at the spacing of its speed and at 100 m."""

from functools import cache
from typing import Any, Final

import arcless
from arcless.model.scenario.scenario import Scenario
from arcless.model.shipped.library import shipped
from tests.support.random_trains import spacing

USUAL: Final = 100.0
# A scenario with pantograph, speed and force for lines that no scenario runs below; of lines with
# several, the first by name is taken.
BORROWED = {"norway-s35": "norway-s20a-200", "sweden-syt-7.0-9.8": "norway-s20a-200"}
# The published method and its line have a subject of their own.
LEFT_OUT = {"praks"}


LINES = [line for line in shipped("line") if line not in LEFT_OUT]
OWN, EQUAL = "at the spacing of its speed", "100 m apart"


@cache
def _scenarios() -> dict[str, str]:
    found = dict(BORROWED)
    for name in shipped("scenario"):
        found.setdefault(arcless.load(name).line.name, name)
    return found


def pair_below(line: str, where: str) -> Scenario:
    """Return a line with two pantographs; the solver is left to the default."""
    own = arcless.load(_scenarios()[line])
    apart = spacing(own.top_speed) if where == OWN else USUAL
    one = own.pantographs[0].model_dump(by_alias=True, exclude_none=True)
    two = {**one, "name": "P2", "distance": apart}
    length = arcless.load_line(line)
    changes: dict[str, Any] = {
        "line": line,
        "pantographs": [{**one, "name": "P1", "distance": 0.0}, two],
        "solver": {},
        "output": {},
        "analysis": {},
        "travel": {},
    }
    if length.has_overlaps:  # the overlap is what is assessed
        first, last = length.tension_lengths[1].from_span, length.tension_lengths[0].to_span  # type: ignore[index]
        changes["analysis"] = {"spans": [first, last]}
    return own.with_(**changes)
