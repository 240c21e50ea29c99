"""Simulation against line test, number by number, as EN 50318 accepts a simulation program.

The tolerances are from memory of EN 50318:2002 (mark C): the standard was not read, and no readable
source that quotes them was found. They are shown, and decide nothing.
"""

from collections.abc import Mapping
from dataclasses import dataclass

from arcless.assess import Assessment
from arcless.assess.quantities import QUANTITIES, label_of

MARK = "C"
SOURCE = "EN 50318:2002, from memory: the standard was not read"


@dataclass(frozen=True)
class Tolerance:
    """Largest distance of a simulated number from the measured one.

    Attributes
    ----------
    amount
        In the unit of the quantity, or in % of the measured number.
    relative
        Whether it is a percentage.
    """

    amount: float
    relative: bool

    def allows(self, simulated: float, measured: float) -> bool:
        """Return whether a number is within."""
        most = self.amount * (abs(measured) / 100.0 if self.relative else 1.0)
        return abs(simulated - measured) <= most

    def text(self, unit: str) -> str:
        """Return it as printed."""
        return f"± {self.amount:g} {'%' if self.relative else unit}"


# Quantities of the table → tolerance; None where none is remembered.
OF_PANTOGRAPH: Mapping[str, Tolerance | None] = {
    "mean_force_N": None,
    "std_force_N": Tolerance(20.0, relative=True),
    "std_force_0_5Hz_N": None,
    "std_force_5_20Hz_N": None,
    "max_force_N": None,
    "min_force_N": None,
    "contact_point_range_mm": Tolerance(20.0, relative=False),
    "contact_loss_percent": None,
}
OF_LINE: Mapping[str, Tolerance | None] = {
    "max_uplift_at_support_mm": Tolerance(20.0, relative=False)
}


@dataclass(frozen=True)
class Accepted:
    """One number of a run against that of a measurement.

    Attributes
    ----------
    run, measurement
        Their numbers among the runs that are compared, from 0.
    pantograph
        Name of the pantograph; None for a number of the line.
    key, label, unit, decimals
        The quantity.
    simulated, measured, difference
        In the unit; None where one of them has no such number.
    percent
        The difference in % of the measured number; None where that is zero, and for percentages.
    tolerance
        As printed; None where none is known.
    within
        Whether the difference is within it; None where that cannot be said.
    mark, source
        What is known of the tolerance's source; None without one.
    """

    run: int
    measurement: int
    pantograph: str | None
    key: str
    label: str
    unit: str
    decimals: int
    simulated: float | None
    measured: float | None
    difference: float | None
    percent: float | None
    tolerance: str | None
    within: bool | None
    mark: str | None
    source: str | None


def acceptance(
    places: tuple[int, int],
    assessments: tuple[Assessment, Assessment],
    pantographs: list[tuple[str, int | None, int | None]],
) -> list[Accepted]:
    """Return the table of a run against a measurement.

    Parameters
    ----------
    places
        Numbers of the run and of the measurement among those that are compared.
    assessments
        Of the run and of the measurement.
    pantographs
        Name of each pantograph, and its number in both; None where one lacks it.
    """
    run, measured = assessments
    found = []
    for name, here, there in pantographs:
        if here is None or there is None:
            continue
        for key, tolerance in OF_PANTOGRAPH.items():
            pair = getattr(run.pantographs[here], key), getattr(measured.pantographs[there], key)
            found.append(_row(places, name, key, pair, tolerance=tolerance, run=run))
    for key, tolerance in OF_LINE.items():
        pair = getattr(run, key), getattr(measured, key)
        found.append(_row(places, None, key, pair, tolerance=tolerance, run=run))
    return found


def _row(
    places: tuple[int, int],
    pantograph: str | None,
    key: str,
    pair: tuple[float | None, float | None],
    *,
    tolerance: Tolerance | None,
    run: Assessment,
) -> Accepted:
    simulated, measured = pair
    quantity = QUANTITIES[key]
    known = simulated is not None and measured is not None
    difference = simulated - measured if simulated is not None and measured is not None else None
    percent = None
    if difference is not None and measured and quantity.unit != "%":
        percent = 100.0 * difference / abs(measured)
    within = None
    if tolerance is not None and known:
        assert simulated is not None
        assert measured is not None
        within = tolerance.allows(simulated, measured)
    return Accepted(
        *places, pantograph, key,
        label_of(key, low_pass_Hz=run.low_pass_Hz, band_split_Hz=run.band_split_Hz),
        quantity.unit, quantity.decimals, simulated, measured, difference, percent,
        None if tolerance is None else tolerance.text(quantity.unit), within,
        None if tolerance is None else MARK,
        None if tolerance is None else SOURCE,
    )  # fmt: skip
