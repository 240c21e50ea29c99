"""Names of droppers: ``span 3 dropper 2``, and more words where that fits several."""

import re
from collections.abc import Mapping
from typing import NamedTuple

from arcless.errors import ModelError
from arcless.model.line.line import Line
from arcless.units import show

_NAME = re.compile(
    r"\s*(?:tension\s+length\s+(\d{1,6})\s+)?span\s+(\d{1,6})\s+dropper\s+(\d{1,6})"
    r"(?:\s+wire\s+([12]))?\s*"
)


class DropperName(NamedTuple):
    """A dropper by its numbers, all from 1.

    The tension length is None where there is but one or it is not said, and so is the contact wire
    of a pair.
    """

    span: int
    dropper: int
    tension_length: int | None = None
    wire: int | None = None

    def __str__(self) -> str:
        """Return the name as it stands in results."""
        length, wire = self.tension_length, self.wire
        front = "" if length is None else f"tension length {length} "
        behind = "" if wire is None else f" wire {wire}"
        return f"{front}span {self.span} dropper {self.dropper}{behind}"


def parse_name(value: object) -> DropperName:
    """Return what a text or a mapping names: ``span 3 dropper 2`` or {span: 3, dropper: 2}."""
    if isinstance(value, Mapping) and {"span", "dropper"} <= set(value) <= set(DropperName._fields):
        value = str(DropperName(**value))
    found = _NAME.fullmatch(value) if isinstance(value, str) else None
    if found is None:
        raise ModelError(
            "not a dropper",
            got=show(value),
            expected=f'a name such as "{DropperName(3, 2)}", or {{span: 3, dropper: 2}}',
        )
    length, span, dropper, wire = (None if part is None else int(part) for part in found.groups())
    assert span is not None
    assert dropper is not None
    return DropperName(span, dropper, length, wire)


def droppers_called(line: Line, name: DropperName) -> list[DropperName]:
    """Return the droppers of a line that a name fits, each with its full name."""
    spans, lengths = line.span_list(), line.tension_length_list()
    if not 1 <= name.span <= len(spans):
        return []
    if not 1 <= name.dropper <= len(spans[name.span - 1].droppers.positions):
        return []
    over = [
        number if len(lengths) > 1 else None
        for number, one in enumerate(lengths, start=1)
        if one.from_span <= name.span <= one.to_span
    ]
    wires = (1, 2) if line.has_paired_droppers else (None,)
    return [
        DropperName(name.span, name.dropper, length, wire)
        for length in over
        for wire in wires
        if name.tension_length in {None, length} and name.wire in {None, wire}
    ]
