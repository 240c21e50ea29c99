"""Numbers and modes of a fit in words."""

from math import isfinite

from arcless.pantograph.receptance.fitted import Mode

# Numbers below are written without a power of ten.
_PLAIN = 1e9


def mode_words(mode: Mode) -> str:
    """Return frequency and damping of a mode in words."""
    if mode.frequency_Hz == 0.0:
        return "0 Hz, the frame is free"
    if mode.damping_ratio >= 1.0:
        return f"{significant(mode.frequency_Hz, 4)} Hz, does not swing"
    ratio = significant(mode.damping_ratio, 3)
    return f"{significant(mode.frequency_Hz, 4)} Hz, damping ratio {ratio}"


def sure_words(sure: float) -> str:
    """Return ``± 0.05``, or nothing where the data do not tell."""
    return f"± {plain_sure(sure)}" if isfinite(sure) else ""


def plain_sure(sure: float) -> str:
    """Return what stands behind ±, with two significant figures; a dash where it is not known."""
    return significant(sure, 2) if isfinite(sure) else "–"


def significant(value: float, figures: int) -> str:
    """Return a number with so many significant figures, without a power of ten where it has few."""
    text = f"{value:.{figures}g}"
    if "e" not in text:
        return text
    return f"{float(text):.0f}" if 1.0 <= abs(value) < _PLAIN else text
