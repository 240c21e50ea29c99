"""The initial configuration as one page: side view, plan view, elasticity, and its numbers.

Drawn is what the mesh holds: every wire element by the name of its wire, every dropper between its
two nodes, every bar to its anchor. No type of line has a drawing of its own.
"""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from arcless.equilibrium.initial_configuration import InitialConfiguration
from arcless.mesh import PLANAR
from arcless.report.drawing.bokeh_objects import Model
from arcless.report.drawing.figure import Figure
from arcless.report.drawing.style import GREY, INK, LIGHT, add_hover, add_legend, colour, figure
from arcless.report.figures.track_axis import X_LABEL
from arcless.report.template import render
from arcless.storage.whole_files import write_bytes

Floats = NDArray[np.float64]

ALONG, ACROSS, UP = 0, 1, 2
# A longer line is drawn around its middle: a page of one kilometre has some 0.3 MB of data. In m.
DRAWN = 3000.0
# Width and height in pixels of the inside of the side view on a usual screen.
FRAME_WIDTH, FRAME_HEIGHT = 1000.0, 250.0
SHADES = {
    "contact_wire": 0,
    "messenger_wire": 7,
    "auxiliary_wire": 2,
    "stitch_wire": 1,
    "bridle": 1,
}


def write(found: InitialConfiguration, path: str | Path) -> None:
    """Write the initial configuration as one HTML file that opens without a network.

    Parameters
    ----------
    found
        The initial configuration.
    path
        The file to write; its folder must exist.

    Raises
    ------
    OutputError
        The file cannot be written; nothing half-written stays behind.
    """
    write_bytes(path, html(found).encode())


def html(found: InitialConfiguration) -> str:
    """Return the page of an initial configuration; see `write`."""
    sight = _View(found)
    drawn = {
        "side": sight.view(UP, "Side view", "height above rail, m", 330),
        "plan": sight.view(ACROSS, "Plan view", "across the track, m", 260),
        "elasticity": elasticity(found, sight.track),
    }
    return render(
        "rest.html",
        drawn,
        name=found.scenario.line.name,
        description=found.scenario.line.description,
        facts=facts(found),
        exaggeration=sight.exaggeration,
        cut=sight.cut,
        limits=(f"{sight.begin:.0f}", f"{sight.end:.0f}"),
    )


def facts(found: InitialConfiguration) -> list[tuple[str, str]]:
    """Return the numbers that the page shows."""
    e = 1e3 * np.array(found.elasticity_m_per_N)
    lengths = [dropper["length_m"] for dropper in found.droppers]
    places = found.equilibrium.support_places()
    pairs = [("Line", f"{len(places) - 1} spans, {places[-1] - places[0]:.0f} m")]
    if lengths:
        pairs.append(("Droppers", f"{len(lengths)}, {min(lengths):.3f} to {max(lengths):.3f} m"))
    pairs.append(("Sag in the middle span", f"{1e3 * found.contact_wire_sag_m:.1f} mm"))
    pairs.append(("Elasticity", f"{e.min():.3f} to {e.max():.3f} mm/N"))
    pairs.append(("Non-uniformity", f"{100 * found.elasticity_nonuniformity:.1f} %"))
    if found.wave_speed is not None:
        pairs.append(("Wave speed", f"{3.6 * found.wave_speed:.0f} km/h"))
    return pairs


def elasticity(found: InitialConfiguration, track: Model) -> Figure:
    """Draw the elasticity over the middle span."""
    percent = 100 * found.elasticity_nonuniformity
    title = f"Elasticity of the middle span (non-uniformity {percent:.0f} %)"
    fig = figure(title, X_LABEL, "elasticity, mm/N", height=230, x_range=track)
    points = {"x": found.elasticity_x_m, "y": 1e3 * np.array(found.elasticity_m_per_N)}
    line = fig.draw("Line", points, color=colour(0), line_width=1.6)
    fig.y_range.start = 0.0
    add_hover(fig, [line], [("elasticity", "@y{0.000} mm/N"), ("position", "@x{0.0} m")])
    return fig


class _View:
    """The part of a line that is drawn, and its views from the side and from above."""

    def __init__(self, found: InitialConfiguration) -> None:
        self.found = found
        self.mesh, self.points = found.equilibrium.mesh, found.equilibrium.positions
        left, right = found.equilibrium.middle_span()
        first, last = self.mesh.supports[0].x, self.mesh.supports[-1].x
        middle = 0.5 * (left + right)
        self.cut = last - first > DRAWN
        self.begin = max(first, middle - 0.5 * DRAWN) if self.cut else first
        self.end = min(last, middle + 0.5 * DRAWN) if self.cut else last
        start, stop = left - (right - left), right + (right - left)
        margin = 0.02 * (self.end - self.begin)
        self.track = Model(
            "Range1d",
            start=max(start, self.begin - margin),
            end=min(stop, self.end + margin),
            bounds=(self.begin - margin, self.end + margin),
        )

    @property
    def exaggeration(self) -> float:
        """Scale of heights over lengths in the drawing, on a usual screen, to one digit."""
        heights = self._inside(self.points)[:, UP]
        per_height = FRAME_HEIGHT / max(1e-3, 1.1 * float(np.ptp(heights)))
        ratio = per_height / (FRAME_WIDTH / (self.track.end - self.track.start))
        digits = 10 ** np.floor(np.log10(ratio))
        return float(np.round(ratio / digits) * digits)

    def view(self, axis: int, title: str, y_label: str, height: int) -> Figure | None:
        """Draw the line along the track and one other axis; None if nothing is off that axis."""
        if not np.ptp(self.points[:, axis]) > 0.0:
            return None
        fig = figure(title, X_LABEL, y_label, height=height, x_range=self.track)
        entries = [("support", [self._supports(fig)])]
        entries += [(name, [drawn]) for name, drawn in self._wires(fig, axis)]
        entries += [("dropper", [drawn]) for drawn in self._droppers(fig, axis)]
        entries += [("steady arm", [drawn]) for drawn in self._bars(fig, axis)]
        if axis == ACROSS:
            entries.append(("stagger", [self._staggers(fig)]))
        add_legend(fig, entries)
        return fig

    def _wires(self, fig: Figure, axis: int) -> Iterator[tuple[str, Model]]:
        """Yield each wire's name and its line; elements that do not meet leave a gap."""
        ends = self.mesh.elements["nodes"]
        for index, (field, rows) in enumerate(self.mesh.wire_rows.items()):
            x, y = _chained(ends[rows], self.points, axis, (self.begin, self.end))
            if x.size == 0:
                continue
            name = field.replace("_", " ")
            shade = colour(SHADES.get(field, index + 3))
            drawn = fig.draw("Line", {"x": x, "y": y}, line_width=1.6, color=shade)
            add_hover(fig, [drawn], [(name, "@y{0.000} m"), ("position", "@x{0.0} m")])
            yield name, drawn

    def _droppers(self, fig: Figure, axis: int) -> Iterator[Model]:
        """Yield the droppers, each between the two nodes that it joins."""
        pairs = zip(self.mesh.droppers, self.found.droppers, strict=True)
        kept = [pair for pair in pairs if self.begin <= pair[0].x <= self.end]
        if not kept:
            return
        places, chosen = zip(*kept, strict=True)
        top, bottom = (self.points[[place.nodes[end] for place in places]] for end in (0, 1))
        data = {
            **_between(top, bottom, axis),
            "name": [d["name"] for d in chosen],
            "length": [d["length_m"] for d in chosen],
            "force": [d["force_N"] for d in chosen],
        }
        drawn = fig.draw("Segment", data, color=GREY)
        tips = [("", "@name"), ("length", "@length{0.000} m"), ("force", "@force{0.0} N")]
        add_hover(fig, [drawn], tips)
        yield drawn

    def _bars(self, fig: Figure, axis: int) -> Iterator[Model]:
        """Yield the bars that hold a wire sideways, from the wire to their anchor."""
        nodes = self.mesh.parts["struts"]["node"]
        if len(nodes) == 0:
            return
        anchors = self.found.equilibrium.arrays["strut_anchor"].reshape(len(nodes), -1)
        if anchors.shape[1] == PLANAR:  # along and up
            anchors = np.column_stack([anchors[:, 0], np.zeros(len(nodes)), anchors[:, 1]])
        held = self.points[nodes]
        kept = (held[:, ALONG] >= self.begin) & (held[:, ALONG] <= self.end)
        yield fig.draw(
            "Segment", _between(held[kept], anchors[kept], axis), color=INK, line_width=2
        )

    def _supports(self, fig: Figure) -> Model:
        places = [s.x for s in self.mesh.supports if self.begin <= s.x <= self.end]
        return fig.draw("VSpan", {"x": places}, color=LIGHT, line_dash="dashed")

    def _staggers(self, fig: Figure) -> Model:
        """Mark the contact wire at the supports."""
        places = [s for s in self.mesh.supports if self.begin <= s.x <= self.end]
        points = self.points[[place.contact_node for place in places]]
        data = {
            "x": points[:, ALONG],
            "y": points[:, ACROSS],
            "name": [place.name for place in places],
        }
        drawn = fig.draw("Scatter", data, size=6, color=colour(0), line_color=None)
        add_hover(fig, [drawn], [("", "@name"), ("stagger", "@y{0.000} m"), ("at", "@x{0.0} m")])
        return drawn

    def _inside(self, points: Floats) -> Floats:
        kept: Floats = points[(points[:, ALONG] >= self.begin) & (points[:, ALONG] <= self.end)]
        return kept


def _between(one: Floats, other: Floats, axis: int) -> dict[str, Floats]:
    """Return the ends of straight pieces as columns."""
    return {
        "x0": one[:, ALONG], "y0": one[:, axis], "x1": other[:, ALONG], "y1": other[:, axis],
    }  # fmt: skip


def _chained(
    ends: NDArray[np.int64], points: Floats, axis: int, limits: tuple[float, float]
) -> tuple[Floats, Floats]:
    """Return elements as one line: where an element does not begin at the last one's end, a gap."""
    middle = points[ends].mean(axis=1)[:, ALONG]
    ends = ends[(middle >= limits[0]) & (middle <= limits[1])]
    if len(ends) == 0:
        return np.empty(0), np.empty(0)
    breaks = np.flatnonzero(ends[1:, 0] != ends[:-1, 1]) + 1
    x, y = [], []
    for piece in np.split(ends, breaks):
        nodes = np.append(piece[:, 0], piece[-1, 1])
        x.append(np.append(points[nodes, ALONG], np.nan))
        y.append(np.append(points[nodes, axis], np.nan))
    return np.concatenate(x), np.concatenate(y)
