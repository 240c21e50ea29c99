"""Viewer of a run: it is handed the motion of the line while the run steps."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from arcless.equilibrium.equilibrium import Equilibrium
from arcless.model import Scenario
from arcless.simulate.recording.motion import MotionLayout, MotionPiece, piece_of
from arcless.simulate.recording.record import joined, mass_displacements

Watch = Callable[[MotionPiece], None]
Take = Callable[[dict[str, Any]], None]
# Numbers of the pieces that are joined before they are written: 8 MB. A file takes a piece in some
# ms, however short it is.
WRITTEN_AT_ONCE = 1 << 20


@dataclass
class Viewer:
    """Viewer of a run, and how often the run was begun.

    Attributes
    ----------
    watch
        Called with each piece, in the thread that steps; what it raises ends the run.
    searching
        Whether runs that begin now search for the static force.
    """

    watch: Watch
    searching: bool = False
    attempts: int = field(default=0, init=False)

    def audience(
        self,
        scenario: Scenario,
        found: Equilibrium,
        layout: MotionLayout,
        take: Take | None,
        *,
        kept: bool,
    ) -> "Audience":
        """Return the receiver of the pieces of one more attempt.

        `take` is handed them, too, and with `kept` they hold the motion.
        """
        self.attempts += 1
        return Audience(self, scenario, found, layout, take, kept)


@dataclass
class Audience:
    """Receiver of the pieces of an attempt: shows them, and keeps them or hands them on."""

    viewer: Viewer
    scenario: Scenario
    found: Equilibrium
    layout: MotionLayout
    further: Take | None
    kept: bool
    _held: list[dict[str, Any]] = field(default_factory=list, init=False)
    _numbers: int = field(default=0, init=False)

    def __post_init__(self) -> None:
        self._attempt, self._searching = self.viewer.attempts, self.viewer.searching

    def take(self, raw: dict[str, Any]) -> None:
        """Take a piece of the series."""
        self._show(raw)
        own = self._own(raw)
        self._held.append(own)
        self._numbers += sum(values.size for values in own.values() if hasattr(values, "size"))
        if self.further is not None and self._numbers >= WRITTEN_AT_ONCE:
            self.further(joined(self._held))
            self._held, self._numbers = [], 0

    def whole(self, last: dict[str, Any]) -> dict[str, Any]:
        """Return the record, given its last piece: all of it, or what was not handed on."""
        self._show(last)
        state = last.pop("state")
        self._held.append(self._own(last))
        return {**joined(self._held), "state": state}

    def _show(self, raw: dict[str, Any]) -> None:
        masses = mass_displacements(raw, self.scenario)
        piece = piece_of(
            raw, self.found, self.layout, self.scenario,
            masses=masses, attempt=self._attempt, searching=self._searching,
        )  # fmt: skip
        self.viewer.watch(piece)

    def _own(self, raw: dict[str, Any]) -> dict[str, Any]:
        """Return a piece as the result has it."""
        if self.kept:
            return raw
        none = {"motion_time": np.zeros(0), "motion_first": np.zeros(0)}
        return {**raw, **none, "motion": np.zeros(0, np.float32)}
