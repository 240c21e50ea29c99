"""Watching of a run in its worker process: what steps hand on is written to the spool."""

import queue
import threading
from typing import Protocol, Self

import numpy as np
from numpy.typing import NDArray

from arcless.model import Scenario
from arcless.simulate.recording.motion import MotionPiece
from arcless.studio.at_rest.of_equilibrium import geometry_at_rest
from arcless.studio.at_rest.plain_geometry import Geometry
from arcless.studio.motion.channels import ROUNDING_S
from arcless.studio.motion.layout import HEAD, RowLayout, WirePart
from arcless.studio.motion.spool import SpoolWriter

Floats = NDArray[np.float64]
# Pieces that wait to be written, of half a megabyte each. With fewer a run waits for a slow disk;
# with more it takes the memory of one.
MOST_WAITING = 32


class Announce(Protocol):
    """Tells the server of a motion, and returns what takes its rows."""

    def __call__(
        self,
        layout: RowLayout,
        geometry: Geometry,
        *,
        every_s: float,
        end_s: float,
        search: int | None,
    ) -> SpoolWriter:
        """Announce a motion: layout and line, interval and end in s, which attempt of a search."""


class Watching:
    """Takes the pieces of a run, as `arcless.run` hands them to `watch`; enter it for the run.

    They are written by a thread of its own: the one that steps only hands them over.

    Parameters
    ----------
    scenario
        Scenario that is run.
    announce
        Asked for the spool when the first piece is there, and when the run begins again.
    """

    def __init__(self, scenario: Scenario, announce: Announce) -> None:
        self._scenario, self._announce = scenario, announce
        self._spool: SpoolWriter | None = None
        # Values of each pantograph in the last row of contacts that is known.
        self._before: list[Floats] = []
        self._attempt = 0
        self._pieces: queue.Queue[MotionPiece | None] = queue.Queue(MOST_WAITING)
        self._failure: Exception | None = None
        self._thread = threading.Thread(target=self._work, daemon=True)

    def __enter__(self) -> Self:
        """Begin to wait for pieces."""
        self._thread.start()
        return self

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        """Write what is still there, and say that the run is over."""
        self._pieces.put(None)
        self._thread.join()
        if self._failure is not None and kind is None:
            raise self._failure

    def __call__(self, piece: MotionPiece) -> None:
        """Take a piece; a run that is faster than its pieces are written waits for them."""
        self._pieces.put(piece)

    @property
    def full(self) -> bool:
        """True when the disk had no room for all of it."""
        return self._spool is not None and self._spool.full

    def _work(self) -> None:
        while (piece := self._pieces.get()) is not None:
            try:
                self._take(piece)
            except Exception as error:  # raised again where the run ends
                self._failure = self._failure or error
        if self._spool is not None:
            self._spool.finish()

    def _take(self, piece: MotionPiece) -> None:
        if piece.attempt != self._attempt:
            self._begin(piece)
        if self._spool is not None and len(piece.time_s):
            self._spool.append(self._rows(piece))
        if len(piece.contact_time_s):
            self._before = self._contacts(piece, np.array([-1]))

    def _begin(self, piece: MotionPiece) -> None:
        """Announce an attempt of the run."""
        self._attempt = piece.attempt
        self._layout = layout_of(piece, self._scenario)
        sizes = [HEAD + masses for _, masses in self._layout.pantographs]
        self._before = [np.full((1, size), np.nan) for size in sizes]
        self._spool = self._announce(
            self._layout, geometry_at_rest(piece.found, self._scenario.line),
            every_s=piece.layout.every * self._scenario.time_step_s,
            end_s=self._scenario.duration,
            search=piece.attempt if piece.searching else None,
        )  # fmt: skip

    def _rows(self, piece: MotionPiece) -> NDArray[np.void]:
        """Return the rows of a piece; contacts are those of the last row at or before each."""
        rows = np.zeros(len(piece.time_s), self._layout.type)
        rows["time"], rows["first"], rows["up"] = piece.time_s, piece.first, piece.up_m
        if piece.across_m is not None:
            rows["across"] = piece.across_m
        if self._layout.dropper_count:
            rows["dropper_first"], rows["droppers"] = piece.dropper_first, piece.dropper_force_N
        times = piece.contact_time_s
        at = np.searchsorted(times, piece.time_s + ROUNDING_S, side="right") - 1
        known = at >= 0
        for number, values in enumerate(self._contacts(piece, at[known])):
            own = rows[f"pantograph {number}"]
            own[known], own[~known] = values, self._before[number]
        return rows

    def _contacts(self, piece: MotionPiece, rows: NDArray[np.intp]) -> list[Floats]:
        """Return the values of each pantograph in some rows of contacts."""
        found = []
        for number, (_, masses) in enumerate(self._layout.pantographs):
            values = np.full((len(rows), HEAD + masses), np.nan)
            head = (piece.position_m, piece.contact_force_N, piece.contact_height_m)
            for column, each in enumerate(head):
                values[:, column] = each[rows, number]
            values[:, HEAD:] = piece.mass_displacement_m[rows, number, :masses]
            found.append(values)
        return found


def layout_of(piece: MotionPiece, scenario: Scenario) -> RowLayout:
    """Return the layout of the rows of a piece."""
    layout = piece.layout
    return RowLayout(
        wires=tuple(WirePart(wire.kind, wire.parts, wire.count) for wire in layout.wires),
        dropper_order=layout.dropper_order,
        dropper_count=layout.dropper_count,
        pantographs=tuple((one.name, len(one.model.heights)) for one in scenario.pantographs),
        spatial=layout.spatial,
    )
