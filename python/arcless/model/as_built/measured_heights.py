"""Heights of the contact wire as measured, and the places of the line they belong to."""

from bisect import bisect_left
from collections.abc import Sequence
from typing import Annotated

from pydantic import Field

from arcless.errors import ModelError
from arcless.model.fields.part import Part, Path, Unit
from arcless.model.line.line import Line

MAX_HEIGHTS = 100_000
# A measured place may lie this far from the dropper or support as drawn: more than any error of a
# measuring car over a span, less than half of the shortest distance between droppers, 0.5 m. In m.
SAME = 0.1
FIELD = ("as_built", "measured_heights")


class MeasuredHeight(Part):
    """The height of the contact wire at a dropper or support."""

    position: Annotated[float, Unit("m", minimum=-1e6, maximum=1e6)] = Field(
        description="Place along the line."
    )
    height: Annotated[float, Unit("m", above=0, maximum=20)] = Field(
        description="Height of the contact wire above rail there."
    )


def measured_places(line: Line) -> dict[float, str]:
    """Return where heights must be measured, in m along the line, and what stands there."""
    supports = line.support_positions()
    found = {x: f"support {number}" for number, x in enumerate(supports, start=1)}
    kind = "dropper" if line.auxiliary_wire is None else "hanger"
    for number, (start, span) in enumerate(zip(supports, line.span_list(), strict=False), start=1):
        for index, x in enumerate(span.holders.positions, start=1):
            found.setdefault(start + x, f"span {number} {kind} {index}")
    return dict(sorted(found.items()))


def matched(line: Line, given: Sequence[MeasuredHeight]) -> dict[float, float]:
    """Return the measured height in m at each place of the line that needs one.

    Raises
    ------
    ModelError
        A height is missing, given twice, or belongs to no place.
    """
    names = measured_places(line)
    places, found = list(names), dict[float, int]()
    for row, one in enumerate(given):
        place = _nearest(places, one.position)
        if abs(place - one.position) > SAME:
            raise _stray(one.position, row, line.total_length, f"{names[place]} at {place:g} m")
        if place in found:
            first = given[found[place]].position
            raise ModelError(
                f"height of {names[place]} measured twice",
                got=f"at {first:g} m and at {one.position:g} m",
                expected="one height for each dropper and support",
                field=(*FIELD, row),
            )
        found[place] = row
    missing = [place for place in places if place not in found]
    if missing:
        more = f", and {len(missing) - 1} more" if missing[1:] else ""
        raise ModelError(
            f"no height measured at {names[missing[0]]}{more}",
            expected=f"a height within {SAME:g} m of {missing[0]:g} m",
            hint="a height is needed at every dropper and every support",
            field=FIELD,
        )
    return {place: given[found[place]].height for place in places}


def _count(given: "Sequence[MeasuredHeight]") -> str:
    return "1 height" if len(given) == 1 else f"{len(given)} heights"


def check_measured(line: Line, given: Sequence[MeasuredHeight]) -> None:
    """Raise `ModelError` for measured heights that do not fit a line."""
    if line.has_overlaps:
        raise ModelError(
            "measured heights of a line with several tension lengths",
            got=_count(given),
            expected="a line with one tension length",
            hint="in an overlap two wires hang at one place; leave tension_lengths out",
            field=FIELD,
        )
    if line.bridle is not None:
        raise ModelError(
            "measured heights of a line with bridles",
            got=_count(given),
            expected="a line whose supports or droppers hold the contact wire itself",
            hint="bridles have no lengths to be found from heights",
            field=FIELD,
        )
    for name, span in line.span_types.items():
        if span.holders.lengths is not None:
            raise ModelError(
                "both dropper lengths and measured heights given",
                got=f"lengths in line.span_types.{name}",
                expected="one of them: each follows from the other",
                field=FIELD,
            )
    matched(line, given)


def _nearest(places: list[float], x: float) -> float:
    index = bisect_left(places, x)
    return min(places[max(index - 1, 0) : index + 1], key=lambda place: abs(place - x))


def _stray(x: float, row: int, length: float, nearest: str) -> ModelError:
    field: Path = (*FIELD, row, "position")
    if not -SAME <= x <= length + SAME:
        expected = f"a position between 0 and {length:g} m, the line's length"
        return ModelError(
            "height measured outside the line", got=f"{x:g} m", expected=expected, field=field
        )
    return ModelError(
        "height measured where there is neither dropper nor support",
        got=f"{x:g} m",
        expected=f"a place within {SAME:g} m of one; the nearest is {nearest}",
        field=field,
    )
