"""Distance from one pantograph to the next by the speed of the line.

Two pantographs for the design of an overhead line stand so far apart, AC and DC alike (TSI ENE,
table 4.2.13, column B, as given in Bane NOR TRV:00597; the TSI itself was not read):

    v ≥ 250 km/h     200 m
    120 < v < 250     85 m
     80 < v ≤ 120     15 m
          v ≤ 80       8 m
"""

from typing import Final, Literal

TSI: Final = "tsi"
Word = Literal["tsi"]
KMH = 3.6
# A speed in km/h comes back from m/s with rounding, and must not slip below its limit by it.
ROUNDING = 1e-9
# Speed in m/s from which a distance in m holds, the highest first. 250 km/h has the distance of the
# speeds above it, 120 and 80 km/h that of the speeds below.
RANGES: Final = (
    (250.0 * (1.0 - ROUNDING) / KMH, 200.0),
    (120.0 * (1.0 + ROUNDING) / KMH, 85.0),
    (80.0 * (1.0 + ROUNDING) / KMH, 15.0),
    (0.0, 8.0),
)


def tsi_spacing(speed: float) -> float:
    """Return the distance from one pantograph to the next in m.

    Parameters
    ----------
    speed : float
        Highest speed in m/s.

    Examples
    --------
    >>> tsi_spacing(250 / 3.6), tsi_spacing(200 / 3.6), tsi_spacing(120 / 3.6), tsi_spacing(20.0)
    (200.0, 85.0, 15.0, 8.0)
    """
    return next((distance for lowest, distance in RANGES if speed > lowest), RANGES[-1][1])
