"""The recorded evidence: what the tests of this version measured, topic by topic.

`tests/verification` holds the checks, `make evidence` runs all of them and writes these records;
the pages of docs/validation and `arcless validate all` are made from nothing else. Every run of the
tests compares what it measures with the records, so they cannot drift apart.
"""

import json
from collections.abc import Iterator
from dataclasses import asdict, dataclass, field
from importlib import resources
from importlib.resources.abc import Traversable
from typing import Any

from arcless.validate.rows import Row

GROUPS = {
    "closed_forms": "Closed forms",
    "orders": "Orders of convergence",
    "limits": "Against the limit",
    "conservation": "Conservation and symmetry",
    "peers": "Other programs",
    "references": "Published references",
}
INSIDE, OUTSIDE, UNVERIFIED = "inside", "outside", "outside (unverified)"


@dataclass(frozen=True, slots=True)
class Measurement:
    """One value held against what it must be.

    Attributes
    ----------
    what, unit
        What was measured, and its unit ("1" for a number without).
    value, reference
        The value, and the one it is compared with (None where there are only bounds).
    low, high
        Bounds, None where there is none.
    allowed, reason, mark
        The tolerance in words, why it is that, and the confidence mark of a published reference.
    verdict
        "inside", "outside", or "outside (unverified)".
    test, slow
        The test that measured it, and whether only `make evidence` runs that.
    table
        Sizes, errors and local orders behind an observed order, or the quantities in which a
        run is compared with its limit; else empty.
    """

    what: str
    unit: str
    value: float
    reference: float | None
    low: float | None
    high: float | None
    allowed: str
    reason: str
    mark: str
    verdict: str
    test: str
    slow: bool = False
    table: list[list[float]] = field(default_factory=list)

    @property
    def share(self) -> float | None:
        """Used share of the tolerance: 1 at the bound; None without a tolerance."""
        if self.reference is not None and self.high is not None and self.high > self.reference:
            return abs(self.value - self.reference) / (self.high - self.reference)
        if self.low is None and self.high:
            return self.value / self.high
        if self.low is not None and self.high is not None and self.high > self.low:
            return abs(2.0 * self.value - self.low - self.high) / (self.high - self.low)
        return None


@dataclass(frozen=True, slots=True)
class NoticedFault:
    """A deliberate fault: what was broken, which value noticed, how many tolerances it was off."""

    fault: str
    row: str
    found: str
    test: str
    slow: bool = False


@dataclass(slots=True)
class Topic:
    """All that one verification file recorded; `text` is the equation, its source and the way."""

    group: str
    name: str
    title: str = ""
    text: str = ""
    version: str = ""
    rows: list[Measurement] = field(default_factory=list)
    faults: list[NoticedFault] = field(default_factory=list)
    figures: list[dict[str, str]] = field(default_factory=list)

    @property
    def inside(self) -> int:
        """Number of values that are where they must be."""
        return sum(row.verdict == INSIDE for row in self.rows)

    @property
    def most_used(self) -> float | None:
        """Largest share of a tolerance, of the values inside of theirs; None without any."""
        shares = [row.share for row in self.rows if row.verdict == INSIDE]
        return max((share for share in shares if share is not None), default=None)

    def as_rows(self) -> list[Row]:
        """Return the values in the form of the reference cases."""
        return [
            Row(
                case=f"{GROUPS[self.group]}: {self.title}", key=row.test, quantity=row.what,
                unit=row.unit, value=row.value, digits=-1, low=row.low, high=row.high,
                limit=row.allowed, mark=row.mark, verdict=row.verdict,
                note=f"recorded by the tests of version {self.version}", checked=row.reason,
            )
            for row in self.rows
        ]  # fmt: skip

    def to_json(self) -> str:
        """Return the text of the record."""
        return json.dumps(asdict(self), indent=1, ensure_ascii=False, allow_nan=False) + "\n"

    @classmethod
    def from_json(cls, text: str) -> "Topic":
        """Read the text of a record."""
        data: dict[str, Any] = json.loads(text)
        data["rows"] = [Measurement(**row) for row in data["rows"]]
        data["faults"] = [NoticedFault(**fault) for fault in data["faults"]]
        return cls(**data)


def recorded() -> list[Topic]:
    """Return every topic, group by group and in the order of their names."""
    return [Topic.from_json(file.read_text(encoding="utf-8")) for file in _files()]


def _files() -> Iterator[Traversable]:
    records = resources.files("arcless.validate") / "recorded"
    for group in GROUPS:
        folder = records / group
        if folder.is_dir():
            yield from sorted(
                (file for file in folder.iterdir() if file.name.endswith(".json")),
                key=lambda file: file.name,
            )
