"""A row of a study: what came out of one variant."""

from dataclasses import dataclass, field
from typing import Any, Literal

Status = Literal["done", "pruned", "invalid", "failed"]
# What a row has only where runs were looked at while they stepped.
_WATCHED = ("so_far", "steps", "steps_of_run", "stopped_at_m", "stopped_after_s")


@dataclass(frozen=True)
class Row:
    """What came out of a variant.

    Attributes
    ----------
    variant, key, values
        Number from 1, identity, and values by name of the variable, in SI.
    status
        `done`; `pruned`, stopped as it could not become good any more; `invalid`, the values make
        no valid scenario; `failed`, the computation failed.
    outputs
        By name; None for what is not defined or was not recorded.
    error
        Why there is no value, in a sentence; empty when all is well.
    wall_time_s
        From the start of the variant to its end, in s.
    arcless_version
        Version that computed it, with a digest of the program's files.
    so_far
        Values of outputs over the part of the section travelled at each look, by name.
    steps, steps_of_run
        Steps of all its runs, and of one run to its end; 0 where nobody looked.
    stopped_at_m, stopped_after_s
        Where the first pantograph was when the run was stopped, and the time since its start.
    """

    variant: int
    key: str
    values: dict[str, Any]
    status: Status
    outputs: dict[str, float | None]
    error: str
    wall_time_s: float
    arcless_version: str
    so_far: dict[str, list[float | None]] = field(default_factory=dict)
    steps: int = 0
    steps_of_run: int = 0
    stopped_at_m: float | None = None
    stopped_after_s: float | None = None

    def to_dict(self) -> dict[str, Any]:
        """Return it as plain values, the row's own; without those of looks if there were none."""
        return {name: v for name, v in vars(self).items() if v or name not in _WATCHED}
