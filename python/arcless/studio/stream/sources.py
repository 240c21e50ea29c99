"""Motion by what a page names: a run below the folder, or a job."""

from collections.abc import Callable
from typing import Any

from arcless.studio.answers.answers import Refused
from arcless.studio.motion.channels import MotionSource, moves_wires

# A source as a page names it, `{"run": PATH}` or `{"job": ID}`, in a form that can be a key.
Name = tuple[str, str]
# Opens motion; it waits for that of a job that has not begun.
Opener = Callable[[Name], Any]


def name_of(asked: Any) -> Name:
    """Return the name of a source.

    Raises
    ------
    Refused
        It is none.
    """
    if isinstance(asked, dict) and len(asked) == 1:
        [(kind, what)] = asked.items()
        if kind in ("run", "job") and isinstance(what, str):
            return kind, what
    raise Refused(400, "a source is the path of a run or the name of a job")


def announced(source: MotionSource, numbers: range, *, again: bool) -> dict[str, Any]:
    """Return what a page is told when a source is opened, or has begun again: `again`."""
    return {
        "channels": [
            channel.announced(number)
            for number, channel in zip(numbers, source.channels, strict=True)
        ],
        "start_s": source.start_s,
        "end_s": source.end_s,
        "estimated_end_s": source.estimated_end_s,
        "final": source.final,
        "again": again,
        "search": source.search,
        "every_s": source.every_s,
        "wires": moves_wires(source),
    }
