"""Mass and vertical acceleration of what a run has above the force sensors.

With z the height of the strips, upwards positive, F_c the contact force and L the lift of the air
on the mass m above the sensors, Newton's law of that mass is

    m z̈ = F_s + L − F_c     →     F_s = F_c + m z̈ − L

so that sensors below the strips miss the inertia of the strips: EN 50317 asks that it be corrected
by a measured acceleration (from memory, mark C).

The acceleration is the second difference of the recorded displacement,

    z̈(t) ≈ (z(t + h) − 2 z(t) + z(t − h))/h²,    too small by the factor (sin(π f h)/(π f h))²

A run's displacement is no measured signal: it is the state of the scheme in double precision, and
has no noise to be blown up (rounding of 1e-17 m over h = 1 ms is 1e-11 m/s²). The equation of
motion of the head would give the same by springs, dampers, friction and stops of each kind of
pantograph; a test compares the two.
"""

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from arcless.errors import ModelError, ResultFormatError

if TYPE_CHECKING:
    from arcless.model.pantograph.pantograph import Pantograph

Floats = NDArray[np.float64]
# Samples that a second difference needs.
FEWEST_SAMPLES = 3


def mass_of(model: "Pantograph") -> float | None:
    """Return the mass in kg of the strips, or of the last mass; None where no mass is known."""
    if model.head is not None:
        return model.head.strips * model.head.mass
    return model.masses[-1].mass if model.masses else None


def strip_shares(model: "Pantograph") -> Floats:
    """Return how far each recorded displacement moves the strips, whose sum is their mean height.

    Of a chain that is the last mass; of a head with strips, each strip by its part; of matrices,
    their own vector of the strip; of an FMU all its strips alike.
    """
    if model.matrices is not None:
        return np.array(model.matrices.strip, dtype=np.float64)
    shares = np.zeros(len(model.heights))
    if model.fmu is not None:
        return np.full(shares.size, 1.0 / shares.size)
    count = 1 if model.head is None else model.head.strips
    shares[-count:] = 1.0 / count
    return shares


def head_acceleration(dataset: Any, pantograph: int, model: "Pantograph") -> Floats:
    """Return the vertical acceleration of the strips in m/s², upwards positive, at each time.

    Parameters
    ----------
    dataset
        Of the run.
    pantograph
        Number of the pantograph, from 0.
    model
        Its model.

    Raises
    ------
    ResultFormatError
        The displacements of the masses were not recorded, or at too few times.
    """
    if "mass_displacement" not in dataset:
        raise ResultFormatError(
            "the displacements of the pantograph's masses were not recorded",
            where="mass_displacement",
            expected="a run of a version that records them",
            hint="compute the run again",
        )
    time = dataset["time"].values
    if time.size < FEWEST_SAMPLES:
        got = f"{time.size} time(s)"
        raise ResultFormatError("the record is too short for an acceleration", got=got)
    shares = strip_shares(model)
    height = dataset["mass_displacement"].values[:, pantograph, : shares.size] @ shares
    step = float(time[-1] - time[0]) / (time.size - 1)
    found: Floats = np.empty_like(height)
    found[1:-1] = (height[2:] - 2.0 * height[1:-1] + height[:-2]) / step**2
    found[0], found[-1] = found[1], found[-2]
    return found


def checked_mass(given: float | None, model: "Pantograph") -> float:
    """Return the mass above the sensors in kg: the one given, else that of the strips.

    Raises
    ------
    ModelError
        It is larger than the strips are, or not given for a pantograph given by matrices or an FMU.
    """
    known = mass_of(model)
    if given is None and known is None:
        raise ModelError(
            "mass_above_kg",
            got="nothing",
            expected="the mass above the force sensors: matrices and FMUs have none of their own",
        )
    if given is not None and known is not None and given > known * (1.0 + 1e-9):  # rounding
        raise ModelError(
            "mass_above_kg",
            got=f"{given:g} kg",
            expected=f"at most {known:g} kg, the mass of the strips of {model.name}",
        )
    return float(known if given is None else given)  # type: ignore[arg-type]
