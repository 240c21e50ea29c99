"""Rules for masses and inserts: each lies on a wire of the line."""

from arcless.errors import ModelError
from arcless.model.line.line_data import POSITION_TOLERANCE, LineData
from arcless.model.line.parts.masses_and_inserts import Insert, LumpedMass

# Wires that masses and inserts may be on.
PLACES = ("contact_wire", "messenger_wire", "auxiliary_wire")


def check_on_wires(line: LineData) -> None:
    """Raise `ModelError` for the first thing that does not fit."""
    for index, mass in enumerate(line.point_masses):
        _check_place(line, mass, (mass.position, mass.position), ("point_masses", index))
    for index, insert in enumerate(line.inserts):
        _check_place(line, insert, insert.ends, ("inserts", index))
    _check_apart(line)


def _check_place(
    line: LineData,
    part: LumpedMass | Insert,
    ends: tuple[float, float],
    field: tuple[str | int, ...],
) -> None:
    what = part.name or ("insert" if field[0] == "inserts" else "mass")
    if getattr(line, part.wire) is None:
        raise ModelError(
            f"{what} on a wire that the line does not have",
            got=part.wire,
            expected=f"one of: {', '.join(_wires(line))}",
            field=(*field, "wire"),
        )
    covered = line.tension_lengths_over(*ends)
    if not covered:
        got = f"{ends[0]:g} m" if ends[0] == ends[1] else f"{ends[0]:g} m to {ends[1]:g} m"
        raise ModelError(
            f"{what} outside the wires",
            got=got,
            expected=f"a place on one wire between 0 and {line.total_length:g} m",
            field=(*field, "position"),
        )
    if part.tension_length is None and len(covered) > 1:
        raise ModelError(
            f"{what} where two wires hang side by side",
            got=f"{part.position:g} m",
            expected=f"tension_length: {' or '.join(str(number) for number in covered)}",
            field=(*field, "position"),
        )
    if part.tension_length is not None and part.tension_length not in covered:
        raise ModelError(
            f"{what} outside its tension length",
            got=f"tension length {part.tension_length} at {part.position:g} m",
            expected=f"tension_length: {' or '.join(str(number) for number in covered)}",
            field=(*field, "tension_length"),
        )


def _wires(line: LineData) -> list[str]:
    return [name for name in PLACES if getattr(line, name) is not None]


def _check_apart(line: LineData) -> None:
    """Refuse inserts that overlap on one wire."""
    known: list[tuple[tuple[str, int], float, float, int]] = []
    for index, insert in enumerate(line.inserts):
        own = insert.wire, line.tension_length_of(insert, *insert.ends)
        first, last = insert.ends
        for wire, start, end, other in known:
            if (
                wire == own
                and first < end - POSITION_TOLERANCE
                and start < last - POSITION_TOLERANCE
            ):
                raise ModelError(
                    "inserts overlap",
                    got=f"{first:g} m to {last:g} m, and inserts.{other} {start:g} m to {end:g} m",
                    expected="inserts one behind the other",
                    field=("inserts", index, "position"),
                )
        known.append((own, first, last, index))
