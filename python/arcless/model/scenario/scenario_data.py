"""Fields of a scenario, and what follows from them: speed, duration, places along the line."""

from typing import Annotated, Literal

from pydantic import ConfigDict, Field, model_validator

from arcless.errors import ModelError
from arcless.model.as_built.as_built import AsBuilt
from arcless.model.fields.document import Document
from arcless.model.fields.extremes import LEAST_FREQUENCY
from arcless.model.fields.part import Part, Unit
from arcless.model.fields.rule_errors import both_given
from arcless.model.line.line import Line
from arcless.model.pantograph.placement import PantographPlacement
from arcless.model.settings.certainty import Certainty
from arcless.model.settings.run_settings import MAX_SPEED, Contact, Output, Solver, SpeedProfile
from arcless.model.settings.wear import WearModel
from arcless.units import WRONG_VALUE, show

MAX_PANTOGRAPHS = 8


class Travel(Part):
    """Where the first pantograph starts and ends."""

    start: Annotated[float, Unit("m", minimum=0)] | None = Field(
        default=None,
        description="Start; by default the last pantograph starts one span in.",
    )
    end: Annotated[float, Unit("m", minimum=0)] | None = Field(
        default=None, description="End; without it, one span before the end of the line."
    )


SpanNumber = Annotated[int, Field(ge=1, strict=True)]


class Analysis(Part):
    """The section that is assessed, and its filters."""

    from_: Annotated[float, Unit("m", minimum=0)] | None = Field(
        default=None, alias="from", description="Start of the section; excludes spans."
    )
    to: Annotated[float, Unit("m", minimum=0)] | None = Field(
        default=None, description="End of the section; excludes spans."
    )
    spans: tuple[SpanNumber, SpanNumber] | None = Field(
        default=None, description="First and last span of the section, counted from 1."
    )
    low_pass: Annotated[float, Unit("Hz", minimum=LEAST_FREQUENCY, maximum=1000)] = Field(
        default=20.0, description="Cut-off frequency of the low-pass filter."
    )
    band_split: Annotated[float, Unit("Hz", minimum=LEAST_FREQUENCY, maximum=1000)] = Field(
        default=5.0, description="Frequency between the lower and the upper band."
    )

    @model_validator(mode="after")
    def _check_section(self) -> "Analysis":
        if self.spans is not None and (self.from_ is not None or self.to is not None):
            raise both_given("spans", "from/to", at=("spans",))
        if self.spans is not None and self.spans[0] > self.spans[1]:
            raise ModelError(
                "spans out of order",
                got=show(f"{self.spans[0]}, {self.spans[1]}"),
                expected="first and last span, counted from 1",
                field=("spans",),
            )
        if self.from_ is not None and self.to is not None and self.from_ >= self.to:
            raise ModelError(
                "empty section",
                got=f"{self.from_:g} m to {self.to:g} m",
                expected="from before to",
                field=("to",),
            )
        if self.band_split >= self.low_pass:
            raise ModelError(
                WRONG_VALUE,
                got=f"{self.band_split:g} Hz",
                expected=f"less than low_pass, {self.low_pass:g} Hz",
                field=("band_split",),
            )
        return self


class ScenarioData(Document):
    """A scenario as its file has it: line, pantographs, speed, solver, section and output."""

    # Validated is only what follows from it: a validator of its own costs 10 ms of every start.
    model_config = ConfigDict(defer_build=True)

    format: Literal["arcless-scenario/1"] = Field(
        default="arcless-scenario/1", description="Format and version."
    )
    line: Line = Field(
        description="Line: shipped name, file relative to this one, or written here.",
        json_schema_extra={"reference": "line"},
    )
    pantographs: tuple[PantographPlacement, ...] = Field(
        description="Pantographs, the leading one first.", min_length=1, max_length=MAX_PANTOGRAPHS
    )
    speed: Annotated[float, Unit("m/s", above=0, maximum=MAX_SPEED)] | None = Field(
        default=None, description="Constant speed; excludes speed_profile."
    )
    speed_profile: SpeedProfile | None = Field(default=None, description="Speed over time.")
    as_built: AsBuilt = Field(
        default_factory=AsBuilt,
        description="How the line differs from its design: as built, and in the weather.",
    )
    contact: Contact = Field(default_factory=Contact, description="Contact of strip and wire.")
    travel: Travel = Field(default_factory=Travel, description="Travel of the first pantograph.")
    solver: Solver = Field(default_factory=Solver, description="Time step, scheme, elements.")
    analysis: Analysis = Field(default_factory=Analysis, description="Section and filters.")
    output: Output = Field(default_factory=Output, description="What is recorded.")
    wear: WearModel | None = Field(
        default=None, description="Coefficients of wear, which is assessed then; none without."
    )
    certainty: Certainty | None = Field(
        default=None,
        description="Repeats that say how sure the numbers are, or the number of starts alone;"
        " none without.",
    )

    @property
    def top_speed(self) -> float:
        """Highest speed in m/s."""
        if self.speed is not None:
            return self.speed
        assert self.speed_profile is not None
        return max(self.speed_profile.speed)

    @property
    def duration(self) -> float:
        """Time in s that a run takes at most."""
        start, end = self.travel_range()
        if self.speed is not None:
            return (end - start) / self.speed
        assert self.speed_profile is not None
        return self.speed_profile.time[-1]

    def travel_range(self) -> tuple[float, float]:
        """Return start and end of the first pantograph's travel in m.

        Without `travel`, the last pantograph starts at the second support, so that every one runs
        at least one span from the end of the line, and the first ends one span before the end.
        """
        supports = self.line.support_positions()
        start, end = self.travel.start, self.travel.end
        first = supports[1] + self.pantographs[-1].distance if start is None else start
        return first, supports[-2] if end is None else end

    def analysis_range(self) -> tuple[float, float]:
        """Return start and end of the analysis section in m.

        Without `analysis.spans`, `from` and `to`: the inner half of the spans, never the first two
        or the last two, cut to what every pantograph travels. When nothing is left of that, the
        whole travel of the first pantograph; `scenario_warnings` says so.
        """
        supports = self.line.support_positions()
        if self.analysis.spans is not None:
            first, last = self.analysis.spans
            return supports[first - 1], supports[last]
        start, end = self.default_section() or self.travel_range()
        given_start, given_end = self.analysis.from_, self.analysis.to
        return (
            start if given_start is None else given_start,
            end if given_end is None else given_end,
        )

    def default_section(self) -> tuple[float, float] | None:
        """Return the inner spans that every pantograph travels in m, or None if there are none."""
        supports = self.line.support_positions()
        spans = len(supports) - 1
        skipped = max(2, -(-spans // 4))
        if spans - 2 * skipped < 1:
            return None
        start, end = self.travel_range()
        start = max(start, supports[skipped])
        end = min(end - self.pantographs[-1].distance, supports[spans - skipped])
        return (start, end) if start < end else None
