"""First guess of the shape of each wire: heights and lateral positions over the track, in m."""

import numpy as np

from arcless.mesh.division.bridles import rise
from arcless.mesh.division.smooth_curves import smooth
from arcless.mesh.division.wire_names import AUXILIARY, BRIDLE, MESSENGER, STITCH
from arcless.mesh.division.wires import Stations
from arcless.mesh.tables.mesh_types import Floats
from arcless.model.line.line import Line


class Guess:
    """Guessed heights of the wires of a system, each found once it is asked for.

    Parameters
    ----------
    line, places
        What the wires are made of, and the stations of the system.
    gravity
        In m/s².
    """

    def __init__(self, line: Line, places: Stations, gravity: float) -> None:
        self.line, self.places, self.gravity = line, places, gravity
        system = places.system
        above = 0.0 if line.auxiliary_wire is None else line.auxiliary_wire.height
        self.heights = {
            **dict.fromkeys(system.contact_wires, system.contact_heights),
            AUXILIARY: [height + above for height in system.contact_heights],
            MESSENGER: system.messenger_heights,
        }

    def of(self, wire: str, x: Floats) -> Floats:
        """Height of a wire at positions x; of stitch wires and bridles, between their clamps."""
        if wire == MESSENGER:
            return self._messenger(x)
        if wire == STITCH:
            return self._stitch(x)
        if wire == BRIDLE:
            return self._bridle(x)
        if self.line.messenger_wire is None:
            return self._alone(x)
        return self._held(wire, x)

    def _nominal(self, wire: str, x: float | Floats) -> Floats:
        """Height in m by design, where droppers hold the wire without pre-sag.

        Straight from support to support; a wire that leaves in an overlap rises in a curve, so that
        it is heavy enough to hang on its droppers all the way.
        """
        system = self.places.system
        straight = np.interp(x, system.supports, self.heights[wire])
        return np.asarray(straight + smooth(system.supports, system.rises, x))

    def _with_below(self, mass: float) -> float:
        """Mass in kg/m of a wire and of those that hang below it."""
        line = self.line
        mass += line.contact_wire.mass * len(self.places.system.contact_wires)
        return mass if line.auxiliary_wire is None else mass + line.auxiliary_wire.mass

    def _messenger(self, x: Floats) -> Floats:
        """Parabolas q x (L − x) / 2T, q the weight of all wires."""
        line, supports = self.line, np.asarray(self.places.supports)
        assert line.messenger_wire is not None
        mass = self._with_below(line.messenger_wire.mass)
        span = np.clip(np.searchsorted(supports, x, side="right") - 1, 0, len(supports) - 2)
        sag = self._sag(x, supports[span], supports[span + 1], mass, line.messenger_wire.tension)
        straight = np.interp(x, supports, self.heights[MESSENGER])
        return np.asarray(straight - sag)

    def _stitch(self, x: Floats) -> Floats:
        """Below the line between its clamps by the weight of what hangs on it."""
        line, clamps = self.line, np.asarray(self.places.clamps)
        assert line.stitch_wire is not None
        which = np.clip(np.searchsorted(clamps[:, 0], x, side="right") - 1, 0, len(clamps) - 1)
        left, right = clamps[which].T
        share = (x - left) / (right - left)
        chord = (1.0 - share) * self._messenger(left) + share * self._messenger(right)
        mass = self._with_below(line.stitch_wire.mass)
        return np.asarray(chord - self._sag(x, left, right, mass, line.stitch_wire.tension))

    def _sag(self, x: Floats, left: Floats, right: Floats, mass: float, tension: float) -> Floats:
        load = mass * self.gravity
        return np.asarray(load * (x - left) * (right - x) / (2.0 * tension))

    def _alone(self, x: Floats) -> Floats:
        """Of a contact wire without messenger wire: parabolas between the points that hold it."""
        line, system = self.line, self.places.system
        supports, tension = system.supports, line.contact_wire.tension
        clamps = [place for pair in self.places.bridles for place in pair]
        held = np.array([supports[0], *(clamps or supports[1:-1]), supports[-1]])
        # A clamp is as high as its support.
        counts = [1, *[2 if clamps else 1] * (len(supports) - 2), 1]
        heights = np.repeat(system.held_heights, counts)
        piece = np.clip(np.searchsorted(held, x, side="right") - 1, 0, len(held) - 2)
        straight = np.interp(x, held, heights)
        if tension == 0.0:
            return np.asarray(straight)
        sag = self._sag(x, held[piece], held[piece + 1], line.contact_wire.mass, tension)
        return np.asarray(straight - sag)

    def _bridle(self, x: Floats) -> Floats:
        """Straight from each clamp to where the bridle hangs."""
        line, system = self.line, self.places.system
        known: dict[float, float] = {}
        assert line.bridle is not None
        for index, (first, last) in enumerate(self.places.bridles, start=1):
            height = system.held_heights[index]
            above = rise(line, line.bridle, system, index, self.gravity)
            known |= {first: height, system.supports[index]: height + above, last: height}
        ordered = sorted(known)
        return np.interp(x, ordered, [known[place] for place in ordered])

    def _held(self, wire: str, x: Floats) -> Floats:
        """Straight between the heights known at its droppers and its ends."""
        ends = (self.places.supports[0], self.places.supports[-1])
        system = self.places.system
        measured = system.measured if wire in system.contact_wires else {}
        known = {x: float(self._nominal(wire, x)) for x in ends} | dict(measured)
        own = [h for h in self.places.hangings if h.lower == wire]
        for upper in dict.fromkeys(h.upper for h in own):
            hung = [h for h in own if h.upper == upper]
            places = np.array([h.x for h in hung])
            levels, tops = self._nominal(wire, places).tolist(), self.of(upper, places).tolist()
            for h, nominal, top in zip(hung, levels, tops, strict=True):
                if h.x not in measured:
                    drawn = h.presag is not None
                    known[h.x] = nominal - (h.presag or 0.0) if drawn else top - (h.length or 0)
        ordered = sorted(known)
        return np.interp(x, ordered, [known[place] for place in ordered])
