"""Data that a measured file does not have, as the page gives them: speed, supply, head mass."""

from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

from arcless.assess.rules import ANY_SUPPLY
from arcless.comparison import cells
from arcless.errors import ModelError
from arcless.measurements import Head, Measurement, assess, read
from arcless.report import tables
from arcless.studio.answers.answers import Refused
from arcless.studio.answers.page_words import in_page_words

# Characters of an amount with its unit.
LONGEST = 100


@dataclass(frozen=True)
class MeasuredAs:
    """Amounts with their units, as typed; None where nobody gave one.

    Attributes
    ----------
    speed
        Constant speed of a file without a column of it.
    supply
        Electrical supply whose limits decide, where the measurement is assessed alone.
    head_mass, head_lift
        Of what is above the force sensors.
    """

    speed: str | None = None
    supply: str | None = None
    head_mass: str | None = None
    head_lift: str | None = None

    def read(self, file: Path) -> Measurement:
        """Read a measured file by these.

        Raises
        ------
        MeasurementError
            The file is no measurement, or the speed is none of a train.
        ModelError
            An amount is none, or there is a lift without a mass.
        """
        return read(file, speed=self.speed, head=self._head())

    def _head(self) -> Head | None:
        if self.head_mass is None:
            if self.head_lift is None:
                return None
            raise ModelError("head lift without head mass", expected="the mass above the sensors")
        try:
            return Head.of(self.head_mass, self.head_lift)
        except ModelError as error:
            error.where = "head mass, head lift" if error.where is None else error.where
            raise


def measured_as(given: object) -> MeasuredAs:
    """Return what an object of JSON gives; empty texts give nothing.

    Raises
    ------
    Refused
        It is no object of short texts by known names.
    """
    known = {one.name for one in fields(MeasuredAs)}
    if not isinstance(given, dict) or not known.issuperset(given):
        raise Refused(400, f"What a measurement is read as has other parts than {sorted(known)}")
    if not all(isinstance(one, str) and len(one) <= LONGEST for one in given.values()):
        raise Refused(400, "What a measurement is read as is not short texts")
    return MeasuredAs(**{name: text.strip() or None for name, text in given.items()})


def assessed_alone(file: Path, how: MeasuredAs) -> dict[str, Any]:
    """Return numbers, criteria and remarks of a measurement, as `arcless assess FILE` finds them.

    Raises
    ------
    MeasurementError, ModelError
        As of `MeasuredAs.read`; or too little of the record is left, or there is no such supply.
    """
    measurement = how.read(file)
    found = assess(measurement, supply=how.supply)
    return {
        "name": measurement.name,
        "about": f"{cells.section(found)}, {cells.speed(found)}",
        "pantographs": [one.name for one in found.pantographs],
        "numbers": tables.indicator_rows(found),
        "criteria": [tables.criterion_row(one) for one in found.criteria],
        "notes": [in_page_words(text) for text in found.notes],
        "supplies": list(ANY_SUPPLY),
    }
