"""Overlaid runs → figures: forces, spectra, uplift at supports, forces of droppers."""

from collections.abc import Sequence

from arcless.figures.comparison import distribution, forces, line, spectra
from arcless.figures.comparison.overlaid import Overlaid
from arcless.figures.description import Figure

# Most runs that a reader tells apart by their colours.
MOST_RUNS = 6

_OF_PANTOGRAPHS = {
    "force": (forces.force, "Contact force"),
    "folded": (forces.folded, "Contact force over the span"),
    "by_span": (forces.by_span, "Standard deviation in each span"),
    "spectrum": (spectra.over_frequency, "Spectrum over frequency"),
    "wavelengths": (spectra.over_wavelength, "Spectrum over wavelength"),
    "octaves": (distribution.octaves, "Standard deviation in third octaves"),
    "histogram": (distribution.histogram, "Distribution of the contact force"),
    "height": (distribution.height, "Height of the contact point"),
}


def figures(
    many: Overlaid, pantographs: Sequence[tuple[str, forces.Places]]
) -> dict[str, list[Figure]]:
    """Return the overlays by their keys; those of pantographs have one figure for each.

    Parameters
    ----------
    many
        The runs, at most `MOST_RUNS`.
    pantographs
        Name of each pantograph and its number in each run, None for a run without it.
    """
    found: dict[str, list[Figure]] = {}
    for key, (make, title) in _OF_PANTOGRAPHS.items():
        found[key] = []
        for number, (name, places) in enumerate(pantographs, start=1):
            full = f"{title}, {name}" if len(pantographs) > 1 else title
            found[key] += make(many, places, f"{key.replace('_', '-')}-{number}", full)
    found["uplift"] = line.uplift(many)
    found["droppers"] = line.droppers(many)
    return found


__all__ = ["MOST_RUNS", "Overlaid", "figures"]
