"""Sensitivity of a study's outputs, as a table and a figure for each output."""

from typing import Any

from arcless.report.drawing.bokeh_objects import Field, Model, columns
from arcless.report.drawing.figure import Figure
from arcless.report.drawing.style import add_hover, add_legend, colour, figure, plain
from arcless.study.report.record import Record
from arcless.study.report.tables import number

# Column of the table → key of its value, and of the half width of its interval.
_SOBOL = {"first order": ("first", "first_interval"), "total": ("total", "total_interval")}
_MORRIS = {
    "mean effect μ": ("mu", None),
    "mean size μ*": ("mu_star", "mu_star_interval"),
    "deviation σ": ("sigma", None),
}


def sections(record: Record) -> list[dict[str, Any]]:
    """Return a table and a figure for every output; nothing for other designs."""
    found = record.findings["sensitivity"]
    if found is None:
        return []
    sobol = found["method"] == "sobol-indices"
    keys: dict[str, tuple[str, str | None]] = {**(_SOBOL if sobol else _MORRIS)}
    result = []
    for name, output in found["outputs"].items():
        values = output["indices"]
        lines = []
        for variable, one in (values or {}).items():
            lines.append((variable, [_cell(one, *pair) for pair in keys.values()]))
            lines += [
                (f"{variable} with {other}", [_cell(pair, "second", "second_interval"), ""])
                for other, pair in one.get("pairs", {}).items()
            ]
        result.append(
            {
                "output": name,
                "sobol": sobol,
                "blocks": output["blocks"],
                "left_out": output["left_out"],
                "why": output.get("why", ""),
                "titles": list(keys),
                "lines": lines,
                "figure": _figure(name, values, sobol=sobol) if values else None,
            }
        )
    return result


def _cell(one: dict[str, Any], key: str, interval: str | None) -> str:
    half = "" if interval is None else f" ± {number(_short(one[interval]))}"
    return f"{number(_short(one[key]))}{half}"


def _short(value: float | None) -> float | None:
    return None if value is None else float(f"{value:.3g}")


def _figure(output: str, values: dict[str, Any], *, sobol: bool) -> Figure:
    if not sobol:
        return _plane(output, values)
    names = [plain(name) for name in values]
    fig = figure(
        plain(f"Share of the variance of {output}"), "index", "",
        height=90 + 34 * len(names), names=names[::-1],
    )  # fmt: skip
    entries = []
    for place, (title, (key, interval)) in enumerate(_SOBOL.items()):
        middles = [one[key] for one in values.values()]
        halves = [one[interval] or 0.0 for one in values.values()]
        data = {
            "x": middles,
            "low": [m - h for m, h in zip(middles, halves, strict=True)],
            "high": [m + h for m, h in zip(middles, halves, strict=True)],
            "y": [(name, 0.12 - 0.24 * place) for name in names],
        }
        source, ends = columns(data), ("low", "y", "high", "y")
        bar = fig.draw("Segment", source, *ends, color=colour(place), line_width=2)
        dot = fig.draw("Scatter", source, color=colour(place), size=8)
        add_hover(fig, [dot], [(title, "@x{0.000} (@low{0.000} to @high{0.000})")])
        entries.append((title, [bar, dot]))
    add_legend(fig, entries)
    return fig


def _plane(output: str, values: dict[str, Any]) -> Figure:
    fig = figure(plain(f"Effects on {output}"), "mean size of effects μ*", "deviation σ")
    source = columns(
        {
            "x": [one["mu_star"] for one in values.values()],
            "y": [one["sigma"] for one in values.values()],
            "name": [plain(name) for name in values],
        }
    )
    dots = fig.draw("Scatter", source, color=colour(0), size=9)
    place = {"x": Field("x"), "y": Field("y"), "x_offset": 7, "y_offset": 4}
    labels = Model("LabelSet", source=source, text=Field("name"), text_font_size="12px", **place)
    fig.center.append(labels)
    add_hover(fig, [dots], [("", "@name"), ("μ*", "@x{0.[000]}"), ("σ", "@y{0.[000]}")])
    return fig
