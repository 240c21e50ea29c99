"""Rules for the tension lengths of a line."""

from itertools import pairwise

from arcless.errors import ModelError
from arcless.model.fields.rule_errors import missing
from arcless.model.line.line_data import LineData
from arcless.model.line.parts.tension_lengths import Meeting, Overlap, TensionLength, meetings

# With fewer spans both wires would have to be raised where the pantograph changes over.
FEWEST, MOST = 3, 5


def check_tension_lengths(line: LineData) -> None:
    """Raise `ModelError` for the first thing that does not fit."""
    lengths = line.tension_lengths
    if lengths is not None:
        _check_order(lengths, len(line.span_list()))
        for meeting in meetings(lengths):
            _check_meeting(meeting)
        _check_three(lengths)
    _check_overlap(line)


def _check_order(lengths: tuple[TensionLength, ...], spans: int) -> None:
    for index, one in enumerate(lengths):
        field = ("tension_lengths", index)
        if one.to_span > spans:
            raise ModelError(
                "tension length beyond the end of the line",
                got=f"span {one.to_span}",
                expected=f"at most {spans}, the number of spans",
                field=(*field, "to_span"),
            )
        if one.from_span > one.to_span:
            raise ModelError(
                "spans out of order",
                got=f"{one.from_span} to {one.to_span}",
                expected="from_span, then a to_span that is not before it",
                field=(*field, "to_span"),
            )
    for index, (before, behind) in enumerate(pairwise(lengths), start=1):
        if behind.from_span <= before.from_span or behind.to_span <= before.to_span:
            raise ModelError(
                "tension lengths out of order",
                got=f"spans {behind.from_span} to {behind.to_span} after {before.from_span} to"
                f" {before.to_span}",
                expected="each beginning and ending behind the one before it",
                field=("tension_lengths", index),
            )
    _check_covered(lengths, spans)


def _check_covered(lengths: tuple[TensionLength, ...], spans: int) -> None:
    reached = 0
    ends = [(one.from_span, one.to_span, (index, "from_span")) for index, one in enumerate(lengths)]
    for first, last, field in [*ends, (spans + 1, spans, (len(lengths) - 1, "to_span"))]:
        if first > reached + 1:
            gap = f"span {first - 1}" if first == reached + 2 else f"spans {reached + 1}"
            gap += "" if first == reached + 2 else f" to {first - 1}"
            raise ModelError(
                "spans without wires",
                got=f"no tension length over {gap}",
                expected="tension lengths over all spans of the line",
                hint="two that follow each other share 3 to 5 spans, their overlap",
                field=("tension_lengths", *field),
            )
        reached = last


def _check_meeting(meeting: Meeting) -> None:
    count = meeting.last - meeting.first + 1
    if FEWEST <= count <= MOST:
        return
    what = "overlap too long" if count > MOST else "wires that do not meet in an overlap"
    shared = f"{count} spans" if count != 1 else "one span"
    raise ModelError(
        what,
        got=f"{shared} that tension lengths {meeting.before + 1} and {meeting.before + 2} share",
        expected=f"{FEWEST} to {MOST} spans",
        hint="from_span of the one behind is the first span of the overlap, to_span of the one"
        " before it the last, for instance {from_span: 1, to_span: 7} and {from_span: 5, to_span:"
        " 12}",
        field=("tension_lengths", meeting.before + 1, "from_span"),
    )


def _check_three(lengths: tuple[TensionLength, ...]) -> None:
    for index, (first, third) in enumerate(zip(lengths, lengths[2:], strict=False), start=2):
        if third.from_span <= first.to_span:
            raise ModelError(
                "three wires over one span",
                got=f"span {third.from_span}, below tension lengths {index - 1} to {index + 1}",
                expected=f"a from_span behind {first.to_span}, where tension length {index - 1}"
                " ends",
                field=("tension_lengths", index, "from_span"),
            )


def _check_overlap(line: LineData) -> None:
    overlap, found = line.overlap, meetings(line.tension_lengths or ())
    if overlap is None and found:
        raise missing(
            "overlap",
            expected="overlap: how the wires of two tension lengths pass each other",
            hint="for instance overlap: {raise: [500 mm, 60 mm]}",
        )
    if overlap is None:
        return
    if not found:
        raise ModelError(
            "overlap of a line with one tension length",
            expected="tension_lengths with at least two entries, or no overlap",
            field=("overlap",),
        )
    _check_raise(overlap, found)
    _check_sides(overlap, found)
    if not line.holds_stagger and (overlap.apart or overlap.stagger_in is not None):
        raise ModelError(
            "nothing holds the wires apart",
            got=f"{overlap.apart:g} m with a steady arm of kind none",
            expected="separation: 0 m, or a steady arm of kind spring or arm",
            field=("overlap", "separation"),
        )


def _check_raise(overlap: Overlap, found: list[Meeting]) -> None:
    for index, (outer, inner) in enumerate(pairwise(overlap.raise_), start=1):
        if inner > outer:
            raise ModelError(
                "a wire that hangs lower at its anchor than further in",
                got=f"{inner:g} m after {outer:g} m",
                expected="values that do not increase from the anchor inwards",
                hint="the first value is the one next to the anchor",
                field=("overlap", "raise", index),
            )
    raised = sum(value > 0 for value in overlap.raise_)
    for meeting in found:
        supports = len(meeting.supports)
        if 2 * raised > supports:
            raise ModelError(
                "both wires raised at one support",
                got=f"{raised} raised supports of each wire in an overlap of {supports - 1} spans",
                expected=f"at most {supports // 2}, so that one wire is at its height everywhere",
                field=("overlap", "raise"),
            )


def _check_sides(overlap: Overlap, found: list[Meeting]) -> None:
    given = (overlap.stagger_in, overlap.stagger_out)
    if (overlap.stagger_in is None) != (overlap.stagger_out is None):
        absent = "stagger_in" if overlap.stagger_in is None else "stagger_out"
        raise missing("overlap", absent, expected="staggers of both wires, or a separation alone")
    for name, values in zip(("stagger_in", "stagger_out"), given, strict=True):
        for meeting in found:
            if values is not None and len(values) != len(meeting.supports):
                raise ModelError(
                    "wrong number of values",
                    got=f"{len(values)} values",
                    expected=f"{len(meeting.supports)}, one for each support of the overlap from"
                    f" span {meeting.first} to span {meeting.last}",
                    field=("overlap", name),
                )
