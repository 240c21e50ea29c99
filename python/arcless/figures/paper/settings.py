"""Settings of matplotlib that hold while a figure is drawn or saved, and sizes in points."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

# DejaVu Sans comes with matplotlib: lengths of texts are the same on every machine.
_FONTS = ["DejaVu Sans", "sans-serif"]
_SETTINGS: dict[Any, Any] = {
    "font.family": _FONTS,
    "svg.fonttype": "none",  # text stays text, to be searched and edited
    "svg.hashsalt": "arcless",  # ids of an SVG are drawn at random without one
    "pdf.fonttype": 42,
    "lines.scale_dashes": False,
    "text.hinting": "none",  # texts as long at any number of dots
    "path.simplify": True,
}

# Points of paper for a pixel of a page: of lines and marks, and of texts.
LINE, MARK, TEXT = 0.68, 0.6, 0.72
TITLE_PT, LABEL_PT, TICK_PT, CAPTION_PT = 9.0, 8.0, 7.5, 7.5
# Width of axes, ticks and grid.
THIN_PT = 0.6


@contextmanager
def settings() -> Iterator[None]:
    """Let the settings hold in a block, over matplotlib's own; those of the user come back."""
    import matplotlib as mpl

    with mpl.rc_context():
        mpl.rcdefaults()
        mpl.rcParams.update(_SETTINGS)
        yield
