"""Lines of several tension lengths and of twin contact wires, short and with round numbers."""

from typing import Any

from tests.support.line_types import stitched_data

RAISES = {3: [0.5, 0.06], 4: [0.5, 0.06], 5: [0.9, 0.5, 0.06]}


def plain_data(spans: int, **changes: Any) -> dict[str, Any]:
    """Return equal spans of 60 m in one tension length; changes by path, dots written ``__``."""
    whole = {"stitch_wire": None, "spans": [{"type": "span", "count": spans}]}
    return stitched_data(**{**whole, **changes})


def overlap_data(
    shared: int = 3, *, ends: tuple[int, ...] = (7,), spans: int = 11, **changes: Any
) -> dict[str, Any]:
    """Return a line whose tension lengths end with the given spans and share some with the next."""
    firsts = [1, *(end - shared + 1 for end in ends)]
    lengths = [
        {"from_span": first, "to_span": last}
        for first, last in zip(firsts, (*ends, spans), strict=True)
    ]
    return plain_data(
        spans,
        **{
            "name": "overlaps",
            "tension_lengths": lengths,
            "overlap__raise": RAISES[shared],
            **changes,
        },
    )
