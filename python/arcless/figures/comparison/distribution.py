"""Height of the contact point along the track, distribution and third octaves of the force."""

import numpy as np

from arcless.assess.signals.gapped import THIRD_OCTAVES, deviation_between, third_octave_Hz
from arcless.figures.comparison.forces import Places
from arcless.figures.comparison.overlaid import Overlaid
from arcless.figures.comparison.spectra import densities
from arcless.figures.description import Axis, Bars, Curve, Figure, Layer, Tip
from arcless.figures.run.track import filtered

BINS = 40
TALL = 300


def height(many: Overlaid, places: Places, key: str, title: str) -> list[Figure]:
    """Return the height of the contact point over the position, a curve for each run with one."""
    layers: list[Layer] = []
    alt = []
    for k, place in reversed(list(enumerate(places))):
        run = many.runs[k]
        if place is None or not run.has("contact_height"):
            continue
        values = run.values("contact_height")[:, place]
        inside = values[run.record.inside[:, place]]
        if not inside.size or np.isnan(inside).all():
            continue
        look = {"colour": many.colour(k), "name": many.names[k], "width": 1.4, "alpha": 0.9}
        layers.append(filtered(run, place, values, "height m 0.000", **look))
        span_mm = 1e3 * float(np.nanmax(inside) - np.nanmin(inside))
        alt.append(f"{many.names[k]}: range {span_mm:.0f} mm")
    if not layers:
        return []
    return [
        Figure(
            key, title, many.axis(), Axis("height above rail", "m"), [*many.ground(), *layers],
            caption=f"As recorded, not filtered.{many.remark}",
            alt=f"Height of the contact point along the track. {'; '.join(reversed(alt))}.",
            height=TALL,
        )
    ]  # fmt: skip


def histogram(many: Overlaid, places: Places, key: str, title: str) -> list[Figure]:
    """Return the share of time over the filtered force in the section, a curve for each run."""
    forces = {}
    for k, place in enumerate(places):
        if place is not None:
            record = many.runs[k].record
            values = record.bands.total[record.inside[:, place], place]
            forces[k] = values[~np.isnan(values)]
    forces = {k: values for k, values in forces.items() if values.size}
    if not forces:
        return []
    low, high = (float(end([end(one) for one in forces.values()])) for end in (np.min, np.max))
    edges = np.linspace(low, max(high, low + 1.0), BINS + 1)
    middles = 0.5 * (edges[1:] + edges[:-1])
    layers: list[Layer] = []
    alt = []
    for k, values in reversed(forces.items()):
        share = 100.0 * np.histogram(values, edges)[0] / values.size
        tips = (Tip("", [many.names[k]] * BINS, form=""), Tip("force", "x", "N"),
                Tip("share of time", "y", "%", "0.00"))  # fmt: skip
        layers.append(
            Curve(middles, share, colour=many.colour(k), name=many.names[k], width=2.0, tips=tips)
        )
        alt.append(f"{many.names[k]}: most often {middles[share.argmax()]:.0f} N")
    return [
        Figure(
            key, title, Axis("contact force", "N"), Axis("share of time", "%", 0.0), layers,
            caption=f"In the analysis section, after the low-pass; in steps of"
            f" {edges[1] - edges[0]:.1f} N.",
            alt=f"Distribution of the contact force. {'; '.join(reversed(alt))}.",
        )
    ]  # fmt: skip


def octaves(many: Overlaid, places: Places, key: str, title: str) -> list[Figure]:
    """Return the standard deviation in third octaves, bars of the runs side by side."""
    known = densities(many, places)
    if not known:
        return []
    centres = 10.0 ** (np.array(list(THIRD_OCTAVES), dtype=float) / 10.0)
    # All of them would run into one another on a phone; the pointer has the others.
    named = [
        f"{one:.3g}" if n % 2 == 0 else "" for n, one in zip(THIRD_OCTAVES, centres, strict=True)
    ]
    places_at = np.arange(centres.size, dtype=float)
    width = 0.84 / len(known)
    layers: list[Layer] = []
    alt = []
    for order, (k, frequency, density) in reversed(list(enumerate(known))):
        ends = map(third_octave_Hz, THIRD_OCTAVES)
        # A band that the windows do not resolve has the power of its neighbours.
        resolved = frequency[1] - frequency[0]
        found = [
            deviation_between(frequency, density, low, high) if high - low >= resolved else None
            for low, high in ends
        ]
        high = np.array([0.0 if one is None else one for one in found])
        left = places_at - 0.42 + width * order
        tips = (Tip("", [many.names[k]] * high.size, form=""),
                Tip("standard deviation", high, "N"),
                Tip("about", centres, "Hz", "0.00"))  # fmt: skip
        layers.append(
            Bars(left, left + width, np.zeros_like(high), high, colour=many.colour(k),
                 name=many.names[k], alpha=0.85, tips=tips)
        )  # fmt: skip
        alt.append(f"{many.names[k]}: largest about {centres[high.argmax()]:.3g} Hz")
    return [
        Figure(
            key, title,
            Axis("third octave about", "Hz", -0.6, centres.size - 0.4,
                 categories=tuple(named)),
            Axis("standard deviation σ", "N", 0.0), layers,
            caption="From the spectrum of the unfiltered force in the analysis section.",
            alt=f"Standard deviation in third octaves. {'; '.join(reversed(alt))}.",
        )
    ]  # fmt: skip
