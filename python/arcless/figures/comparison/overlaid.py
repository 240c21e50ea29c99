"""Runs that are laid over each other: names, colours, and whether their lines are alike.

The first run is drawn last, above the others, and is then the first of the legend.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from arcless.figures.description import Axis, Layer, Rules, Strip
from arcless.figures.description.thinning import every
from arcless.figures.description.tokens import of_series
from arcless.figures.run import RunData
from arcless.figures.run.track import GROUP, LABEL, MARKS

# Supports of two lines stand at the same places within this, in m, and sections end there.
SAME_PLACE_M = 1e-3


@dataclass(frozen=True)
class Overlaid:
    """Runs to draw together.

    Attributes
    ----------
    names
        What the legend calls them.
    runs
        The runs.
    """

    names: Sequence[str]
    runs: Sequence[RunData]

    def colour(self, run: int) -> str:
        """Return the token of a run's colour, the same in all figures."""
        return of_series(run)

    @property
    def same_supports(self) -> bool:
        """True when all lines have their supports at the same places."""
        first = self.runs[0].supports
        return all(
            one.supports.shape == first.shape
            and bool(np.allclose(one.supports, first, rtol=0.0, atol=SAME_PLACE_M))
            for one in self.runs[1:]
        )

    @property
    def same_section(self) -> bool:
        """True when all runs are assessed over the same section."""
        first = self.runs[0].assessment.section_m
        return all(
            np.allclose(one.assessment.section_m, first, rtol=0.0, atol=SAME_PLACE_M)
            for one in self.runs[1:]
        )

    @property
    def remark(self) -> str:
        """A sentence where supports or sections differ; empty where they do not."""
        said = ""
        if not self.same_supports:
            lengths = {f"{float(np.ptp(one.supports)):.0f}" for one in self.runs
                       if one.supports.size}  # fmt: skip
            what = "in length and supports" if len(lengths) > 1 else "in their supports"
            said = f" The lines differ {what}: marked are the supports of {self.names[0]}."
        if not self.same_section:
            said += f" The shaded analysis section is that of {self.names[0]}; others differ."
        return said

    def axis(self) -> Axis:
        """Return the axis along the track, long enough for every run."""
        begin = min(float(one.position[0].min()) for one in self.runs)
        end = max(float(one.position[-1].max()) for one in self.runs)
        places = np.concatenate([[begin, end], *(one.supports for one in self.runs)])
        margin = 0.01 * (end - begin)
        bounds = (float(places.min()) - margin, float(places.max()) + margin)
        return Axis(LABEL, "m", begin - margin, end + margin, bounds, group=GROUP)

    def ground(self) -> list[Layer]:
        """Return section and supports of the first run."""
        run = self.runs[0]
        begin, end = run.assessment.section_m
        below: list[Layer] = [Strip(axis="x", low=begin, high=end, colour="section", alpha=0.06)]
        if run.supports.size:
            at = run.supports[every(run.supports.size, MARKS)]
            below.append(Rules(axis="x", at=at, colour="support", name="support", dash="dotted"))
        return below

    def mean_of(self, run: int, pantograph: int) -> str:
        """Return name, mean and deviation of a run, for those who do not see the figure."""
        numbers = self.runs[run].assessment.pantographs[pantograph]
        return (
            f"{self.names[run]}: mean {numbers.mean_force_N:.1f} N, standard deviation"
            f" {numbers.std_force_N:.1f} N"
        )
