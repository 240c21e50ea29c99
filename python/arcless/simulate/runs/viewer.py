"""Viewer of a run: it is handed the motion of the line while the run steps."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from arcless.simulate.recording.motion import MotionPiece, piece_of
from arcless.simulate.recording.record import joined, mass_displacements

if TYPE_CHECKING:
    from arcless.simulate.runs.job import Job, Take

Watch = Callable[[MotionPiece], None]
# Numbers of the pieces that are joined before they are written: 8 MB. A file takes a piece in some
# ms, however short it is.
WRITTEN_AT_ONCE = 1 << 20


@dataclass
class Viewer:
    """Whoever looks at a run, and how often the run was begun.

    Attributes
    ----------
    watch
        Called with each piece, in the thread that steps; what it raises ends the run.
    """

    watch: Watch
    attempts: int = field(default=0, init=False)

    def audience(self, job: "Job", take: "Take | None") -> "Audience":
        """Return the receiver of the pieces of one more attempt; `take` wants them, too."""
        self.attempts += 1
        return Audience(job, self, self.attempts, take)


class Audience:
    """Receives the pieces of an attempt: hands them to the viewer, and keeps or hands them on."""

    def __init__(self, job: "Job", viewer: Viewer, attempt: int, further: "Take | None") -> None:
        self._job, self._viewer = job, viewer
        self._attempt, self._further = attempt, further
        self._held: list[dict[str, Any]] = []
        self._numbers = 0

    def take(self, raw: dict[str, Any]) -> None:
        """Take a piece of the series."""
        self._show(raw)
        self._held.append(self._kept(raw))
        self._numbers += sum(values.size for values in raw.values() if hasattr(values, "size"))
        if self._further is not None and self._numbers >= WRITTEN_AT_ONCE:
            self._hand_on()

    def whole(self, last: dict[str, Any]) -> dict[str, Any]:
        """Return the record, given its last piece: all of it, or what was not handed on."""
        self._show(last)
        state = last.pop("state")
        self._held.append(self._kept(last))
        return {**joined(self._held), "state": state}

    def _show(self, raw: dict[str, Any]) -> None:
        layout = self._job.motion
        assert layout is not None
        masses = mass_displacements(raw, self._job.scenario)
        piece = piece_of(
            raw, self._job.found, layout, self._job.scenario, masses=masses, attempt=self._attempt
        )
        self._viewer.watch(piece)

    def _kept(self, raw: dict[str, Any]) -> dict[str, Any]:
        """Return the piece as the result has it."""
        if self._job.kept_motion is not None:
            return raw
        none = {"motion_time": np.zeros(0), "motion_first": np.zeros(0)}
        return {**raw, **none, "motion": np.zeros(0, np.float32)}

    def _hand_on(self) -> None:
        assert self._further is not None
        self._further(joined(self._held))
        self._held, self._numbers = [], 0
