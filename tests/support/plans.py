"""Plans of straight wires: in the plane, across the track, or from side to side of it.

To first order a wire swings up and down, and from side to side, independently of one another: its
tension is the same in all directions, and a contact pushes it upward only. So closed forms of the
plane are those of a wire in space, along its length: it passes under the strip at V√(1 + s²) with
the slope s across the track, which divides a force over a longer wire.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from arcless.model.line.parts.components import Wire
from arcless.simulate.setup.core_data import LoadData
from tests.support.families import Family
from tests.support.straight import ACROSS, Floats, Straight
from tests.support.waves import Waves, pulse

# Times of the pulse from the side, s: together with what is sent upward.
MIDDLE, WIDTH = 0.15, 0.02


@dataclass(frozen=True)
class Plan:
    """A plan of a wire.

    Attributes
    ----------
    slope : across the track per metre along it; None in the plane
    apart : distance of the places at which it turns back to the other side, m; None: it does not
    arms : length of the hinged arms that hold it there, m; None: it is held without them
    swing : what pushes it to the side while something is sent upward, N
    said : in rows of the evidence
    """

    slope: float | None = None
    apart: float | None = None
    arms: float | None = None
    swing: float = 0.0
    said: str = ""

    def lay(self, family: Family, x: Floats, *kinds: Wire) -> Straight:
        """Lay wires with nodes at the given places, m."""
        return family.line(x, *kinds, **self._options(float(x[-1])))

    def _options(self, end: float) -> dict[str, Any]:
        return {"slant": self.slope, "corners": self.corners(end), "arms": self.arms}

    @property
    def longer(self) -> float:
        """Length along the wire per metre along the track."""
        return float(np.hypot(1.0, self.slope or 0.0))

    def along(self, waves: Waves, speed: float) -> tuple[Waves, float]:
        """Return wave and speed, m/s, along a wire whose pull along the track is its tension."""
        tension = waves.tension * self.longer
        return Waves(tension, waves.density, waves.bending), speed * self.longer

    def corners(self, end: float) -> Sequence[float]:
        """Return where a wire that ends at so many m turns back."""
        if self.apart is None:
            return ()
        return [float(x) for x in np.arange(0.5 * self.apart, end, self.apart)]

    def loads(self, line: Straight, place: float, time: Floats) -> list[LoadData]:
        """Push the wire to the side, at a place in m."""
        if not self.swing:
            return []
        sizes = pulse(time, MIDDLE, WIDTH, self.swing)
        return [LoadData([(line.node(place), ACROSS, 1.0)], sizes.tolist())]


IN_PLANE = Plan()
SLANTED = Plan(0.1, said=", in space")
# ± 0.43 m, 28.8 m apart: corners of 60 mrad, twice those of AC simple. 200 N move it by 20 mm.
STAGGERED = Plan(0.03, apart=28.8, swing=200.0, said=", staggered")
