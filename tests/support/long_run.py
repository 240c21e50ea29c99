"""A run of a million samples, drawn rather than computed, for what has to be fast with many.

``python -m tests.support.long_run FOLDER`` writes it as a run of that folder.
"""

import sys
from pathlib import Path

import numpy as np

from arcless.dataset.netcdf.store import save
from tests.support.synthetic import synthetic_dataset

SAMPLES = 1_000_000
SPEED_M_S, STEP_S = 20.0, 1e-3


def force(t: np.ndarray) -> np.ndarray:
    """Waves of the span and of droppers, and noise, which no thinning foresees."""
    noise = np.random.default_rng(1).normal(size=t.size)
    return 120 + 30 * np.sin(0.8 * np.pi * t) + 15 * np.sin(12.6 * np.pi * t) + 8 * noise


def write(folder: Path) -> Path:
    """Write the run below a folder; return its place."""
    length = SAMPLES * STEP_S * SPEED_M_S
    dataset = synthetic_dataset(
        duration_s=SAMPLES * STEP_S, step_s=STEP_S, line_every=200, speed_m_s=SPEED_M_S,
        force=force, section=(200.0, length - 200.0),
    )  # fmt: skip
    place = folder / "runs" / "long"
    place.mkdir(parents=True)
    save(dataset, place / "result.nc")
    return place


if __name__ == "__main__":
    write(Path(sys.argv[1]))
