"""A moment of a session as numbered frames, as the page's stream has them.

A frame is u32 channel, u32 first, f64 time in s, then singles, all little-endian.
"""

import struct
from collections.abc import Sequence
from typing import Any

import numpy as np

from arcless.studio.hands_on.session import Floats, Moment, Session

_HEAD = struct.Struct("<IId")
# Values at the start of a frame of a pantograph, before the displacements of its masses.
_OF_PANTOGRAPH = (
    ("position", "m"), ("contact force", "N"), ("height of the wire", "m"), ("added force", "N"),
)  # fmt: skip


def channels(session: Session, wires: int, *, spatial: bool) -> list[dict[str, Any]]:
    """Return what the channels hold: pantographs, then wires up, then wires across."""
    values = [{"name": name, "unit": unit} for name, unit in _OF_PANTOGRAPH]
    found = [
        {"name": f"pantograph.{at}", "unit": "", "about": {"name": name, "values": values}}
        for at, name in enumerate(session.pantographs)
    ]
    for word in ("up", "across") if spatial else ("up",):
        found += [
            {"name": f"wire.{at}.{word}", "unit": "m", "about": {"text": "from rest"}}
            for at in range(wires)
        ]
    return [{"number": number, "type": "f32"} | one for number, one in enumerate(found)]


def packed(moment: Moment) -> list[bytes]:
    """Return the frames of a moment: wires first, pantographs last, so that these complete it."""
    first_wire, count = len(moment.pantographs), len(moment.wires)
    frames = []
    for number, (first, up, across) in enumerate(moment.wires):
        for shift, values in ((0, up), (count, across)):
            if values is not None and len(values):
                channel = first_wire + shift + number
                frames.append(_frame(channel, first, moment.time_s, values))
    for number, row in enumerate(moment.pantographs):
        frames.append(_frame(number, 0, moment.time_s, row))
    return frames


def _frame(channel: int, first: int, time_s: float, values: Floats | Sequence[float]) -> bytes:
    return _HEAD.pack(channel, first, time_s) + np.asarray(values, dtype="<f4").tobytes()
