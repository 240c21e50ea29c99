"""Sensitivity of a study's outputs, as a table and a figure for each output."""

from typing import Any

from arcless.study.report import wording
from arcless.study.report.data.numbers import digits
from arcless.study.report.data.record import Record
from arcless.study.report.figures.indices import SOBOL, effects, shares

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
    keys: dict[str, tuple[str, str | None]] = {**(SOBOL if sobol else _MORRIS)}
    result = []
    headings = {column.name: column.heading for column in record.outputs}
    for place, (name, output) in enumerate(found["outputs"].items(), start=1):
        draw = shares if sobol else effects
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
                "output": headings[name],
                "sobol": sobol,
                "blocks": wording.blocks(
                    output["blocks"], output["left_out"], output.get("why", "")
                ),
                "titles": list(keys),
                "lines": lines,
                "figure": draw(f"output-{place}", headings[name], values) if values else None,
            }
        )
    return result


def _cell(one: dict[str, Any], key: str, interval: str | None) -> str:
    half = "" if interval is None else f" ± {digits(_short(one[interval]))}"
    return f"{digits(_short(one[key]))}{half}"


def _short(value: float | None) -> float | None:
    return None if value is None else float(f"{value:.3g}")
