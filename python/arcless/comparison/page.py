"""Comparison → one HTML page: what was run, what differs, verdicts, differences, overlays."""

from collections.abc import Mapping, Sequence
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path
from typing import Any

from arcless.comparison.compared import Compared
from arcless.comparison.content import comparison_content
from arcless.comparison.subjects.sides import drawn
from arcless.figures.comparison import Overlaid
from arcless.figures.description import Figure
from arcless.figures.description.thinning import every
from arcless.figures.run.track import MARKS
from arcless.report.template import render
from arcless.storage.whole_files import write_bytes


def write(compared: Compared, figures: Mapping[str, Sequence[Figure]], path: str | Path) -> None:
    """Write the page of a comparison: one HTML file that opens without a network.

    Parameters
    ----------
    compared
        The comparison.
    figures
        Its overlays by their keys.
    path
        The file to write; its folder must exist.
    """
    write_bytes(path, html(compared, figures).encode())


def html(compared: Compared, figures: Mapping[str, Sequence[Figure]]) -> str:
    """Return the page of a comparison as one HTML text; see `write`."""
    content = comparison_content(compared, figures)
    contents = [("summary", "Summary"), *((key, title) for key, title, *_ in content["sections"])]
    contents += [("bands", "Bands")] if content["bands"] else []
    contents += [("acceptance", "Simulation against line test")] if content["acceptance"] else []
    contents += [("numbers", "Numbers"), ("criteria", "Criteria")]
    contents += [("fields", "Changed fields")] if content["simulated"] > 1 else []
    return render(
        "comparison.html",
        figures,
        track=_track(compared),
        colours=[Overlaid((), ()).colour(k).replace("_", "-") for k in range(len(compared.names))],
        contents=contents,
        version=version("arcless"),
        date=f"{datetime.now(UTC):%Y-%m-%d %H:%M}",
        **content,
    )


def _track(compared: Compared) -> dict[str, Any]:
    """Return section and supports of the first run in m, for buttons and the cross hair."""
    run = drawn(compared.sides)[0]
    supports = run.supports[every(run.supports.size, MARKS)] if run.supports.size else run.supports
    return {
        "section": [float(end) for end in run.assessment.section_m],
        "supports": [round(float(x), 2) for x in supports],
    }
