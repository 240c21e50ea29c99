"""Data of a measured run as figures of runs take it: pieces, and an empty row between them.

Figures of a run then draw a gap where nothing was measured. Positions rise in them, whichever way
the train went.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from arcless.assess import Assessment
from arcless.assess.section import ForceRecord
from arcless.assess.statistics import ForceBands
from arcless.dataset.build import Entry
from arcless.dataset.plain_dataset import Plain
from arcless.figures.run.run_data import RunData, Sampled

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]


class Track(Protocol):
    """Measured samples of one pantograph, piece behind piece."""

    @property
    def name(self) -> str:
        """Name of the pantograph."""

    @property
    def rate_Hz(self) -> float:  # noqa: N802 - the unit is part of the name
        """Samples in a second."""

    @property
    def time(self) -> Floats:
        """Times in s."""

    @property
    def position(self) -> Floats:
        """Positions in m."""

    @property
    def force(self) -> Floats:
        """Unfiltered contact force in N."""

    @property
    def height(self) -> Floats | None:
        """Height of the contact point in m."""

    @property
    def pieces(self) -> Sequence[slice]:
        """Samples of each piece."""


@dataclass(frozen=True)
class Kept:
    """Samples of one pantograph, their filtered forces, and those that were assessed.

    Attributes
    ----------
    track
        The samples.
    bands
        Filtered force in N.
    inside
        Samples that count: in the section, and far enough from the ends of their piece.
    """

    track: Track
    bands: ForceBands
    inside: Mask


class MeasuredData(RunData):
    """Measurement and assessment, ready to be drawn by the figures of a run.

    Parameters
    ----------
    kept
        Samples of each pantograph.
    assessment
        Their assessment.
    supports_m
        Positions of the supports in m, where they are known.
    """

    def __init__(
        self, kept: Sequence[Kept], assessment: Assessment, supports_m: Floats | None = None
    ) -> None:
        rows = max(one.track.force.size + len(one.track.pieces) - 1 for one in kept)
        columns = [_columns(one, rows) for one in kept]
        stacked = {name: np.stack([each[name] for each in columns], axis=1) for name in columns[0]}
        inside, total = np.nan_to_num(stacked["inside"]) > 0.0, stacked["total"]
        bands = ForceBands(total, stacked["low"], total - stacked["low"])
        record = ForceRecord(kept[0].track.rate_Hz, stacked["force"], bands, inside)
        over = ("time", "pantograph")
        data: dict[str, Entry] = {"position": (over, stacked["position"], {"units": "m"})}
        if not np.isnan(stacked["height"]).all():
            data["contact_height"] = (over, stacked["height"], {"units": "m"})
        if supports_m is not None:
            data["support_x"] = (("support",), supports_m, {"units": "m"})
        coords = {
            "pantograph": (("pantograph",), np.array([one.track.name for one in kept]), {}),
            "time": (("time",), stacked["time"][:, 0], {"units": "s"}),
        }
        super().__init__(Plain(data, coords, {}), assessment)
        self.__dict__ |= {"record": record, "times": stacked["time"], "kept": tuple(kept)}

    times: Floats
    """Times in s, (row, pantograph); NaN between two pieces."""
    kept: tuple[Kept, ...]

    @cached_property
    def sampled(self) -> list[Sampled] | None:
        """Samples of each pantograph with the rows between its pieces, so that gaps stay open."""
        usual = super().sampled
        if usual is None:
            return None
        found = []
        for i, one in enumerate(usual):
            open_rows = np.flatnonzero(np.isnan(self.times[:, i]))
            ends = np.concatenate([open_rows - 1, open_rows, open_rows + 1])
            rows = np.union1d(one.rows, ends[(ends >= 0) & (ends < len(self.times))])
            found.append(Sampled(rows, self.position[rows, i], self.times[rows, i]))
        return found

    def stretches(self, pantograph: int) -> list[Floats]:
        """Return the unfiltered force in N of each piece, inside the section."""
        one = self.kept[pantograph]
        parts = (one.track.force[piece][one.inside[piece]] for piece in one.track.pieces)
        return [part for part in parts if part.size]

    def left_out(self, pantograph: int) -> list[tuple[float, float]]:
        """Return stretches of the section in m without samples that count."""
        one, (reached, end) = self.kept[pantograph], self.assessment.section_m
        counted = [one.track.position[piece][one.inside[piece]] for piece in one.track.pieces]
        found = []
        for low, high in sorted((float(x.min()), float(x.max())) for x in counted if x.size):
            if low > reached:
                found.append((reached, low))
            reached = max(reached, high)
        return [*found, (reached, end)] if reached < end else found


def _columns(one: Kept, rows: int) -> dict[str, Floats]:
    """Return the columns of a pantograph, each with so many rows, by rising positions."""
    track = one.track
    falling = track.position[-1] < track.position[0]
    order = slice(None, None, -1 if falling else 1)
    height = np.full(track.force.size, np.nan) if track.height is None else track.height
    named = {
        "time": track.time, "position": track.position, "force": track.force,
        "total": one.bands.total, "low": one.bands.low, "height": height,
        "inside": one.inside.astype(np.float64),
    }  # fmt: skip
    found = {}
    for name, values in named.items():
        # Between two pieces there is no number, but a place, which an axis needs.
        filler = (lambda piece: piece[:1]) if name == "position" else (lambda _: np.array([np.nan]))
        parts = [values[piece][order] for piece in list(track.pieces)[order]]
        joined = [part for piece in parts for part in (filler(piece), piece)][1:]
        column = np.concatenate(joined)
        rest = np.full(rows - column.size, column[-1] if name == "position" else np.nan)
        found[name] = np.concatenate([column, rest])
    return found
