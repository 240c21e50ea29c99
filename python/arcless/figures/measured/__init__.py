"""Figures of a measured run: those of a run that follow from force, position and height."""

from arcless.figures.description import Figure
from arcless.figures.measured.measured_data import Kept, MeasuredData
from arcless.figures.run import along_track, distribution

FIGURES = {
    "lead": along_track.lead,
    "force": along_track.force,
    "height": along_track.height,
    "histogram": distribution.histogram,
    "spectrum": distribution.force_spectrum,
    "spectrogram": distribution.spectrogram,
}


def figures(data: MeasuredData) -> dict[str, list[Figure]]:
    """Return the figures of a measured run by their keys; a key without data has none."""
    return {
        key: make(data)
        for key, make in FIGURES.items()
        if key != "height" or data.has("contact_height")
    }


__all__ = ["FIGURES", "Kept", "MeasuredData", "figures"]
