"""Fits of a receptance as rows of text, for a terminal and a page."""

from collections.abc import Sequence
from math import isfinite
from typing import Any

from arcless.display.numbers import number
from arcless.pantograph.receptance.fitted import Fit
from arcless.pantograph.receptance.remarks import remarks
from arcless.pantograph.receptance.words import plain_sure, significant

ORDERS = ("masses", "damping", "parameters", "misfit, %", "largest, %", "at, Hz",
          "likeness of neighbours", "criterion")  # fmt: skip
MODES = ("mode", "frequency, Hz", "±, Hz", "damping ratio", "±")
PARAMETERS = ("mass", "mass, kg", "±", "stiffness below, N/m", "±", "damping below, N s/m", "±")
ORDERS_READ = (
    "The misfit is the root mean square of ln(model/measured), amplitude and phase alike. Misfits"
    " of neighbouring frequencies are alike, up to 1, where the model lacks something; where only"
    " noise is left, the likeness is about 0. The criterion is Schwarz's, above the least of the"
    " list: the row with 0 is what the data support."
)
DAMPING_WORDS = {"joints": "in joints", "full": "full matrix"}
# Significant figures of masses, springs and dampers.
_FIGURES = 4


def order_rows(fits: Sequence[Fit]) -> list[tuple[str, ...]]:
    """Return a row for each order and kind of damping; see `ORDERS`."""
    least = min(fit.information for fit in fits)
    return [
        (
            str(fit.chain.order), DAMPING_WORDS[fit.chain.kind], str(fit.chain.parameters),
            significant(100.0 * fit.misfit, 3), significant(100.0 * fit.largest[0], 3),
            f"{fit.largest[1]:g}", number(fit.alike, 2), number(fit.information - least, 0),
        )
        for fit in fits
    ]  # fmt: skip


def mode_rows(fit: Fit) -> list[tuple[str, ...]]:
    """Return a row for each mode; see `MODES`."""
    rows: list[tuple[str, ...]] = []
    for place, mode in enumerate(fit.modes, start=1):
        if mode.frequency_Hz == 0.0:
            rows.append((str(place), "0", "–", "the frame is free", "–"))
            continue
        sure = (plain_sure(mode.frequency_sure_Hz), plain_sure(mode.damping_sure))
        swings = mode.damping_ratio < 1.0
        rows.append((
            str(place), significant(mode.frequency_Hz, 4), sure[0],
            significant(mode.damping_ratio, 3) if swings else "does not swing",
            sure[1] if swings else "–",
        ))  # fmt: skip
    return rows


def parameter_rows(fit: Fit) -> list[tuple[str, ...]]:
    """Return a row for each mass, from the base; see `parameter_titles`."""
    rows: dict[int, list[str]] = {}
    for one in fit.parameters:
        row = rows.setdefault(one.place, [str(one.place)])
        row += [significant(one.value, _FIGURES), plain_sure(one.sure)]
    return [tuple(row) for row in rows.values()]


def parameter_titles(fit: Fit) -> tuple[str, ...]:
    """Return the titles of `parameter_rows`; a full damping matrix is no column of it."""
    return PARAMETERS if fit.chain.kind == "joints" else PARAMETERS[:-2]


def to_dict(fit: Fit) -> dict[str, Any]:
    """Return a fit as plain values; what the data do not tell is None."""
    size, place = fit.largest
    return {
        "order": fit.chain.order,
        "damping": fit.chain.kind,
        "parameters": fit.chain.parameters,
        "misfit_percent": 100.0 * fit.misfit,
        "largest_misfit_percent": 100.0 * size,
        "largest_misfit_at_Hz": place,
        "likeness_of_neighbours": fit.alike,
        "misfit_over_errors": fit.over_noise,
        "criterion": fit.information,
        "modes": [
            {
                "frequency_Hz": mode.frequency_Hz, "damping_ratio": mode.damping_ratio,
                "frequency_sure_Hz": _known(mode.frequency_sure_Hz),
                "damping_sure": _known(mode.damping_sure),
            }
            for mode in fit.modes
        ],
        **{
            f"{name}_{unit}": getattr(fit.chain.matrices, name).tolist()
            for name, unit in (("mass", "kg"), ("damping", "N_s_per_m"), ("stiffness", "N_per_m"))
        },
        "sure": [
            {"kind": one.kind, "place": one.place, "unit": one.unit, "sure": _known(one.sure)}
            for one in fit.parameters
        ],
        "remarks": remarks(fit),
    }  # fmt: skip


def _known(value: float) -> float | None:
    return value if isfinite(value) else None
