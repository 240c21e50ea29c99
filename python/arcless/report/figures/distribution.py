"""Figures of the contact force over the section: histogram and spectrum."""

import numpy as np

from arcless.assess.signals.filter import spectrum
from arcless.report.drawing.bokeh_objects import Model
from arcless.report.drawing.figure import Figure
from arcless.report.drawing.style import DASHES, GREY, add_hover, add_legend, colour, figure, single
from arcless.report.figures.run_data import RunData

BINS = 40
HIGHEST_HZ = 50.0
DECADES = 6


def histogram(scene: RunData) -> Figure:
    """Draw the share of time over contact force, filtered, with the mean and three deviations."""
    low_pass = f"{scene.assessment.low_pass_Hz:g} Hz"
    title = "Contact force in the section; lines: mean, mean ± 3σ"
    fig = figure(title, f"contact force after the {low_pass} low-pass, N", "time, %")
    total, inside = scene.record.bands.total, scene.record.inside
    lowest, highest = float(total[inside].min()), float(total[inside].max())
    edges = np.linspace(lowest, max(highest, lowest + 1.0), BINS + 1)
    entries = []
    for i, numbers in enumerate(scene.assessment.pantographs):
        values = total[inside[:, i], i]
        share = 100.0 * np.histogram(values, edges)[0] / values.size
        columns = {"left": edges[:-1], "right": edges[1:], "top": share, "bottom": 0.0 * share}
        bars = fig.draw("Quad", columns, color=colour(i), fill_alpha=0.35, line_width=0.8)
        tips = [("force", "@left{0.0} to @right{0.0} N"), ("time", "@top{0.00} %")]
        add_hover(fig, [bars], tips)
        entries.append((numbers.name, [bars]))
        for place in (numbers.statistical_min_N, numbers.mean_force_N, numbers.statistical_max_N):
            dash = () if place == numbers.mean_force_N else DASHES
            look = {"line_color": colour(i), "line_dash": dash}
            fig.center.append(Model("Span", location=place, dimension="height", **look))
    numbers_of = scene.assessment.pantographs
    low = min([lowest, *(p.statistical_min_N for p in numbers_of)])
    high = max([highest, *(p.statistical_max_N for p in numbers_of)])
    margin = 0.04 * (high - low) + 1.0
    fig.x_range.start, fig.x_range.end = low - margin, high + margin
    fig.y_range.start = 0.0
    add_legend(fig, entries)
    return fig


def force_spectrum(scene: RunData) -> Figure:
    """Draw the power spectral density of the unfiltered force, the bands and the span passing."""
    fig = figure(
        "Spectrum of the unfiltered contact force in the section",
        "frequency, Hz",
        "power spectral density, N²/Hz",
        logarithmic=True,
    )
    entries, lines, top = [], [], 0.0
    for i, name in enumerate(scene.pantographs):
        values = scene.record.force[scene.record.inside[:, i], i]
        frequency, density = spectrum(values, scene.record.rate_Hz)
        shown = (frequency > 0.0) & (frequency <= HIGHEST_HZ) & (density > 0.0)
        points = {"x": single(frequency[shown]), "y": single(density[shown])}
        line = fig.draw("Line", points, color=colour(i), line_width=1.4)
        lines.append(line)
        top = max(top, float(density[shown].max(initial=0.0)))
        entries.append((name, [line]))
    entries += _frequencies(scene, fig)
    top = top or 1.0
    fig.y_range.start, fig.y_range.end = top / 10.0**DECADES, 3.0 * top
    add_hover(fig, lines, [("frequency", "@x{0.00} Hz"), ("density", "@y{0.00e+0} N²/Hz")])
    add_legend(fig, entries)
    return fig


def _frequencies(scene: RunData, fig: Figure) -> list[tuple[str, list[Model]]]:
    a = scene.assessment
    bands = [a.band_split_Hz, a.low_pass_Hz]
    marks = [(f"{bands[0]:g} and {bands[1]:g} Hz", bands, "dashed", GREY)]
    supports = scene.values("support_x")
    if supports.size > 1:
        passing = a.speed_m_s / float(np.median(np.diff(np.unique(supports))))
        marks.append((f"span passing, {passing:.2f} Hz", [passing], "dotted", colour(7)))
    entries = []
    for label, places, dash, shade in marks:
        lines = fig.draw("VSpan", {"x": places}, color=shade, line_dash=dash, line_width=1.2)
        entries.append((label, [lines]))
    return entries
