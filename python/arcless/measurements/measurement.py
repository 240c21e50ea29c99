"""A measured test run."""

from dataclasses import dataclass
from pathlib import Path

from arcless.errors import MeasurementError
from arcless.measurements.samples.pantograph import MeasuredPantograph


@dataclass(frozen=True, eq=False)
class Measurement:
    """Measured contact forces of a test run, as `read` returns them.

    Attributes
    ----------
    name
        Name of the file, without its ending.
    path
        The file.
    pantographs
        Samples that count, for each pantograph.
    notes
        Remarks on how the file was read.
    """

    name: str
    path: Path
    pantographs: tuple[MeasuredPantograph, ...]
    notes: tuple[str, ...]

    def pantograph(self, name: str) -> MeasuredPantograph:
        """Return the samples of one pantograph.

        Raises
        ------
        MeasurementError
            There is none of that name.
        """
        for each in self.pantographs:
            if each.name == name:
                return each
        known = ", ".join(each.name for each in self.pantographs)
        raise MeasurementError(
            "unknown pantograph", where=str(self.path), got=f"`{name}`", expected=known
        )

    def __repr__(self) -> str:
        each = ", ".join(
            f"{one.name}: {one.force.size} samples at {one.rate_Hz:g} Hz"
            for one in self.pantographs
        )
        return f"<Measurement {self.name}: {each}>"
