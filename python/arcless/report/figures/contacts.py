"""Shares of a pantograph's force between its wires and strips."""

from arcless.assess.signals.filter import low_pass, sample_rate_Hz
from arcless.report.drawing.figure import Figure
from arcless.report.drawing.style import add_legend, colour, plain
from arcless.report.figures.run_data import RunData
from arcless.report.figures.track_axis import (
    SMOOTH_POINTS,
    hover,
    series,
    support_entry,
    track_figure,
)


def shares(scene: RunData) -> Figure | None:
    """Draw the filtered force of each contact, where a pantograph has several."""
    if not scene.has("wire_contact_force"):
        return None
    limit = scene.assessment.low_pass_Hz
    title = f"Force of each wire on each strip after the {limit:g} Hz low-pass"
    fig = track_figure(scene, title, "contact force, N")
    names = [str(name) for name in scene.values("contact")]
    forces = low_pass(
        scene.values("wire_contact_force"), sample_rate_Hz(scene.values("time")), limit
    )
    points = SMOOTH_POINTS * len(scene.pantographs) // max(1, len(names))
    entries, lines = [], []
    for i, name in enumerate(names):
        path = series(scene, _pantograph(scene, name), forces[:, i], points)
        line = fig.draw("Line", path, color=colour(i), line_width=1.4, name=plain(name))
        entries.append((name, [line]))
        lines.append(line)
    add_legend(fig, [*entries, *support_entry(scene, fig)])
    hover(fig, lines, "force", "0.0 N")
    return fig


def _pantograph(scene: RunData, contact: str) -> int:
    """Return the number of the pantograph that a contact is named after."""
    owners = [i for i, name in enumerate(scene.pantographs) if contact.startswith(f"{name} strip ")]
    return max(owners, key=lambda i: len(scene.pantographs[i]))
