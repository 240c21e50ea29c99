"""Figures of a fitted receptance: amplitude and phase over the data, and the misfit."""

from arcless.figures.receptance.fitted import FIGURES, figures

__all__ = ["FIGURES", "figures"]
