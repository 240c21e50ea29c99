"""Mesh → static equilibrium, with errors in the words of the line."""

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from itertools import pairwise
from math import isfinite
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless import _core
from arcless.equilibrium.design_failures import check_arms
from arcless.equilibrium.failure_hints import check_carried, why_loose, why_pushing
from arcless.equilibrium.line_alone import LineAlone
from arcless.equilibrium.sliding_ends import SlidingEnds, undecided
from arcless.errors import ArclessError, EquilibriumError, NotConvergedError
from arcless.mesh import SPATIAL, Mesh, alteration, build_mesh, end_forces, without
from arcless.model import Line, Scenario
from arcless.model.as_built.measured_heights import matched
from arcless.model.settings import schemes
from arcless.model.settings.run_settings import Solver

Floats = NDArray[np.float64]

# Half a metre resolves the elasticity between droppers, which are some metres apart. In m.
ELASTICITY_SPACING = 0.5
FREQUENCIES = 20
# Runs of a batch ask for the elasticity at the same places; so many answers are kept.
MOST_KEPT = 50
# A strip lifts the lowest wire by 100 N times 0.2 to 0.5 mm/N, and so reaches wires that hang this
# much higher. In m.
REACH = 0.02
# Friction of tensioning devices: bound on the rounds, two or three are normal.
MOST_ROUNDS = 8
# Kinds of the core's errors for a line that has no shape at rest.
NO_SHAPE = ("singular", "unstable", "equilibrium")


@dataclass(frozen=True)
class Equilibrium:
    """A line at rest: its mesh, the core's equilibrium, and the arrays read from it (SI units)."""

    mesh: Mesh
    core: _core.Equilibrium
    arrays: dict[str, Floats]
    _found: dict[tuple[bytes, float], Floats] = field(default_factory=dict, repr=False)

    @property
    def positions(self) -> Floats:
        """Node positions (n × 3) in m: along, across, up."""
        points = self.arrays["positions"].reshape(-1, self.mesh.dimension)
        if self.mesh.dimension == SPATIAL:
            return points
        return np.column_stack([points[:, 0], np.zeros(len(points)), points[:, 1]])

    def of_droppers(self, name: str) -> Floats:
        """Read a value of each dropper, in the order of the droppers."""
        rows = [dropper.link for dropper in self.mesh.droppers]
        return self.arrays[name][rows]

    def elasticity(self, x: Floats, force: float = 0.0) -> Floats:
        """Return elasticities in m/N at positions x in m, for a force in N (0: a small one).

        Of wires side by side, that with all of them lifted together which hang at one height.
        """
        return self.elasticities([x], force)[0]

    def elasticities(self, places: Sequence[Floats], force: float = 0.0) -> list[Floats]:
        """Return the elasticity in m/N at several sets of positions in m, asked for at once.

        The stiffness of the line is factorised once for all of them that are not known yet.
        """
        keys = [(x.tobytes(), force) for x in places]
        # Key by key: runs in other threads share what is kept.
        found = {key: kept for key in keys if (kept := self._found.get(key)) is not None}
        missing = {key: x for key, x in zip(keys, places, strict=True) if key not in found}
        if missing:
            together = self._elasticity(np.concatenate(list(missing.values())), force)
            ends = np.cumsum([len(x) for x in missing.values()])[:-1]
            for key, part in zip(missing, np.split(together, ends), strict=True):
                found[key] = part
                if len(self._found) < MOST_KEPT:
                    self._found[key] = part
        return [found[key].copy() for key in keys]

    def _elasticity(self, x: Floats, force: float) -> Floats:
        found = np.zeros(len(x))
        within = self._within_reach(x)
        # By hand: `np.unique` imports masked arrays, which takes longer than all of this.
        for lanes in sorted(set(map(tuple, within.tolist()))):
            here = np.flatnonzero((within == lanes).all(axis=1))
            if sum(lanes) > 1:  # at their anchors, where none yields, the core finds no shares
                anchors = self._anchors
                here = here[[place not in anchors for place in x[here].tolist()]]
            touched = [lane for lane, is_in in zip(self.mesh.lanes, lanes, strict=True) if is_in]
            with named(self.mesh):
                found[here] = self.core.elasticity(touched, x[here].tolist(), force)
        return found

    @property
    def _anchors(self) -> set[float]:
        """Positions in m at which contact wires are held, so that their elasticity is zero."""
        fixed = self.mesh.parts["fixed"]
        held = set(fixed["node"][fixed["component"] == self.mesh.dimension - 1].tolist())
        ends = {wire[end] for wire in self.mesh.contact_wires for end in (0, -1)}
        return {float(self.positions[node, 0]) for node in ends & held}

    def _within_reach(self, x: Floats) -> NDArray[np.bool_]:
        """Tell for each position and lane whether a strip below touches its wire."""
        heights = self._lane_heights(x)
        lowest = heights.min(axis=1, keepdims=True)
        within: NDArray[np.bool_] = heights <= lowest + REACH
        # Nothing is touched beyond the ends: the core refuses such positions.
        within[~np.isfinite(lowest[:, 0]), 0] = True
        return within

    def lowest_heights(self, x: Floats) -> Floats:
        """Return heights in m of the lowest contact wire at x in m, infinite off the ends."""
        return np.asarray(self._lane_heights(x).min(axis=1))

    def _lane_heights(self, x: Floats) -> Floats:
        """Return heights in m at positions (rows) of each lane, infinite where there is no wire."""
        return np.column_stack([self._heights(lane, x) for lane in self.mesh.lanes])

    def _heights(self, lane: list[int], x: Floats) -> Floats:
        """Return heights in m at positions of the wires of a lane, infinite where there is none."""
        nodes = self.mesh.elements["nodes"][lane]
        ends = self.positions[nodes]
        row = np.clip(np.searchsorted(ends[:, 1, 0], x), 0, len(lane) - 1)
        (left, _, low), (right, _, high) = ends[row, 0].T, ends[row, 1].T
        share = (x - left) / (right - left)
        return np.where((left <= x) & (x <= right), low + share * (high - low), np.inf)

    def frequencies(self, count: int = FREQUENCIES) -> Floats:
        """Return the lowest natural frequencies in Hz, ascending."""
        with named(self.mesh):
            return np.array(self.core.frequencies(count))

    def lanes_at(self, x: float) -> list[list[int]]:
        """Return the lanes whose wires a strip below touches at a position in m."""
        within = self._within_reach(np.array([x]))[0]
        return [lane for lane, is_in in zip(self.mesh.lanes, within, strict=True) if is_in]

    def wave_speed(self) -> float:
        """Return the lowest wave speed of the contact wire in m/s: √(tension / mass per metre)."""
        tension = self.arrays["wire_tension"][self.mesh.contact_rows]
        return float(np.sqrt(np.min(tension / self.arrays["wire_mass"][self.mesh.contact_rows])))

    def mean_tensions(self) -> tuple[float, float | None]:
        """Return the mean tensions of contact and messenger wire over the whole line, in N."""
        tension = self.arrays["wire_tension"]
        is_contact = np.zeros(len(tension), dtype=bool)
        is_contact[self.mesh.contact_rows] = True
        contact = float(tension[is_contact].mean())
        return contact, float(tension[~is_contact].mean()) if self.mesh.messenger_nodes else None

    def end_travel(self, end: int = -1) -> tuple[float, float | None]:
        """Return the travel of the far (0: near) ends of contact and messenger wire in m.

        Of several tension lengths, that of the one that moved furthest.
        """
        contact = self._travel([wire[end] for wire in self.mesh.contact_wires])
        messengers = [system.messenger[end] for system in self.mesh.systems if system.messenger]
        return contact, self._travel(messengers) if messengers else None

    def _travel(self, nodes: list[int]) -> float:
        ways = self.positions[nodes, 0] - self.mesh.positions[nodes, 0]
        return float(max(ways, key=abs))

    def support_places(self) -> list[float]:
        """Return the positions of the supports in m, each once."""
        return sorted({support.x for support in self.mesh.supports})

    def middle_span(self, length: float | None = None) -> tuple[float, float]:
        """Return the supports in m of the span in the middle, or of the nearest one in no overlap.

        With a length in m to the millimetre, of the spans of that length.
        """
        spans = list(pairwise(self.support_places()))
        middle = (len(spans) - 1) // 2
        by_distance = sorted(range(len(spans)), key=lambda index: abs(index - middle))
        if length is not None:
            lengths = [round(right - left, 3) for left, right in spans]
            by_distance = [index for index in by_distance if lengths[index] == length]
        alone = (index for index in by_distance if not self._overlaps(*spans[index]))
        return spans[next(alone, by_distance[0])]

    def _overlaps(self, left: float, right: float) -> bool:
        """Return whether wires of two tension lengths run between two places."""
        x, middle = self.mesh.positions[:, 0], 0.5 * (left + right)
        wires = [next(iter(own.contact.values())) for own in self.mesh.systems]
        ends = [(x[wire[0]], x[wire[-1]]) for wire in wires]
        return sum(bool(first < middle < last) for first, last in ends) > 1

    def elasticity_positions(self, left: float | None = None, right: float | None = None) -> Floats:
        """Return the positions in m along a span at which the elasticity is reported.

        Parameters
        ----------
        left, right
            Ends of the span in m; without them it is the middle one.
        """
        if left is None or right is None:
            left, right = self.middle_span()
        count = max(2, round((right - left) / ELASTICITY_SPACING) + 1)
        return np.linspace(left, right, count)


def find(scenario: Scenario | LineAlone, near: Equilibrium | None = None) -> Equilibrium:
    """Find the static equilibrium of a scenario's line, or of a line alone as it was designed.

    Parameters
    ----------
    scenario
        The scenario, or the line alone.
    near
        Equilibrium of a line that differs little, as designed: the search begins there, and ends
        by the same bounds. Forces differ by rounding alone, some 1e-4 N; it takes half of the time
        or less. A line of other elements is found as without it.

    Raises
    ------
    MeshError
        The line cannot be divided as asked.
    EquilibriumError
        There is no equilibrium, or it was not found.
    """
    given = scenario.as_built.measured_heights
    heights = matched(scenario.line, given) if given else {}
    known = None if near is None else near.core
    mesh, core = designed(scenario.line, scenario.stepping, heights, known)
    if isinstance(scenario, Scenario) and not scenario.as_built.is_empty:
        mesh, core = _as_built(scenario, mesh, core)
    return Equilibrium(mesh, core, core.arrays())


def designed(
    line: Line,
    solver: Solver,
    heights: Mapping[float, float],
    near: _core.Equilibrium | None = None,
) -> tuple[Mesh, _core.Equilibrium]:
    """Find the shape that a line was designed for.

    Parameters
    ----------
    line
        The line.
    solver
        Elements and scheme, no words left in it.
    heights
        Measured heights in m by place in m, instead of those drawn.
    near
        See `find`.

    Raises
    ------
    MeshError, EquilibriumError
        As `find`.
    """
    mesh = build_mesh(line, solver, heights)
    check_carried(line, mesh.gravity)
    with _designed(mesh, line, heights):
        core = _core.Equilibrium(
            dimension=mesh.dimension,
            positions=mesh.positions,
            slopes=mesh.slopes,
            parts=mesh.parts,
            gravity=mesh.gravity,
            design=True,
            residual_flexibility=bool(solver.residual_flexibility),
            fitted_bends=solver.scheme.name == schemes.EXPLICIT,
            across_only=solver.motion == "across",
            **({} if near is None else {"near": near}),
        )
    check_arms(mesh, line, core.arrays()["strut_tension"])
    return mesh, core


def _as_built(
    scenario: Scenario, mesh: Mesh, core: _core.Equilibrium
) -> tuple[Mesh, _core.Equilibrium]:
    """Change a designed line into the line as built and in the weather."""
    changes = alteration(mesh, scenario.line, scenario.as_built)
    lengths = core.arrays()["link_rest_length"] * changes["link_factor"] + changes["link_offset"]
    for dropper in mesh.droppers:
        if lengths[dropper.link] <= 0.0:
            raise EquilibriumError(
                f"as_built.dropper_length_errors: {dropper.name} has no length left",
                where=f"{dropper.x:.2f} m",
                got=f"{1e3 * lengths[dropper.link]:.0f} mm",
                expected="a designed length that is longer than the error takes away",
            )
    with named(mesh):
        altered = _found_again(mesh, scenario, core, changes)
    return without(mesh, changes["removed"]), altered


def _found_again(
    mesh: Mesh, scenario: Scenario, core: _core.Equilibrium, changes: dict[str, Any]
) -> _core.Equilibrium:
    """Change a structure, and again while devices with friction follow from the tension found."""
    ends = SlidingEnds(mesh, scenario.line)
    altered = core.altered(changes)
    if not ends.are_there:
        return altered
    for _ in range(MOST_ROUNDS):
        moved = ends.renew(altered.arrays())
        changes["end_force"] = end_forces(mesh, ends.tensions)
        if not moved:
            return altered
        altered = core.altered(changes)
    if ends.renew(altered.arrays()):
        raise undecided(MOST_ROUNDS)
    return altered


@contextmanager
def _designed(mesh: Mesh, line: Line, heights: Mapping[float, float]) -> Iterator[None]:
    """Find the designed shape, see `named`; look further for why there is no equilibrium."""
    try:
        yield
    except _core.NativeError as error:
        kind, message, details = error.args
        found = translate(mesh, kind, message, details)
        if kind == "pushing":
            found.hint = why_pushing(mesh, line, heights, details["link"]) or found.hint
        elif kind in NO_SHAPE:
            found.hint = why_loose(line, mesh.gravity) or found.hint
        raise found from error


@contextmanager
def named(mesh: Mesh) -> Iterator[None]:
    """Turn errors of the core into errors that name the place on the line."""
    try:
        yield
    except _core.NativeError as error:
        kind, message, details = error.args
        raise translate(mesh, kind, message, details) from error


def place_of(mesh: Mesh, node: int) -> str:
    """Say in words where a node is."""
    x = mesh.positions[node, 0]
    for system in mesh.systems:
        wires = {
            **system.contact,
            "auxiliary wire": system.auxiliary,
            "messenger wire": system.messenger,
            "stitch wire": [n for stitch in system.stitches for n in stitch.nodes[1:-1]],
            "bridle": [n for bridle in system.bridles for n in bridle.nodes[1:-1]],
        }
        for wire, nodes in wires.items():
            if node in nodes:
                of = f" of {system.label}" if system.label else ""
                return f"{wire}{of} at {x:.2f} m"
    return f"messenger wire at {x:.2f} m"


def translate(mesh: Mesh, kind: str, message: str, details: dict[str, Any]) -> ArclessError:
    """Say an error of the core in the words of the line."""
    if kind == "pushing":
        dropper = next(d for d in mesh.droppers if d.link == details["link"])
        return EquilibriumError(
            f"{dropper.name} would have to push to hold the {dropper.wires[1]} at its height",
            where=f"{dropper.x:.2f} m",
            got=f"a force of {details['force']:.1f} N",
            expected="a tension",
            hint=f"the heights bend the {dropper.wires[1]} there more sharply than its weight"
            " does: try a smaller pre-sag of this dropper, or larger ones next to it",
        )
    if kind == "singular":
        return EquilibriumError(
            "the line is loose",
            where=place_of(mesh, details["node"]),
            got="a place that any small push moves away",
            expected="a wire under tension, with what holds it",
            hint="check tension and bending_stiffness of this wire, and at support,"
            " contact_support and steady_arm",
        )
    if kind == "unstable":
        return EquilibriumError(
            "the static equilibrium is unstable",
            got=f"{details['directions']} directions in which a small push moves the line away",
            hint="look for steady arms that push (stagger, curves, steady_arm.slope), and for"
            " droppers whose lengths are longer than the wires are apart",
        )
    if kind == "equilibrium":
        return _not_found(mesh, details)
    return NotConvergedError(message)


def _not_found(mesh: Mesh, details: dict[str, Any]) -> NotConvergedError:
    """Say that Newton's method ended without an equilibrium, by its bound or without numbers."""
    after = f"after {details['iterations']} iterations"
    what, hint = "no static equilibrium was found", "check tensions, masses and dropper lengths"
    if not isfinite(details["residual"]):
        return NotConvergedError(
            what,
            got=f"a shape that grows beyond all bounds {after}",
            expected="tensions that carry the wires within the encumbrance",
            hint=f"{hint}, and their units: kN for N, m for mm",
        )
    return NotConvergedError(
        what,
        where=place_of(mesh, details["node"]),
        got=f"{details['residual']:.3g} N out of balance {after}",
        expected=f"at most {details['tolerance']:.2g} N",
        hint=f"{hint} around that place",
    )
