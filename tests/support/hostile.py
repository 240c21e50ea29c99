"""Input that means harm: how plain data, texts and bytes are spoilt, and what must hold then."""

import os
import re
from collections.abc import Callable, Iterator
from copy import deepcopy
from datetime import timedelta
from typing import Any

from hypothesis import HealthCheck, settings
from hypothesis import strategies as st

# `make fuzz` looks longer and at random; tests replay the same examples each time.
FACTOR = int(os.environ.get("ARCLESS_SEARCH", "1"))
# Loading takes milliseconds; what takes this long on a busy machine hangs.
LIMIT = timedelta(seconds=30)


def searching(examples: int) -> settings:
    """Settings of a test that looks for input that breaks something."""
    return settings(
        max_examples=examples * FACTOR,
        deadline=LIMIT,
        derandomize=FACTOR == 1,
        database=None,
        suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
    )


def numbers_in(data: Any) -> Iterator[float]:
    """Every number in plain data."""
    if isinstance(data, dict):
        for value in data.values():
            yield from numbers_in(value)
    elif isinstance(data, list):
        for value in data:
            yield from numbers_in(value)
    elif isinstance(data, (int, float)) and not isinstance(data, bool):
        yield data


def paths(data: Any, above: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """The path of everything in plain data."""
    items = data.items() if isinstance(data, dict) else enumerate(data)
    for key, value in items:
        yield (*above, key)
        if isinstance(value, (dict, list)):
            yield from paths(value, (*above, key))


def at(data: Any, path: tuple[Any, ...]) -> Any:
    for key in path:
        data = data[key]
    return data


NUMBERS: list[Any] = [
    float("nan"), float("inf"), float("-inf"), 0, -0.0, -1, 1e308, -1e308, 5e-324, 1e-300, 1e15,
    10**400, -(10**30), 2**63, True, 0.1 + 0.2,
]  # fmt: skip
TEXTS = [
    "", " ", "0", "nan", ".inf", "1e999 N", "-22 kN", "22 kg", "22", "22 kN 3", "1,5 m", "1 000 m",
    "22 kNm", "１２ N", "5" * 500, "1e-999 m", "0x10 m", "1_0 m", "null", "true", "~", "\0",
    "é\u202e", "../../etc/passwd", "/dev/zero", "a.py:b", "span 3 dropper 1", "span 0 dropper 0",
    "S9", "A", "span 99999999999999999999 dropper 1", "one element", "arcless-line/2", "x" * 3000,
    "1" + "0" * 400 + " m", "\ud800",
]  # fmt: skip
THINGS: list[Any] = [
    None, [], {}, [[]], [None], {"value": None}, {"value": {"value": 1}}, {"value": 1, "x": 2},
    {"mark": "A"}, [1, 2, 3], [0.0] * 300, {"format": "arcless-line/1"}, {1: 2}, {"": ""},
    {"kind": "arm"}, {"name": "hht"}, {"value": "22 kN", "source": "S9"}, b"bytes", (1, 2), {1, 2},
    object, 1j,
]  # fmt: skip
HOSTILE = st.one_of(
    st.sampled_from(NUMBERS),
    st.sampled_from(TEXTS),
    st.sampled_from(THINGS),
    st.floats(),
    st.text(max_size=12),
    st.integers(),
)


def scaled(value: Any, factor: float) -> Any:
    """A number times a factor; of a text with a unit, its number."""
    if isinstance(value, str):
        number, _, unit = value.partition(" ")
        try:
            return f"{float(number) * factor:g} {unit}"
        except ValueError:
            return value[::-1]
    try:
        return value * factor if isinstance(value, (int, float)) else value
    except OverflowError:  # a whole number beyond all floats
        return -value


@st.composite
def spoilt(draw: st.DrawFn, data: Any) -> Any:
    """Plain data in which one to three things are changed."""
    data = deepcopy(data)
    for _ in range(draw(st.integers(1, 3))):
        found = list(paths(data))
        if not found:
            break
        path = draw(st.sampled_from(found))
        place, key = at(data, path[:-1]), path[-1]
        draw(st.sampled_from(WAYS))(draw, data, place, key)
    return data


def _replace(draw: st.DrawFn, data: Any, place: Any, key: Any) -> None:
    place[key] = deepcopy(draw(HOSTILE))


def _scale(draw: st.DrawFn, data: Any, place: Any, key: Any) -> None:
    factor = draw(st.sampled_from([-1, 0, 0.5, 2, 1e-3, 1e3, 1e9, 1e-9, 1e200]))
    place[key] = scaled(place[key], factor)


def _drop(draw: st.DrawFn, data: Any, place: Any, key: Any) -> None:
    del place[key]


def _rename(draw: st.DrawFn, data: Any, place: Any, key: Any) -> None:
    other = draw(st.sampled_from([f"{key}s", str(key)[::-1], "", 7, None, "value", "format"]))
    if isinstance(place, dict):
        place[other] = place.pop(key)
    else:
        place.insert(key, other)


def _move(draw: st.DrawFn, data: Any, place: Any, key: Any) -> None:
    """Put something from elsewhere here."""
    place[key] = deepcopy(at(data, draw(st.sampled_from(list(paths(data))))))


def _repeat(draw: st.DrawFn, data: Any, place: Any, key: Any) -> None:
    if isinstance(place, list):
        place.insert(draw(st.integers(0, len(place))), deepcopy(place[key]))
    elif isinstance(place[key], list):
        place[key] = place[key] * draw(st.sampled_from([0, 2, 50]))


def _wrap(draw: st.DrawFn, data: Any, place: Any, key: Any) -> None:
    wrapped = {"value": place[key], "mark": draw(st.sampled_from(["A", "Z", 3, None]))}
    place[key] = draw(st.sampled_from([wrapped, [place[key]], {"a": place[key]}]))


WAYS: list[Callable[[st.DrawFn, Any, Any, Any], None]] = [
    _replace, _replace, _replace, _scale, _scale, _drop, _rename, _move, _repeat, _wrap,
]  # fmt: skip


PIECES = [
    b":", b"-", b"[", b"]", b"{", b"}", b"&a", b"*a", b"!x ", b"|", b">", b"'", b'"', b"#", b"%",
    b"@", b"`", b",", b"?", b"\t", b"\r", b"\n", b"\n\n---\n", b"...\n", b"\0", b"\xff", b"\xc3",
    b"\xef\xbb\xbf", b"\\ud83d", b'"\\ud83d\\ude00"', b'"\\udc00"', b"<<: *a", b"nan", b".inf",
    b"1e999", b"9" * 400, b"0x7", b"\xe2\x80\xa8", b"\xc2\x85", b"kg", b" kN", b"mm", b"km/h",
    b"  ", b"null", b"~", b"=", b"\x1b[0m",
]  # fmt: skip


TEXT_WAYS = ["put", "cut", "repeat", "flip", "swap", "indent", "end", "number"]
DIGITS = ["0", "-1", "nan", "1e999", "1e-999", "3", "1,5", "", "9" * 50, "1e5"]


@st.composite
def spoilt_text(draw: st.DrawFn, text: bytes) -> bytes:
    """A file in which one to four things are changed, byte by byte or line by line."""
    for _ in range(draw(st.integers(1, 4))):
        way = draw(
            st.sampled_from(["put", "cut", "repeat", "flip", "swap", "indent", "end", "number"])
        )
        start = draw(st.integers(0, len(text)))
        end = min(len(text), start + draw(st.integers(1, 40)))
        lines = text.split(b"\n")
        row, other = (draw(st.integers(0, len(lines) - 1)) for _ in range(2))
        if way == "put":
            text = text[:start] + draw(st.sampled_from(PIECES)) + text[start:]
        elif way == "cut":
            text = text[:start] + text[end:]
        elif way == "repeat":
            text = text[:end] + text[start:end] * draw(st.integers(1, 3)) + text[end:]
        elif way == "flip" and text:
            at_end = min(start, len(text) - 1)
            text = text[:at_end] + bytes([draw(st.integers(0, 255))]) + text[at_end + 1 :]
        elif way == "swap":
            lines[row], lines[other] = lines[other], lines[row]
            text = b"\n".join(lines)
        elif way == "indent":
            lines[row] = draw(st.sampled_from([b" ", b"  ", b"    ", b"\t"])) + lines[row]
            text = b"\n".join(lines)
        elif way == "end":
            text = text[:start]
        elif way == "number":
            text = _other_number(draw, text)
    return text


def _other_number(draw: st.DrawFn, text: bytes) -> bytes:
    found = list(re.finditer(rb"\d+(\.\d+)?", text))
    if not found:
        return text
    number = draw(st.sampled_from(found))
    given = draw(
        st.sampled_from(["0", "-1", "nan", "1e999", "1e-999", "3", "1,5", "", "9" * 50, "1e5"])
    )
    return text[: number.start()] + given.encode() + text[number.end() :]
