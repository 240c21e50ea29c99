"""Watching of a run in its worker process: what steps hand on is written to the spool."""

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from arcless.model import Scenario
from arcless.simulate.recording.motion import MotionPiece
from arcless.studio.at_rest.of_equilibrium import geometry_at_rest
from arcless.studio.at_rest.plain_geometry import Geometry
from arcless.studio.motion.channels import ROUNDING_S
from arcless.studio.motion.layout import RowLayout, WirePart
from arcless.studio.motion.spool import SpoolWriter

Floats = NDArray[np.float64]


class Announce(Protocol):
    """Tells the server of a motion, and returns what takes its rows."""

    def __call__(
        self, layout: RowLayout, geometry: Geometry, *, every_s: float, end_s: float
    ) -> SpoolWriter:
        """Announce a motion: layout and line, interval and end in s."""


class Watching:
    """Takes the pieces of a run, as `arcless.run` hands them to `watch`.

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
        self._contacts: list[Floats] = []
        self._attempt = 0

    def __call__(self, piece: MotionPiece) -> None:
        """Write a piece to the spool."""
        if piece.attempt != self._attempt:
            self._begin(piece)
        contacts = _contacts(piece, self._layout)
        self._contacts = [
            np.concatenate(each) for each in zip(self._contacts, contacts, strict=True)
        ]
        if self._spool is not None and len(piece.time_s):
            self._spool.append(self._rows(piece))
        self._contacts = [each[-1:] for each in self._contacts]

    def finish(self) -> None:
        """Say that the run is over."""
        if self._spool is not None:
            self._spool.finish()

    @property
    def full(self) -> bool:
        """True when the disk had no room for all of it."""
        return self._spool is not None and self._spool.full

    def _begin(self, piece: MotionPiece) -> None:
        """Announce an attempt of the run."""
        self._attempt = piece.attempt
        self._layout = layout_of(piece, self._scenario)
        # Times of contacts, then the values of each pantograph: the last row that is known.
        self._contacts = [each[:0] for each in _contacts(piece, self._layout)]
        self._spool = self._announce(
            self._layout, geometry_at_rest(piece.found, self._scenario.line),
            every_s=piece.layout.every * self._scenario.time_step_s,
            end_s=self._scenario.duration,
        )  # fmt: skip

    def _rows(self, piece: MotionPiece) -> NDArray[np.void]:
        """Return the rows of a piece; contacts are those of the last row at or before each."""
        rows = np.zeros(len(piece.time_s), self._layout.type)
        rows["time"], rows["first"], rows["up"] = piece.time_s, piece.first, piece.up_m
        if piece.across_m is not None:
            rows["across"] = piece.across_m
        if self._layout.dropper_count:
            rows["dropper_first"], rows["droppers"] = piece.dropper_first, piece.dropper_force_N
        times, *values = self._contacts
        at = np.searchsorted(times, piece.time_s + ROUNDING_S, side="right") - 1
        for number, each in enumerate(values):
            known = each[np.maximum(at, 0)] if len(each) else np.full((1, each.shape[1]), np.nan)
            rows[f"pantograph {number}"] = known
        return rows


def _contacts(piece: MotionPiece, layout: RowLayout) -> list[Floats]:
    """Return the times of contacts, then of each pantograph the values of its channel."""
    unknown = np.full(len(piece.contact_time_s), np.nan)
    found = [np.asarray(piece.contact_time_s)]
    for number, (_, masses) in enumerate(layout.pantographs):
        head = (piece.position_m, piece.contact_force_N, piece.contact_height_m)
        columns = [*(values[:, number] for values in head), unknown]
        found.append(np.column_stack([*columns, piece.mass_displacement_m[:, number, :masses]]))
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
