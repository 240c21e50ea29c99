"""Parts of a figure: axes, layers, scales of colour, and the tokens of the design."""

from arcless.figures.description.figure import Axis, Figure, Scale
from arcless.figures.description.layers import (
    Area,
    Bars,
    Curve,
    Layer,
    Map,
    Points,
    Rules,
    Segments,
    Strip,
    Texts,
    Tip,
)

__all__ = [
    "Area",
    "Axis",
    "Bars",
    "Curve",
    "Figure",
    "Layer",
    "Map",
    "Points",
    "Rules",
    "Scale",
    "Segments",
    "Strip",
    "Texts",
    "Tip",
]
