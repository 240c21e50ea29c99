"""Motion of the wires near the pantographs: what is recorded of it, and what a viewer is handed.

A row holds of each wire always as many nodes, in the order along it, from the first one that is so
far behind the last pantograph, and which one that is. The displacements are those from rest, in
single precision: a picture needs no more.
"""

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from arcless.model.settings.run_settings import RecordedMotion
from arcless.simulate.recording import contacts
from arcless.simulate.recording.recording_window import most_within, nearby, ordered
from arcless.simulate.setup import trajectory
from arcless.simulate.setup.core_data import MotionPlan, Stations

if TYPE_CHECKING:
    from arcless.equilibrium.equilibrium import Equilibrium
    from arcless.mesh import Mesh
    from arcless.model import Scenario

# Time between two rows where it is left to auto, s, and from so many steps on. At 10 ms a run of
# 50 km would take a fifth longer, and its motion 1.3 GB; at more than 20 ms motion of 20 Hz has
# less than three rows in a period.
INTERVAL_S, LONG, LONG_INTERVAL_S = 0.01, 100_000, 0.02
# Dimension of a mesh in space.
SPATIAL = 3
Floats = NDArray[np.float64]
Singles = NDArray[np.float32]


@dataclass(frozen=True)
class MovedWire:
    """A wire whose motion is recorded, or several that lie one behind the other: a lane.

    Of a line of many tension lengths two or three are near the pantographs at a time. Wires that do
    not overlap share the columns of a row, which would else be mostly of wires at rest.

    Attributes
    ----------
    kind, number
        As in a result: "contact_wire", "messenger_wire", "auxiliary_wire", "stitch_wire", "bridle",
        and its number among those, from 1; where there are several wires, that of the lane.
        All stitch wires of a tension length are one here, and so are its bridles.
    nodes
        Nodes of the mesh, in their order along the wires.
    parts
        Numbers of these nodes in a result, a range for each wire.
    count
        Number of nodes in a row.
    """

    kind: str
    number: int
    nodes: NDArray[np.int64] = field(repr=False)
    parts: tuple[range, ...] = field(repr=False)
    count: int

    @property
    def name(self) -> str:
        """Kind and number: "contact_wire 1"."""
        return f"{self.kind} {self.number}"


@dataclass(frozen=True)
class MotionLayout:
    """Layout of a row of motion.

    Attributes
    ----------
    every
        Steps from one row to the next.
    behind_m
        Distance behind the last pantograph at which a row begins, m.
    wires
        The wires, whose columns stand one behind the other.
    dropper_order
        Droppers in the order along the track.
    dropper_count
        Number of them in a row.
    spatial
        Whether there is motion across the track.
    """

    every: int
    behind_m: float
    wires: tuple[MovedWire, ...]
    dropper_order: NDArray[np.int64] = field(repr=False)
    dropper_count: int
    spatial: bool

    @property
    def columns(self) -> int:
        """Number of nodes in a row, of all wires."""
        return sum(wire.count for wire in self.wires)

    @property
    def numbers_in_row(self) -> int:
        """Number of single-precision numbers in a row."""
        return self.columns * (2 if self.spatial else 1) + self.dropper_count

    def plan(self, found: "Equilibrium") -> MotionPlan:
        """Return the layout as the core takes it."""
        mesh = found.mesh
        droppers = [mesh.droppers[i] for i in self.dropper_order]
        return MotionPlan(
            every=self.every,
            behind=self.behind_m,
            wires=[
                Stations(
                    of=wire.nodes.tolist(),
                    # Along a bridle that hangs down, x may turn back by a rounding.
                    x=np.maximum.accumulate(found.positions[wire.nodes, 0]).tolist(),
                    in_row=wire.count,
                )
                for wire in self.wires
            ],
            links=Stations(
                of=[dropper.link for dropper in droppers],
                x=[dropper.x for dropper in droppers],
                in_row=self.dropper_count,
            ),
        )

    def split(self, raw: dict[str, Any]) -> "dict[str, NDArray[Any]]":
        """Return the rows of a record as variables of a result; see `dataset.schema`."""
        rows = len(raw["motion_time"])
        values = raw["motion"].reshape(rows, self.numbers_in_row)
        first = raw["motion_first"].reshape(rows, len(self.wires) + 1).astype(np.int64)
        columns = self.columns
        out = {
            "motion_up": values[:, :columns],
            "motion_first": first[:, :-1],
            "motion_dropper_force": values[:, len(values[0]) - self.dropper_count :]
            if rows
            else np.zeros((0, self.dropper_count), np.float32),
            "motion_dropper_first": first[:, -1],
        }
        if self.spatial:
            out["motion_across"] = values[:, columns : 2 * columns]
        if not self.dropper_count:
            del out["motion_dropper_force"], out["motion_dropper_first"]
        return out

    @property
    def variables(self) -> "dict[str, NDArray[np.int64]]":
        """Variables of a result that do not change from row to row."""
        counts = np.array([wire.count for wire in self.wires], np.int64)
        order = {"motion_dropper_order": self.dropper_order} if self.dropper_count else {}
        return {"motion_count": counts, **order, **self._lanes}

    @property
    def _lanes(self) -> "dict[str, NDArray[np.int64]]":
        """Lanes of the nodes of each kind that has several wires, as variables of a result."""
        found = {}
        for kind in dict.fromkeys(wire.kind for wire in self.wires):
            lanes = [wire for wire in self.wires if wire.kind == kind]
            if sum(len(lane.parts) for lane in lanes) == 1:
                continue
            numbers = np.zeros(sum(len(lane.nodes) for lane in lanes), np.int64)
            for lane in lanes:
                for part in lane.parts:
                    numbers[part.start : part.stop] = lane.number
            found[f"{kind}_node_lane"] = numbers
        return found

    @property
    def labels(self) -> dict[str, list[str]]:
        """Labels of the wires."""
        return {"motion_wire": [wire.name for wire in self.wires]}


@dataclass(frozen=True)
class MotionPiece:
    """A piece of a run as a viewer is handed it while the run steps.

    Attributes
    ----------
    attempt
        Counted from 1: a higher number begins the run again, after a static force that did not give
        the mean force asked for.
    searching
        True while the static force is searched for: another attempt may follow this one.
    found
        The line at rest, from which displacements are measured.
    layout
        Layout of the rows.
    time_s
        Times of the n rows, s.
    first
        (n, wires) number of the first node of each wire.
    up_m, across_m
        (n, columns) displacement from rest, m, upwards and to the left; None in the plane.
    dropper_first
        (n) place in `layout.dropper_order` of the first dropper.
    dropper_force_N
        (n, droppers) tension, N; 0 is slack.
    contact_time_s
        Times of the k rows of contacts, s.
    position_m, contact_force_N, contact_height_m
        (k, pantographs); the height is NaN where there is no wire.
    mass_displacement_m
        (k, pantographs, masses) since the start, NaN where a pantograph has fewer than another.
    """

    attempt: int
    searching: bool
    found: "Equilibrium"
    layout: MotionLayout
    time_s: Floats
    first: NDArray[np.int64]
    up_m: Singles
    across_m: Singles | None
    dropper_first: NDArray[np.int64]
    dropper_force_N: Singles  # noqa: N815
    contact_time_s: Floats
    position_m: Floats
    contact_force_N: Floats  # noqa: N815
    contact_height_m: Floats
    mass_displacement_m: Floats


def layout_of(
    found: "Equilibrium", scenario: "Scenario", motion: RecordedMotion | None = None
) -> MotionLayout:
    """Return the layout of the motion that a run records of its line.

    Parameters
    ----------
    found
        The line at rest.
    scenario
        The scenario.
    motion
        Interval and window; without them those of the scenario or, for a viewer of a run that
        records none, the usual ones.
    """
    return _layout(found.mesh, found.positions[:, 0], scenario, motion)


def _layout(
    mesh: "Mesh", x: Floats, scenario: "Scenario", motion: RecordedMotion | None
) -> MotionLayout:
    """Return the layout for nodes at positions x along the track, m; see `layout_of`."""
    steps = trajectory.motion(scenario).steps
    motion = motion or scenario.output.motion or RecordedMotion()
    window = nearby(scenario, mesh, steps)
    limits = [motion.around] if not isinstance(motion.around, str) else []
    # Wires that all pantographs have left so far behind are put to rest, see `output.around`.
    limits += [window.around] if window is not None else []
    behind = min(limits) if limits else float(x.max()) + 1.0
    distance = max(placement.distance for placement in scenario.pantographs)
    reach = np.inf if not limits else 2.0 * behind + distance
    wires = [
        wire for kind, pieces in wires_of(mesh).items() for wire in _lanes(kind, pieces, x, reach)
    ]
    order, dropper_count = ordered([dropper.x for dropper in mesh.droppers], reach)
    return MotionLayout(
        every=max(1, round(interval_s(scenario, motion) / scenario.time_step_s)),
        behind_m=behind,
        wires=tuple(wires),
        dropper_order=order,
        dropper_count=dropper_count,
        spatial=mesh.dimension == SPATIAL,
    )


def _lanes(kind: str, pieces: list[list[int]], x: Floats, reach: float) -> list[MovedWire]:
    """Return the wires of a kind, those that lie one behind the other as one.

    Parameters
    ----------
    kind
        Kind, as in a result.
    pieces
        Nodes of each wire.
    x
        Positions of all nodes along the track, m.
    reach
        Length of the window, m.
    """
    lanes: list[list[tuple[list[int], range]]] = []
    first = 0
    for nodes in filter(None, pieces):
        part = range(first, first := first + len(nodes))
        begin = float(x[nodes].min())
        # In the order of the wires, so that the nodes of a lane have the order of the result.
        free = (lane for lane in lanes if float(x[lane[-1][0]].max()) < begin)
        lane = next(free, None)
        if lane is None:
            lanes.append(lane := [])
        lane.append((nodes, part))
    return [
        MovedWire(
            kind,
            number,
            all_nodes := np.concatenate([np.array(nodes, np.int64) for nodes, _ in lane]),
            tuple(part for _, part in lane),
            most_within(np.maximum.accumulate(x[all_nodes]), reach),
        )
        for number, lane in enumerate(lanes, start=1)
    ]


def wires_of(mesh: "Mesh") -> dict[str, list[list[int]]]:
    """Return the nodes of each wire by its kind; stitch wires and bridles by tension length."""
    systems = mesh.systems
    return {
        "contact_wire": mesh.contact_wires,
        "messenger_wire": [system.messenger for system in systems],
        "auxiliary_wire": [system.auxiliary for system in systems],
        "stitch_wire": [[n for one in system.stitches for n in one.nodes] for system in systems],
        "bridle": [[n for one in system.bridles for n in one.nodes] for system in systems],
    }


def interval_s(scenario: "Scenario", motion: RecordedMotion) -> float:
    """Return the time between two rows of the motion of a run, s, not yet in whole steps."""
    if not isinstance(motion.interval, str):
        return motion.interval
    return LONG_INTERVAL_S if trajectory.motion(scenario).steps >= LONG else INTERVAL_S


def motion_bytes(scenario: "Scenario", found: "Equilibrium | None" = None) -> int:
    """Return the size of the recorded motion of a run, bytes, before compression.

    Parameters
    ----------
    scenario
        The scenario; where it records no motion, what it would record by `output.motion: true`.
    found
        Its line at rest, where that is known. Otherwise nodes are taken where they are drawn: those
        of a line as built lie some millimetres away, which may be a node more or less in a row.

    Raises
    ------
    MeshError
        The line cannot be divided.
    """
    from arcless.mesh import build_mesh

    motion = scenario.output.motion or RecordedMotion()
    mesh = build_mesh(scenario.line, scenario.stepping) if found is None else found.mesh
    x = mesh.positions[:, 0] if found is None else found.positions[:, 0]
    layout = _layout(mesh, x, scenario, motion)
    rows = -(-trajectory.motion(scenario).steps // layout.every)
    return rows * (4 * layout.numbers_in_row + 8 * (len(layout.wires) + 2))


def piece_of(
    raw: dict[str, Any],
    found: "Equilibrium",
    layout: MotionLayout,
    scenario: "Scenario",
    *,
    masses: Floats,
    attempt: int,
    searching: bool,
) -> MotionPiece:
    """Return a piece of a record as a viewer is handed it; `masses` are their displacements, m."""
    parts = layout.split(raw)
    channels = contacts.channels(raw, len(scenario.pantographs))
    rows = len(raw["motion_time"])
    return MotionPiece(
        attempt=attempt,
        searching=searching,
        found=found,
        layout=layout,
        time_s=raw["motion_time"],
        first=parts["motion_first"],
        up_m=parts["motion_up"],
        across_m=parts.get("motion_across"),
        dropper_first=parts.get("motion_dropper_first", np.zeros(rows, np.int64)),
        dropper_force_N=parts.get("motion_dropper_force", np.zeros((rows, 0), np.float32)),
        contact_time_s=raw["time"],
        position_m=raw["position"].reshape(-1, len(scenario.pantographs)),
        contact_force_N=channels["contact_force"],
        contact_height_m=channels["contact_height"],
        mass_displacement_m=masses,
    )
