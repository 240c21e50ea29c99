"""Spectra of the unfiltered force of runs, over frequency and over wavelength."""

import numpy as np

from arcless.assess.signals.filter import spectrum_of
from arcless.assess.signals.gapped import common_window_s
from arcless.figures.comparison.forces import Places
from arcless.figures.comparison.overlaid import Overlaid
from arcless.figures.description import Axis, Curve, Figure, Layer, Tip
from arcless.figures.run.distribution import DECADES, HIGHEST_HZ
from arcless.figures.run.run_data import Floats


def densities(many: Overlaid, places: Places) -> list[tuple[int, Floats, Floats]]:
    """Return number of the run, frequencies in Hz and densities in N²/Hz, where there are some."""
    parts = {
        k: [part for part in many.runs[k].stretches(place) if part.size > 1]
        for k, place in enumerate(places)
        if place is not None
    }
    parts = {k: stretches for k, stretches in parts.items() if stretches}
    window_s = common_window_s(
        max(part.size for part in stretches) / many.runs[k].record.rate_Hz
        for k, stretches in parts.items()
    )
    found = []
    for k, stretches in parts.items():
        frequency, density = spectrum_of(stretches, many.runs[k].record.rate_Hz, window_s)
        shown = (frequency > 0.0) & (frequency <= HIGHEST_HZ) & (density > 0.0)
        if shown.any():
            found.append((k, frequency[shown], density[shown]))
    return found


def over_frequency(many: Overlaid, places: Places, key: str, title: str) -> list[Figure]:
    """Return the power spectral densities over frequency."""
    known = densities(many, places)
    if not known:
        return []
    layers = [
        _curve(many, k, (frequency, density), ("frequency", "Hz"), "N²/Hz")
        for k, frequency, density in reversed(known)
    ]
    alt = "; ".join(
        f"{many.names[k]}: largest at {frequency[density.argmax()]:.2f} Hz"
        for k, frequency, density in known
    )
    return [
        Figure(
            key, title, Axis("frequency", "Hz", 0.0, HIGHEST_HZ),
            _decades(layers, "N²/Hz"), layers, caption="From the unfiltered force in the analysis"
            " section.", alt=f"Power spectral density over frequency. {alt}.",
        )
    ]  # fmt: skip


def over_wavelength(many: Overlaid, places: Places, key: str, title: str) -> list[Figure]:
    """Return the same power by wavelength, in N² for each 1/m: what the line repeats lines up."""
    known = densities(many, places)
    if not known:
        return []
    layers = []
    alt = []
    for k, frequency, density in reversed(known):
        speed = many.runs[k].assessment.speed_m_s
        # The power between two frequencies is that between two wavelengths: S_f df = S_n dn with
        # the wave number n = f / v.
        length, by_number = (speed / frequency)[::-1], (speed * density)[::-1]
        layers.append(_curve(many, k, (length, by_number), ("wavelength", "m"), "N²·m"))
        alt.append(f"{many.names[k]}: largest at {length[by_number.argmax()]:.1f} m")
    low = min(float(one.x[0]) for one in layers)
    high = max(float(one.x[-1]) for one in layers)
    return [
        Figure(
            key, title,
            Axis("wavelength", "m", low, high, logarithmic=True), _decades(layers, "N²·m"),
            list(layers), caption="The wavelength is the speed over the frequency, so that spans"
            " and droppers appear at their lengths at any speed.",
            alt=f"Power spectral density over wavelength. {'; '.join(reversed(alt))}.",
        )
    ]  # fmt: skip


def _curve(
    many: Overlaid, k: int, points: tuple[Floats, Floats], along: tuple[str, str], unit: str
) -> Curve:
    x, y = points
    tips = (Tip("", [many.names[k]] * x.size, form=""), Tip(along[0], "x", along[1], "0.00"),
            Tip("density", "y", unit, "0.00e+0"))  # fmt: skip
    return Curve(x, y, colour=many.colour(k), name=many.names[k], width=1.6, tips=tips)


def _decades(layers: "list[Curve] | list[Layer]", unit: str) -> Axis:
    """Return an axis that ends above the largest density, some decades long."""
    top = max(float(np.max(one.y)) for one in layers if isinstance(one, Curve))
    return Axis("power spectral density", unit, top / 10.0**DECADES, 3.0 * top, logarithmic=True)
