"""Figures as descriptions that no drawing library is needed for: made once, drawn on many media.

`description` says what a figure is made of; the other rooms make figures of their subjects. Pages
draw them by Bokeh (`report.drawing`), paper and notebooks by matplotlib (`paper`).
"""

from typing import Any


def __getattr__(name: str) -> Any:
    """Import the drawing on paper at its first use: pages do without it."""
    if name != "paper":
        raise AttributeError(f"module `arcless.figures` has no attribute `{name}`")
    from importlib import import_module

    return import_module("arcless.figures.paper")
