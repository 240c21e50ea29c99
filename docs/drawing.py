"""Look of the figures that programs of docs draw: colours of the reports, and files that repeat."""

from pathlib import Path
from typing import Any

import matplotlib as mpl

from arcless.figures.description.tokens import colour

BLUE, ORANGE, GREEN, PURPLE = (colour(f"series_{number}") for number in range(1, 5))
GREY, SUPPORT = colour("soft"), colour("support")


def set_up() -> None:
    """Let text stay text in an SVG, and the ids in it repeat."""
    mpl.rcParams.update({"svg.hashsalt": "arcless", "svg.fonttype": "none", "font.size": 9})


def save(figure: Any, file: str | Path) -> None:
    """Write a figure; without a date and with fixed ids, the same numbers give the same file."""
    figure.savefig(file, metadata={"Date": None})
