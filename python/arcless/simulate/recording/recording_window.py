"""Recording window of a long line: droppers and supports near the pantographs.

The forces of 8100 droppers every 5 ms are 8 GB for 50 km, and all but a few dozen of them are at
rest. So a row of the record holds those from some way behind the last pantograph to as far before
the first one: always as many, in the order along the track, and which one is the first of them.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from arcless.model.settings.run_settings import AUTO, WHOLE_LINE
from arcless.simulate.setup.core_data import RecordingWindow, Stations

if TYPE_CHECKING:
    from arcless.mesh import Mesh
    from arcless.model import Scenario

# Whole lines up to this many numbers, 160 MB; and what is recorded of longer ones, in m.
MOST_NUMBERS = 20_000_000
AROUND = 200.0


@dataclass(frozen=True)
class Nearby:
    """Order of droppers and supports along the track, and how many of them a row holds."""

    around: float
    droppers: NDArray[np.int64]
    dropper_count: int
    supports: NDArray[np.int64]
    support_count: int

    def plan(self, mesh: "Mesh") -> RecordingWindow:
        """Return the window as the core takes it: distance behind in m, links, nodes."""
        droppers = [mesh.droppers[i] for i in self.droppers]
        supports = [mesh.supports[i] for i in self.supports]
        return RecordingWindow(
            behind=self.around,
            links=Stations(
                of=[dropper.link for dropper in droppers],
                x=[dropper.x for dropper in droppers],
                in_row=self.dropper_count,
            ),
            nodes=Stations(
                of=[support.contact_node for support in supports],
                x=[support.x for support in supports],
                in_row=self.support_count,
            ),
        )

    @property
    def variables(self) -> dict[str, NDArray[np.int64]]:
        """The orders, as variables of a result."""
        return {"dropper_order": self.droppers, "support_order": self.supports}


def nearby(scenario: "Scenario", mesh: "Mesh", steps: int) -> Nearby | None:
    """Return the recording window of a run of so many steps; None for the whole line."""
    around = scenario.output.around
    if around == AUTO:
        rows = steps // scenario.output.line_every
        places = scenario.output.droppers * len(mesh.droppers) + len(mesh.supports)
        around = WHOLE_LINE if rows * places <= MOST_NUMBERS else AROUND
    if isinstance(around, str):
        return None
    reach = 2.0 * around + max(placement.distance for placement in scenario.pantographs)
    droppers = ordered([dropper.x for dropper in mesh.droppers], reach)
    return Nearby(around, *droppers, *ordered([support.x for support in mesh.supports], reach))


def ordered(places: list[float], reach: float) -> tuple[NDArray[np.int64], int]:
    """Return the order along the track, and the largest number within a length in m."""
    order = np.argsort(places, kind="stable")
    return order, most_within(np.asarray(places)[order], reach)


def most_within(x: NDArray[np.float64], reach: float) -> int:
    """Return the largest number of ascending places, m, within a length, m; all where it is inf."""
    within = np.searchsorted(x, x + reach, side="right") - np.arange(len(x))
    return int(within.max(initial=0))
