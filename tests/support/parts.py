"""Runs in parts, and what differs between results."""

from pathlib import Path

import arcless
from arcless.model import Scenario
from arcless.results import Result
from tests.support.small import differing

# Wall times and times of day are no results.
OF_THE_DAY = {"created", "wall_time_s", "setup_time_s", "real_time_factor"}


def in_parts(scenario: Scenario, folder: Path, *stops: str | float) -> Result:
    """Run up to each stop, each time from the file of the part before alone."""
    part = arcless.run(scenario, until=stops[0])
    for until in [*stops[1:], None]:
        assert not part.is_complete
        part.save(folder / "part.nc")
        part = arcless.resume(arcless.open(folder / "part.nc"), until=until)
    assert part.is_complete
    return part


def unlike(one: Result, other: Result) -> tuple[int, int]:
    """Return how many numbers and attributes two results have, and how many differ."""
    a, b = one.dataset, other.dataset
    assert set(a.variables) == set(b.variables)
    assert set(a.attrs) == set(b.attrs)
    numbers = [name for name in a.variables if a[name].dtype != object]
    counts = [differing(a[name].values, b[name].values) for name in numbers]
    kept = [name for name in a.attrs if name not in OF_THE_DAY]
    changed = sum(a.attrs[name] != b.attrs[name] for name in kept)
    return sum(size for size, _ in counts) + len(kept), sum(n for _, n in counts) + changed
