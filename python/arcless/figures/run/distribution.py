"""Figures of the contact force over the section: histogram, spectrum, spectrogram."""

import numpy as np

from arcless.assess.signals.filter import spectrum_of
from arcless.figures.description import (
    Axis,
    Bars,
    Curve,
    Figure,
    Layer,
    Map,
    Rules,
    Scale,
    Tip,
)
from arcless.figures.description.tokens import of_pantograph
from arcless.figures.run.run_data import RunData
from arcless.figures.run.track import axis as track_axis
from arcless.figures.run.track import gaps, supports, titled

BINS = 40
HIGHEST_HZ = 50.0
DECADES = 6
# Window of the spectrogram in s, its columns for all pantographs together, the highest frequency
# over the low-pass, and the range of densities below the largest one, in dB.
WINDOW_S, COLUMNS, ABOVE_LOW_PASS, DEPTH_DB = 1.0, 400, 1.5, 40.0
HARMONICS = 3
# Columns of the spectrogram from its nearest window up to which a place is drawn. Fewer would leave
# holes where the speed changes; more would fill gaps of a measurement.
GAP_COLUMNS = 2.0


def histogram(run: RunData) -> list[Figure]:
    """Return the share of time over contact force, filtered, with the mean and three deviations."""
    total, inside = run.record.bands.total, run.record.inside
    lowest, highest = float(total[inside].min()), float(total[inside].max())
    edges = np.linspace(lowest, max(highest, lowest + 1.0), BINS + 1)
    every = [total[inside[:, i], i] for i in range(len(run.pantographs))]
    shares = [100.0 * np.histogram(values, edges)[0] / values.size for values in every]
    numbers_of = run.assessment.pantographs
    low = min([lowest, *(p.statistical_min_N for p in numbers_of)])
    high = max([highest, *(p.statistical_max_N for p in numbers_of)])
    margin = 0.04 * (high - low) + 1.0
    x = Axis("contact force", "N", low - margin, high + margin)
    y = Axis("share of time", "%", 0.0, 1.08 * max(float(share.max()) for share in shares))
    found = []
    for i, (numbers, share) in enumerate(zip(numbers_of, shares, strict=True)):
        tips = (Tip("from", edges[:-1], "N"), Tip("to", edges[1:], "N"),
                Tip("share of time", share, "%", "0.00"))  # fmt: skip
        ends = np.array([numbers.statistical_min_N, numbers.statistical_max_N])
        layers: list[Layer] = [
            Bars(edges[:-1], edges[1:], np.zeros_like(share), share, colour=of_pantograph(i),
                 alpha=0.55, tips=tips),
            Rules(axis="x", at=np.array([numbers.mean_force_N]), colour="mean", width=1.4,
                  name="mean F_m"),
            Rules(axis="x", at=ends, colour="spread", width=1.2, dash="dashed", name="F_m ± 3σ"),
        ]  # fmt: skip
        found.append(
            Figure(
                f"histogram-{i + 1}", titled(run, "Distribution of the contact force", i), x, y,
                layers,
                caption=f"In the analysis section, after the {run.assessment.low_pass_Hz:g} Hz"
                " low-pass.",
                alt=f"Histogram of the contact force of {numbers.name}: mean"
                f" {numbers.mean_force_N:.1f} N, standard deviation {numbers.std_force_N:.1f} N.",
            )
        )  # fmt: skip
    return found


def force_spectrum(run: RunData) -> list[Figure]:
    """Return the power spectral density of the unfiltered force, with what passes at which."""
    found = []
    densities = []
    for i in range(len(run.pantographs)):
        frequency, density = spectrum_of(run.stretches(i), run.record.rate_Hz)
        shown = (frequency > 0.0) & (frequency <= HIGHEST_HZ) & (density > 0.0)
        densities.append((frequency[shown], density[shown]))
    top = max(float(density.max(initial=0.0)) for _, density in densities) or 1.0
    x = Axis("frequency", "Hz", 0.0, HIGHEST_HZ)
    y = Axis("power spectral density", "N²/Hz", top / 10.0**DECADES, 3.0 * top, logarithmic=True)
    for i, (frequency, density) in enumerate(densities):
        wavelength = run.assessment.speed_m_s / frequency
        tips = (Tip("frequency", "x", "Hz", "0.00"), Tip("wavelength", wavelength, "m"),
                Tip("density", "y", "N²/Hz", "0.00e+0"))  # fmt: skip
        curve = Curve(frequency, density, colour=of_pantograph(i), tips=tips)
        largest = float(frequency[density.argmax()]) if density.size else 0.0
        found.append(
            Figure(
                f"spectrum-{i + 1}", titled(run, "Spectrum of the unfiltered contact force", i),
                x, y, [*_passing(run), *_bands(run), curve],
                caption="In the analysis section. The wavelength is the speed over the frequency.",
                alt=f"Power spectral density of the contact force of {run.pantographs[i]}, largest"
                f" at {largest:.2f} Hz.",
            )
        )  # fmt: skip
    return found


def spectrogram(run: RunData) -> list[Figure]:
    """Return the density of the force over position and frequency, in moving windows."""
    rate = run.record.rate_Hz
    length = int(min(run.time.size, max(8, round(WINDOW_S * rate))))
    columns = max(60, COLUMNS // len(run.pantographs))
    hop = max(1, (run.time.size - length) // columns)
    if run.time.size < 2 * length:
        return []
    window = 0.5 - 0.5 * np.cos(2.0 * np.pi * np.arange(length) / length)
    frequency = np.fft.rfftfreq(length, 1.0 / rate)
    kept = (frequency > 0.0) & (frequency <= ABOVE_LOW_PASS * run.assessment.low_pass_Hz)
    levels, places = [], []
    for i in range(len(run.pantographs)):
        pieces = np.lib.stride_tricks.sliding_window_view(run.record.force[:, i], length)[::hop]
        waves = np.fft.rfft((pieces - pieces.mean(axis=1, keepdims=True)) * window, axis=1)
        density = 2.0 * np.abs(waves[:, kept]) ** 2 / (rate * np.sum(window**2))
        levels.append(10.0 * np.log10(np.maximum(density, 1e-12)).T)
        middle = np.arange(len(pieces)) * hop + length // 2
        places.append(run.position[middle, i])
    known = [level[np.isfinite(level)] for level in levels]
    if not all(part.size for part in known):
        return []  # no window between two gaps of a measurement
    high = float(np.ceil(max(float(part.max()) for part in known)))
    scale = Scale("density", "dB re 1 N²/Hz", high - DEPTH_DB, high)
    step = float(frequency[1])
    heights = (float(frequency[kept][0]) - 0.5 * step, float(frequency[kept][-1]) + 0.5 * step)
    found = []
    for i, (level, x) in enumerate(zip(levels, places, strict=True)):
        even = np.linspace(x[0], x[-1], x.size)
        nearest = np.clip(np.searchsorted(x, even), 0, x.size - 1)
        half = 0.5 * (even[1] - even[0])
        apart = np.abs(x[nearest] - even) > 2.0 * GAP_COLUMNS * half
        shown = np.where(apart, np.nan, level[:, nearest])
        grid = Map((even[0] - half, even[-1] + half), heights, shown,
                   tips=(Tip("density", "x", "dB"),))  # fmt: skip
        found.append(
            Figure(
                f"spectrogram-{i + 1}",
                titled(run, "Spectrogram of the unfiltered contact force", i),
                track_axis(run), Axis("frequency", "Hz", *heights),
                [grid, *gaps(run, i), *supports(run)],
                caption=f"Power spectral density in windows of {WINDOW_S:g}\u00a0s, equal to"
                f" {WINDOW_S * run.assessment.speed_m_s:.0f}\u00a0m along the track.",
                alt=f"Spectrogram of the contact force of {run.pantographs[i]} along the track.",
                scale=scale,
            )
        )  # fmt: skip
    return found


def _passing(run: RunData) -> list[Layer]:
    """Return the frequencies at which spans pass, and droppers, where they do so regularly."""
    marks: list[tuple[str, float, str, int]] = []
    if run.supports.size > 1:
        length = float(np.median(np.diff(run.supports)))
        marks.append(("span", length, "support", HARMONICS))
    droppers = np.unique(run.values("dropper_x"))
    if droppers.size > 1:
        marks.append(("dropper", float(np.median(np.diff(droppers))), "dropper", 1))
    layers: list[Layer] = []
    for name, length, colour, count in marks:
        passing = run.assessment.speed_m_s / length
        at = passing * np.arange(1, count + 1)
        at = at[at <= HIGHEST_HZ]
        if at.size:
            text = f"{name} passing, {passing:.2f} Hz" + (" and multiples" if at.size > 1 else "")
            layers.append(
                Rules(axis="x", at=at, colour=colour, dash="dotted", width=1.4, name=text)
            )
    return layers


def _bands(run: RunData) -> list[Layer]:
    a = run.assessment
    at = np.array([a.band_split_Hz, a.low_pass_Hz])
    name = f"bands: {at[0]:g} and {at[1]:g} Hz"
    return [Rules(axis="x", at=at, colour="spread", dash="dashed", name=name)]
