"""Run a batch into a folder, as a process that drills stop: `batches FOLDER [SPEEDS | endless]`."""

import sys
from collections.abc import Iterator

import arcless
from arcless.model import Scenario
from tests.drills.conftest import QUICK, SHORT

SPEEDS = tuple(range(100, 160, 5))


def members(*, endless: bool = False) -> Iterator[Scenario]:
    """Return the members: one line and step, many speeds."""
    base = arcless.load(SHORT)
    changes = dict(
        arcless.model.scenario.overrides.parse_override(f"{k}={v}") for k, v in QUICK.items()
    )
    changes["solver.time_step"] = "0.01 ms" if endless else "1 ms"
    return (base.with_(**changes, speed=f"{speed} km/h") for speed in SPEEDS)


if __name__ == "__main__":
    sys.stdout.write("begun\n")
    sys.stdout.flush()
    arcless.batch(members(endless="endless" in sys.argv), folder=sys.argv[1])
