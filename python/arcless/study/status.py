"""How far a study is, from its folder alone."""

from collections import Counter
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from arcless.study import journal
from arcless.study.folder import StudyFolder
from arcless.study.model import Study


@dataclass(frozen=True)
class StudyStatus:
    """How far a study is.

    Attributes
    ----------
    name, folder
        The study and its folder.
    running
        Whether a process computes it just now.
    total, done, invalid, failed, missing
        Variants: of the study, and by what came of them.
    wall_time_s
        Sum of the wall times of the rows, in s.
    errors
        The reasons of rows without values, with how many rows have each; most frequent first.
    versions
        The versions that computed the rows, with how many each.
    """

    name: str
    folder: str
    running: bool
    total: int
    done: int
    invalid: int
    failed: int
    missing: int
    wall_time_s: float
    errors: dict[str, int]
    versions: dict[str, int]

    def to_dict(self) -> dict[str, Any]:
        """Return it as plain values."""
        return asdict(self)


def status(study: Study, folder: Path | None = None) -> StudyStatus:
    """Return how far a study is.

    Parameters
    ----------
    study
        From `arcless.study.load`.
    folder
        Its folder; ``runs/studies/NAME`` without.

    Raises
    ------
    StudyError
        No study was begun there, or another one.
    """
    place = StudyFolder(study, folder)
    place.check_same()
    counts: Counter[str] = Counter()
    errors: Counter[str] = Counter()
    versions: Counter[str] = Counter()
    wall_time_s = 0.0
    for row in place.rows():
        counts[row.status] += 1
        versions[row.arcless_version] += 1
        wall_time_s += row.wall_time_s
        if row.status != "done":
            errors[row.error] += 1
    return StudyStatus(
        name=study.name,
        folder=str(place.path),
        running=journal.is_locked(place.journal),
        total=study.plan.count,
        done=counts["done"],
        invalid=counts["invalid"],
        failed=counts["failed"],
        missing=study.plan.count - counts.total(),
        wall_time_s=wall_time_s,
        errors=dict(errors.most_common()),
        versions=dict(versions.most_common()),
    )
