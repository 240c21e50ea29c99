"""Talk of a function in a worker process with the server: progress, notes, motion; its end."""

import select
import time
from dataclasses import dataclass, field
from multiprocessing.connection import Connection
from threading import Event, Lock
from typing import Any

from arcless.studio.at_rest.plain_geometry import Geometry
from arcless.studio.motion.layout import RowLayout
from arcless.studio.motion.spool import SpoolWriter

# Time in s between two messages of progress: faster than anyone reads, slow enough to cost nothing.
_BETWEEN_S = 0.05


@dataclass
class Talk:
    """Handed to a function that runs as a job, as its first argument.

    Attributes
    ----------
    connection
        Leads to the server.
    spool
        Descriptor of the file that takes motion; None where the job shows none.
    cancelled
        Set when the job is to end.
    """

    connection: Connection
    spool: int | None = None
    cancelled: Event = field(default_factory=Event)
    _next: float = 0.0
    _one: Lock = field(default_factory=Lock)

    def progress(self, fraction: float, doing: str) -> None:
        """Tell the fraction done and what is being done, not oftener than 20 times a second.

        A server that does not listen, a stopped one, is told nothing: the run does not wait.
        """
        now = time.monotonic()
        if now >= self._next and self._has_room():
            self._next = now + _BETWEEN_S
            self.send(("progress", fraction, doing))

    def cancel(self) -> bool:
        """Return whether the job is to end, as `arcless.run` asks."""
        return self.cancelled.is_set()

    def note(self, text: str) -> None:
        """Tell a warning, a whole sentence."""
        self.send(("note", text))

    def say(self, message: Any) -> None:
        """Send anything that pickles to whom `Task.hear` names."""
        self.send(("said", message))

    def shows(self) -> bool:
        """Return whether somebody may watch: motion is to be spooled."""
        return self.spool is not None

    def motion(
        self,
        layout: RowLayout,
        geometry: Geometry,
        *,
        every_s: float,
        end_s: float,
        search: int | None = None,
    ) -> SpoolWriter:
        """Announce a motion, and return what takes its rows; a later one takes its place.

        Parameters
        ----------
        layout, geometry
            Layout of the rows, and the line whose nodes they move.
        every_s
            Interval of the rows in s.
        end_s
            Time in s at which the motion will end.
        search
            Which attempt of a search for the static force it is, from 1; None: it is the run.

        Raises
        ------
        ValueError
            The job shows nothing, see `Task.shows`.
        """
        if self.spool is None:
            raise ValueError("a job without a spool")
        self.send(("motion", layout, geometry, every_s, end_s, search))
        return SpoolWriter(self.spool, layout.type, self._grown)

    def send(self, message: Any) -> None:
        """Send a message of the worker: threads of a run tell their progress too."""
        with self._one:
            self.connection.send(message)

    def _grown(self, rows: int, end_s: float, final: bool) -> None:
        if final or self._has_room():
            self.send(("edge", rows, end_s, final))

    def _has_room(self) -> bool:
        return bool(select.select([], [self.connection], [], 0.0)[1])
