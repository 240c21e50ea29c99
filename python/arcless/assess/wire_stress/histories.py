"""Point forces on the contact wire at its clamps and supports over time.

At a clamp the dropper pulls with its force, and the strip adds its own while it is within some
decimetres, F_c e^(−λ|x − x_c|). Rows of the record are centimetres to decimetres of travel apart,
so the instant at which a pantograph is at the clamp is added to them: the peak is there.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from arcless.assess.wire_stress.bending import StiffString
from arcless.dataset.recorded_series import is_recorded, passage

if TYPE_CHECKING:
    from arcless.dataset.plain_dataset import Dataset

Floats = NDArray[np.float64]

# Lower ends of droppers within this distance in m of the contact wire are on it; an auxiliary wire
# hangs higher by decimetres.
ON_WIRE = 0.03


@dataclass(frozen=True)
class History:
    """Bending of the wire at a place over time.

    Attributes
    ----------
    name, x_m
        Of the clamp or support.
    fibre
        "top", or "arm": that which points to the steady arm.
    held
        Stress in Pa at rest.
    stress
        Stress in Pa by bending, in the order of time.
    """

    name: str
    x_m: float
    fibre: str
    held: float
    stress: Floats


class Passages:
    """Contact forces and places of the pantographs over time."""

    def __init__(self, data: "Dataset", wire: StiffString) -> None:
        self._time = data["time"].values
        self._place, self._force = data["position"].values, data["contact_force"].values
        self._speed = data["speed"].values
        self._line_time: Floats = data["line_time"].values
        self._wire = wire

    def times(self, rows: NDArray[np.intp], x: float) -> Floats:
        """Return the times in s of rows of the line, and those of pantographs at x in m."""
        times = self._line_time[rows]
        if not len(times):
            return times
        at = [float(np.interp(x, place, self._time)) for place in self._place.T
              if place[0] < x < place[-1]]  # fmt: skip
        within = [time for time in at if times[0] < time < times[-1]]
        return np.union1d(times, within)

    def rows(self, rows: NDArray[np.intp], values: Floats, times: Floats) -> Floats:
        """Return a series of the line at times in s."""
        return np.interp(times, self._line_time[rows], values)

    def stress(self, x: float, times: Floats) -> Floats:
        """Return the stress in Pa of the top fibre at x in m under the contact forces."""
        total = np.zeros(len(times))
        for place, force in zip(self._place.T, self._force.T, strict=True):
            distance = np.abs(np.interp(times, self._time, place) - x)
            pressed = np.interp(times, self._time, force)
            speed = float(np.interp(x, place, self._speed))
            near = np.exp(-distance / self._wire.layer(speed))
            total += self._wire.stress_per_newton(speed) * pressed * near
        return total


def of_droppers(
    data: "Dataset", wire: StiffString, section: tuple[float, float]
) -> Iterator[History]:
    """Yield the clamps on the contact wire in a section of the line in m."""
    if "dropper_x" not in data or not is_recorded(data, "dropper"):
        return
    passages, per_newton = Passages(data, wire), wire.stress_per_newton()
    x_all = data["dropper_x"].values
    wire_x, wire_z = (data[f"contact_wire_node_{axis}"].values for axis in "xz")
    on_wire = np.abs(data["dropper_bottom_z"].values - np.interp(x_all, wire_x, wire_z)) < ON_WIRE
    inside = (x_all >= section[0]) & (x_all <= section[1])
    for index in np.flatnonzero(on_wire & inside):
        x = float(x_all[index])
        rows, force = passage(data, "dropper", int(index))
        times = passages.times(rows, x)
        stress = per_newton * passages.rows(rows, force, times) + passages.stress(x, times)
        held = per_newton * float(data["dropper_force_static"].values[index])
        yield History(str(data["dropper"].values[index]), x, "top", held, stress)


def of_supports(
    data: "Dataset", wire: StiffString, section: tuple[float, float]
) -> Iterator[History]:
    """Yield the clamps of steady arms in a section of the line in m, with two fibres each.

    The arm bends the wire towards itself; the strip bends it upwards, of which the share sin α acts
    on the fibre that points to the arm at the angle α.
    """
    if "support_x" not in data or not is_recorded(data, "support", "steady_arm_force"):
        return
    passages, per_newton = Passages(data, wire), wire.stress_per_newton()
    x_all: Any = data["support_x"].values
    for index in np.flatnonzero((x_all >= section[0]) & (x_all <= section[1])):
        x = float(x_all[index])
        rows, force = passage(data, "support", int(index), "steady_arm_force")
        if not len(rows) or np.isnan(force).any():
            continue
        _, angle = passage(data, "support", int(index), "steady_arm_angle")
        times = passages.times(rows, x)
        force, angle = (passages.rows(rows, values, times) for values in (force, angle))
        strip = passages.stress(x, times)
        at_rest = per_newton * float(data["steady_arm_force_static"].values[index])
        rise, name = np.sin(angle), str(data["support"].values[index])
        yield History(name, x, "top", at_rest * float(rise[0]), per_newton * force * rise + strip)
        yield History(name, x, "arm", at_rest, per_newton * force + rise * strip)
