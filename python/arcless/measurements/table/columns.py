"""Header of a CSV file → columns that are known, with the factor of their unit.

`contact_force [N]` is a column of the only pantograph, `P1.contact_force [N]` one of the pantograph
P1, and `time [s]`, without a name before it, belongs to all. Sensors are counted:
`acceleration_1 [m/s2]`, `acceleration_2 [m/s2]`.
"""

import re
from collections.abc import Iterable
from dataclasses import dataclass
from difflib import get_close_matches

from arcless.errors import MeasurementError, ModelError
from arcless.units import accepted, show, spell, to_si

# Known columns → SI unit. Sensors may be several, with a number behind the name.
CHANNELS = {
    "time": "s",
    "position": "m",
    "speed": "m/s",
    "contact_force": "N",
    "contact_height": "m",
    "uplift": "m",
}
SENSORS = {"sensor_force": "N", "acceleration": "m/s2"}
KNOWN = {**CHANNELS, **SENSORS}
# Names that only a column may have, for nothing else is measured in them there: the g of an
# accelerometer is no gram.
_IN_COLUMNS = {("m/s2", "g"): "gn"}
# Units that hints are written in.
_USUAL = {"m/s": "km/h"}
# Likeness of names, from 0 to 1, from which one is taken for a misspelt other: lower, and names of
# other channels are refused; higher, and `contact_froce` is left out with a remark.
ALIKE = 0.8

_HEAD = re.compile(r"(?P<name>.*?)\s*(?:\[(?P<a>[^\[\]]*)\]|\((?P<b>[^()]*)\))?\s*")
_NUMBERED = re.compile(rf"({'|'.join(SENSORS)})(?:_(\d+))?")


@dataclass(frozen=True)
class Column:
    """One known column.

    Attributes
    ----------
    place
        Its number in the file, from 0.
    title
        As the header has it.
    pantograph
        Name of the pantograph; None for a column that belongs to all.
    channel
        A key of `KNOWN`.
    factor
        1 of its unit, in SI.
    """

    place: int
    title: str
    pantograph: str | None
    channel: str
    factor: float


def columns_of(header: Iterable[str], where: str) -> tuple[list[Column], list[str]]:
    """Return known columns, and the titles of those that are not used.

    Parameters
    ----------
    header
        Cells of the header.
    where
        File and line, for messages.

    Raises
    ------
    MeasurementError
        A known column is there twice, or without its unit, or with one of another kind; or a name
        is nearly one of ours.
    """
    found: list[Column] = []
    unused: list[str] = []
    seen: dict[tuple[str | None, str], str] = {}
    for place, title in enumerate(header):
        name, unit = _parts(title)
        pantograph, plain = _named(name)
        key = _key(plain)
        if key is None:
            _refuse_misspelt(plain, title, where)
            unused.append(title)
            continue
        if (pantograph, plain) in seen:
            got = f"{show(seen[pantograph, plain])} and {show(title)}"
            raise MeasurementError("column given twice", where=where, got=got)
        seen[pantograph, plain] = title
        found.append(Column(place, title, pantograph, key, _factor(key, unit, title, where)))
    return found, [title for title in unused if title]


def _parts(title: str) -> tuple[str, str]:
    match = _HEAD.fullmatch(title)
    if match is None:
        return title, ""
    return match["name"].strip(), (match["a"] or match["b"] or "").strip()


def _named(name: str) -> tuple[str | None, str]:
    """Return name of the pantograph, and the rest with underscores for blanks."""
    pantograph, dot, rest = name.rpartition(".")
    plain = re.sub(r"[\s-]+", "_", rest.strip()).lower()
    return (pantograph if dot and pantograph else None), plain


def _key(plain: str) -> str | None:
    if plain in CHANNELS:
        return plain
    numbered = _NUMBERED.fullmatch(plain)
    return numbered[1] if numbered else None


def _refuse_misspelt(plain: str, title: str, where: str) -> None:
    """Refuse a name that is one of ours with its unit but no brackets, or with a slip."""
    first = re.sub(r"[\W_]*$", "", plain)
    for known, unit in KNOWN.items():
        behind = re.fullmatch(rf"(?:.*\.)?{known}[\s_-]+(\S+)", title, re.IGNORECASE)
        if behind and _is_unit(behind[1], unit):
            hint = f"write the unit in brackets, such as {known} [{spell(_usual(unit))}]"
            raise MeasurementError(
                f"column {known}: unit missing", where=where, got=show(title), hint=hint
            )
    without_number = re.sub(r"_?\d+$", "", first)
    close = [] if len(first) > 2 * max(map(len, KNOWN)) else get_close_matches(
        without_number, KNOWN, n=1, cutoff=ALIKE
    )  # fmt: skip
    if close:
        raise MeasurementError(
            "unknown column", where=where, got=show(title), hint=f"did you mean {close[0]}?"
        )


def _is_unit(text: str, kind: str) -> bool:
    try:
        to_si(f"1 {text}", kind)
    except ModelError:
        return False
    return True


def _factor(channel: str, unit: str, title: str, where: str) -> float:
    kind = KNOWN[channel]
    if not unit:
        raise MeasurementError(
            f"column {channel}: unit missing",
            where=where,
            got=show(title),
            expected=accepted(kind),
            hint=f"write it in brackets behind the name, such as {channel} [{_usual(kind)}]",
        )
    try:
        return to_si(f"1 {_IN_COLUMNS.get((kind, unit), unit)}", kind)
    except ModelError as error:
        raise MeasurementError(
            f"column {channel}", where=where, got=show(unit), expected=accepted(kind),
            hint=error.hint,
        ) from None  # fmt: skip


def _usual(kind: str) -> str:
    return _USUAL.get(kind, kind)
