"""A study of 64 speeds of AC simple in space: whole lines, statics included, static force given."""

from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory

from arcless.study import Execution, load, run

HEAD = ("workers", "variants/s", "goal")
STUDY = Path(__file__).with_name("speeds.yaml")
# Variants a second with two workers.
GOAL = 7.0


def rows(count: int | None = None) -> Iterator[list[str]]:
    """Compute the study, or so many of its speeds, with one worker and with two."""
    data = load(STUDY).to_dict()
    if count is not None:
        data["variables"]["speed"]["count"] = count
    for workers in (1, 2):
        with TemporaryDirectory() as folder:
            how = Execution(kind="threads", workers=workers)
            rate = run(load(data), Path(folder), executor=how).rate or 0.0
        yield [str(workers), f"{rate:.2f}", f"≥ {GOAL:g}" if workers > 1 else ""]
