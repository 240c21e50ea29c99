"""Motion of a job: announced to the server, and spooled for it."""

from arcless.studio.at_rest.plain_geometry import Geometry
from arcless.studio.motion.layout import RowLayout
from arcless.studio.motion.spool import SpoolWriter
from arcless.studio.processes.talk import Talk


def spooled(
    talk: Talk,
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
    talk
        Of the job.
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
    if talk.spool is None:
        raise ValueError("a job without a spool")

    def grown(rows: int, row_s: float, final: bool) -> None:
        if final or talk.has_room():
            talk.say(("edge", rows, row_s, final))

    talk.say(("motion", layout, geometry, every_s, end_s, search))
    return SpoolWriter(talk.spool, layout.type, grown)
