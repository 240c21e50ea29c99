"""Measured receptance and the chain that was fitted to it, over frequency."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.figures.description import Area, Axis, Curve, Figure, Layer, Points, Rules, Strip, Tip
from arcless.figures.description.thinning import every
from arcless.pantograph.receptance import Fit
from arcless.pantograph.receptance.least_squares import logarithm

Floats = NDArray[np.float64]
Complex = NDArray[np.complexfloating[Any, Any]]

# Points of a model's curve, and marks of data: what a page can show apart.
CURVE, MARKS = 600, 1500
# Model beyond the data, in parts of their lowest and highest frequency.
BELOW, ABOVE = 0.5, 2.0
_GROUP = "frequency"


def amplitude(fit: Fit) -> Figure:
    """Return the amplitude of the receptance, measured and of the model."""
    shown = _shown(fit)
    measured = 1e3 * np.abs(fit.data.values[shown])
    f, values = _model(fit)
    size = 1e3 * np.abs(values)
    low = float(min(measured.min(), size.min()))
    high = float(max(measured.max(), size.max()))
    layers: list[Layer] = [
        _band(fit),
        Points(fit.data.frequency[shown], measured, colour="series_2", size=5.0, alpha=0.55,
               name="measured", tips=_tips("amplitude", "mm/N", "0.000")),
        *_curves(fit, f, size, _tips("amplitude", "mm/N", "0.000")),
        *_modes(fit),
    ]  # fmt: skip
    return Figure(
        "receptance-amplitude", "Amplitude of the receptance at the head", _frequencies(fit),
        Axis("amplitude", "mm/N", low / 1.5, 1.5 * high, logarithmic=True), layers,
        caption="Displacement of the head by a force of 1 N on it.",
        alt=f"Amplitude of the receptance from {low:.3g} to {high:.3g} mm/N, measured at"
        f" {fit.data.frequency.size} frequencies and of the model; root mean square of the misfit"
        f" {100 * fit.misfit:.2g} %.",
    )  # fmt: skip


def phase(fit: Fit) -> Figure:
    """Return the phase of the receptance, measured and of the model."""
    shown = _shown(fit)
    f, values = _model(fit)
    measured = _degrees(fit.data.values[shown])
    layers: list[Layer] = [
        _band(fit),
        Rules(axis="y", at=np.array([-180.0, 0.0]), colour="limit", dash="dashed",
              name="limits of a passive pantograph"),
        Points(fit.data.frequency[shown], measured, colour="series_2", size=5.0, alpha=0.55,
               name="measured", tips=_tips("phase", "°", "0.0")),
        *_curves(fit, f, _degrees(values), _tips("phase", "°", "0.0")),
        *_modes(fit),
    ]  # fmt: skip
    return Figure(
        "receptance-phase", "Phase of the receptance at the head", _frequencies(fit),
        Axis("phase", "°", -205.0, 25.0), layers,
        alt=f"Phase of the receptance, measured from {measured.min():.0f} to"
        f" {measured.max():.0f}°, and of the model.",
    )  # fmt: skip


def misfit(fit: Fit) -> Figure:
    """Return the misfit of amplitude and phase at each frequency, and ± of the model."""
    shown = _shown(fit)
    f = fit.data.frequency[shown]
    size, turn = 100.0 * fit.residual.real[shown], 100.0 * fit.residual.imag[shown]
    sure = 100.0 * fit.band[shown]
    top = 1.1 * max(float(np.abs(np.concatenate([size, turn, sure])).max()), 1e-9)
    layers: list[Layer] = [
        Area(f, -sure, sure, colour="series_1", alpha=0.2, name="± of the model, 95 %"),
        Rules(axis="y", at=np.array([0.0]), colour="soft", width=1.0),
        Points(f, turn, colour="series_3", size=5.0, shape="diamond", alpha=0.8,
               name="phase, in 0.01 rad", tips=_tips("phase", "0.01 rad", "0.00")),
        Points(f, size, colour="series_2", size=5.0, name="amplitude, in %", alpha=0.8,
               tips=_tips("amplitude", "%", "0.00")),
    ]  # fmt: skip
    most, place = fit.largest
    return Figure(
        "receptance-misfit", "Misfit, model over measured", _frequencies(fit),
        Axis("misfit", "%", -top, top), layers,
        caption="0.01 rad is 0.57°. Noise scatters about zero; a pattern is what the model lacks.",
        alt=f"Misfit over frequency, {100 * fit.misfit:.2g} % root mean square, largest"
        f" {100 * most:.2g} % at {place:g} Hz.",
    )  # fmt: skip


FIGURES = {"amplitude": amplitude, "phase": phase, "misfit": misfit}


def figures(fit: Fit) -> dict[str, Figure]:
    """Return the figures of a fit by their keys."""
    return {key: make(fit) for key, make in FIGURES.items()}


def _ends(fit: Fit) -> tuple[float, float]:
    return BELOW * float(fit.data.frequency[0]), ABOVE * float(fit.data.frequency[-1])


def _frequencies(fit: Fit) -> Axis:
    low, high = _ends(fit)
    return Axis("frequency", "Hz", low, high, logarithmic=True, group=_GROUP)


def _shown(fit: Fit) -> NDArray[np.intp]:
    return every(fit.data.frequency.size, MARKS)


def _model(fit: Fit) -> tuple[Floats, Complex]:
    """Return frequencies in Hz, and the receptance of the model in m/N.

    Frequencies of modes are among them, so that no peak is cut off.
    """
    low, high = _ends(fit)
    ends = fit.data.frequency[[0, -1]]
    peaks = [one.frequency_Hz for one in fit.modes if low < one.frequency_Hz < high]
    f = np.unique(np.concatenate([np.geomspace(low, high, CURVE), ends, peaks]))
    return f, fit.chain.receptance(f)


def _degrees(values: Complex) -> Floats:
    return np.degrees(logarithm(values).imag)


def _band(fit: Fit) -> Strip:
    low, high = fit.data.frequency[[0, -1]]
    return Strip(axis="x", low=float(low), high=float(high), colour="section", alpha=0.06,
                 name="range of the data")  # fmt: skip


def _curves(fit: Fit, f: Floats, y: Floats, tips: tuple[Tip, ...]) -> list[Layer]:
    """Return the model within the data, and its pieces beyond them."""
    low, high = fit.data.frequency[[0, -1]]
    inside, beyond = (f >= low) & (f <= high), (f <= low) | (f >= high)
    gap = np.where(beyond, y, np.nan)
    return [
        Curve(f, gap, colour="series_1", dash="dashed", width=1.4,
              name="model beyond the data", tips=tips),
        Curve(f[inside], y[inside], colour="series_1", width=2.0, name="model",
              tips=tips),
    ]  # fmt: skip


def _modes(fit: Fit) -> list[Layer]:
    low, high = _ends(fit)
    found = [one.frequency_Hz for one in fit.modes
             if low < one.frequency_Hz < high and one.damping_ratio < 1.0]  # fmt: skip
    if not found:
        return []
    return [Rules(axis="x", at=np.array(found), colour="soft", dash="dotted", width=1.2,
                  name="modes of the model")]  # fmt: skip


def _tips(label: str, unit: str, form: str) -> tuple[Tip, ...]:
    return Tip("frequency", "x", "Hz", "0.00"), Tip(label, "y", unit, form)
