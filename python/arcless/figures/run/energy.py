"""The figure of the energy balance."""

import numpy as np
from numpy.typing import NDArray

from arcless.figures.description import Axis, Curve, Figure, Layer, Tip
from arcless.figures.description.thinning import every
from arcless.figures.description.tokens import of_series
from arcless.figures.run.run_data import RunData

Floats = NDArray[np.float64]

ROWS, TALL, COLOURS = 500, 420, 8


def energy(run: RunData) -> list[Figure]:
    """Return the terms of the energy balance over time, those that are not zero throughout."""
    terms = [(name, label) for name, label in energy_terms(run) if settled(run, name).any()]
    if not terms:
        return []
    times = run.values("line_time")[np.isfinite(run.values(terms[0][0]))]
    kept = every(times.size, ROWS)
    time = times[kept]
    layers: list[Layer] = [
        Curve(time, settled(run, name)[kept], colour=of_series(i), name=label,
              dash=("solid", "dashed")[i // COLOURS % 2],
              tips=(Tip(label, "y", "J", "0.000"), Tip("time", "x", "s", "0.000")))
        for i, (name, label) in reversed([*enumerate(terms)])  # a legend begins at the top
    ]  # fmt: skip
    residual = run.assessment.energy_residual_relative
    closes = "" if residual is None else f" The balance closes to {residual:.1e} of the energy."
    return [
        Figure(
            "energy", "Energy balance", Axis("time", "s"), Axis("energy", "J"), layers,
            alt=f"Terms of the energy balance over time.{closes}", height=TALL,
        )
    ]  # fmt: skip


def energy_terms(run: RunData) -> list[tuple[str, str]]:
    """Return name and short label of the balance's terms in the dataset."""
    names = [str(name) for name in run.dataset if str(name).startswith("energy_")]
    return [(name, name.removeprefix("energy_").replace("_", " ")) for name in names]


def settled(run: RunData, name: str) -> Floats:
    """Return a term of the balance in the rows at which it was settled."""
    values: Floats = run.values(name)
    return values[np.isfinite(values)]
