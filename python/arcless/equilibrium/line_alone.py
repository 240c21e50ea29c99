"""A line by itself, where a scenario would say on which elements it rests and what was built."""

from dataclasses import dataclass

from arcless.model import Line
from arcless.model.as_built.as_built import AsBuilt
from arcless.model.scenario.other_family import CUBIC, CUBIC_STEP
from arcless.model.settings.run_settings import Solver
from arcless.model.settings.schemes import GeneralisedAlpha

# Elements of a line that nobody runs on: cubic ones, fine enough for forces at rest within 0.3 %.
ALONE = Solver(
    scheme=GeneralisedAlpha(name="generalised-alpha"),
    time_step=CUBIC_STEP,
    wire_model="hermite",
    residual_flexibility=True,
    contact_wire_element=CUBIC,
    messenger_wire_element=CUBIC,
)


@dataclass(frozen=True)
class LineAlone:
    """A line as designed, without a scenario; it has what a scenario has to say of a line at rest.

    Attributes
    ----------
    line
        The line.
    elements
        What it is divided into.
    """

    line: Line
    elements: Solver = ALONE

    @property
    def name(self) -> str:
        """Name of the line."""
        return self.line.name

    @property
    def as_built(self) -> AsBuilt:
        """Nothing differs from the design."""
        return AsBuilt()

    @property
    def stepping(self) -> Solver:
        """Elements that the line is divided into."""
        return self.elements
