"""Part of a record that is left out, and why."""

import math
from dataclasses import dataclass
from typing import Any

GAP = "gap"
EMPTY = "empty cell"
CODE = "code for no value"
DUPLICATE = "duplicate"
CLIPPED = "clipped"
FROZEN = "frozen"
JUMP = "jump of position"
LOWER, UPPER = "lower", "upper"
SHORT = "too short between two gaps"

# Kind → text of a remark.
WORDS = {
    GAP: "samples are missing",
    EMPTY: "the cell is empty or no number",
    CODE: "the value is a usual code for no value, such as −999, far outside the others",
    DUPLICATE: "the sample is there twice",
    CLIPPED: "the sensor is at an end of its range",
    FROZEN: "the value does not change",
    JUMP: "the position jumps",
    SHORT: "what is left between two gaps is too short for the filter",
}


@dataclass(frozen=True)
class LeftOut:
    """One stretch that is left out.

    Attributes
    ----------
    kind
        A key of `WORDS`.
    line, last_line
        First and last line of the file that it concerns; of a gap those around it.
    samples
        Samples left out; of a gap those that are missing, by the usual step.
    begin_s, end_s, begin_m, end_m
        Time and position of the first and last one; NaN where they are not known.
    channel
        Column by which it was found; empty where it is the clock.
    end, rail
        Of clipped samples ``lower`` or ``upper``, the end of the sensor's range, and its value
        there in SI; empty and NaN otherwise.
    """

    kind: str
    line: int
    last_line: int
    samples: int
    begin_s: float
    end_s: float
    begin_m: float
    end_m: float
    channel: str = ""
    end: str = ""
    rail: float = math.nan

    def to_dict(self) -> dict[str, Any]:
        """Return it as plain data, ready for JSON."""
        numbers = {
            name: None if (value := getattr(self, name)) != value else value
            for name in ("begin_s", "end_s", "begin_m", "end_m", "rail")
        }
        return {
            "kind": self.kind,
            "channel": self.channel or None,
            "end": self.end or None,
            "line": self.line,
            "last_line": self.last_line,
            "samples": self.samples,
            **numbers,
        }
