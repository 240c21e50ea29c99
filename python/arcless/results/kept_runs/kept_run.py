"""One run on the disk in a few words: verdict, main numbers, what was set for it."""

from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any, Final, Literal

STOPPED: Final = "stopped early"
UNREADABLE: Final = "unreadable"
Verdict = Literal["met", "not met", "not judged", "stopped early", "unreadable"]


@dataclass(frozen=True)
class MainNumbers:
    """Main numbers of one pantograph; None where the record does not hold one.

    Attributes
    ----------
    name
        Name of the pantograph.
    mean_force_N, std_force_N, max_force_N, min_force_N
        Contact force after the low-pass: mean F_m, standard deviation σ, maximum, minimum.
    NQ_percent
        Percentage of arcing, losses of contact above 5 ms.
    """

    name: str
    mean_force_N: float | None  # noqa: N815
    std_force_N: float | None  # noqa: N815
    max_force_N: float | None  # noqa: N815
    min_force_N: float | None  # noqa: N815
    NQ_percent: float | None


@dataclass(frozen=True)
class KeptRun:
    """A run on the disk.

    Attributes
    ----------
    path
        Its folder or, where the file is not called result.nc, its file.
    verdict
        "met": no limit that decides is missed; "not met"; "not judged": no limit that decides could
        be judged; "stopped early"; "unreadable".
    reason
        Criteria that are not met or not told, where it stopped, or why it cannot be read.
    name
        Name of the scenario; None of a run that cannot be read, as all that follows.
    created
        When it was computed, ISO 8601, UTC; where it cannot be read, when the file was changed.
    version
        Version of Arcless that computed it.
    line
        Name of its line.
    line_digest
        First digits of the SHA-256 of all that the line says: lines of one name may differ.
    speed_m_s
        Mean speed in the analysis section.
    changes
        Fields that were set for the run, by dotted path, values as typed; see `Scenario.changes`.
    pantographs
        Main numbers of each pantograph; none of a run that stopped early.
    max_uplift_at_support_mm
        Maximum uplift at a support inside the section.
    """

    path: Path
    verdict: Verdict
    reason: str | None = None
    name: str | None = None
    created: str | None = None
    version: str | None = None
    line: str | None = None
    line_digest: str | None = None
    speed_m_s: float | None = None
    changes: dict[str, str] = field(default_factory=dict)
    pantographs: tuple[MainNumbers, ...] = ()
    max_uplift_at_support_mm: float | None = None

    @property
    def worst(self) -> MainNumbers | None:
        """Numbers of the pantograph with the largest standard deviation of the contact force."""
        return max(self.pantographs, key=lambda one: one.std_force_N or 0.0, default=None)

    def to_dict(self) -> dict[str, Any]:
        """Return it as plain values, ready for JSON."""
        data = asdict(self) | {"path": str(self.path)}
        data["pantographs"] = [asdict(one) for one in self.pantographs]
        data["worst"] = None if self.worst is None else self.worst.name
        return data
