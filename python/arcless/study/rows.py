"""A row of a study: what came out of one variant."""

from dataclasses import dataclass
from typing import Any, Literal

Status = Literal["done", "invalid", "failed"]


@dataclass(frozen=True)
class Row:
    """What came out of a variant.

    Attributes
    ----------
    variant, key, values
        Number from 1, identity, and values by name of the variable, in SI.
    status
        `done`; `invalid`, the values make no valid scenario; `failed`, the computation failed.
    outputs
        By name; None for what is not defined or was not recorded.
    error
        Why there is no value, in a sentence; empty when all is well.
    wall_time_s
        From the start of the variant to its end, in s.
    arcless_version
        Version that computed it, with a digest of the program's files.
    """

    variant: int
    key: str
    values: dict[str, Any]
    status: Status
    outputs: dict[str, float | None]
    error: str
    wall_time_s: float
    arcless_version: str

    def to_dict(self) -> dict[str, Any]:
        """Return it as plain values, which are the row's own."""
        return dict(vars(self))
