"""Wind over time, at one or several places along the line."""

from itertools import pairwise
from typing import Annotated

from pydantic import Field, model_validator

from arcless.errors import ModelError
from arcless.model.fields import extremes
from arcless.model.fields.list_checks import check_count
from arcless.model.fields.part import Part, Unit

MAX_ROWS = 100_000
FEWEST = 2

Speeds = Annotated[
    tuple[Annotated[float, Unit("m/s", minimum=-100, maximum=100)], ...],
    Field(max_length=MAX_ROWS),
]


class Gusts(Part):
    """Wind over time; every entry of its lists is one reading, the places in any order."""

    time: Annotated[
        tuple[Annotated[float, Unit("s", minimum=-extremes.TIME, maximum=extremes.TIME)], ...],
        Field(max_length=MAX_ROWS),
    ] = Field(description="Time of each reading since the start of the run.")
    position: (
        Annotated[
            tuple[
                Annotated[float, Unit("m", minimum=-extremes.PLACE, maximum=extremes.PLACE)], ...
            ],
            Field(max_length=MAX_ROWS),
        ]
        | None
    ) = Field(
        default=None,
        description="Place of each reading along the line; without it, the same wind everywhere.",
    )
    speed: Speeds = Field(description="Wind speed across the track, positive towards positive y.")
    vertical: Speeds | None = Field(
        default=None, description="Wind speed upwards; without it, under the angle of the wind."
    )

    @model_validator(mode="after")
    def _check_lists(self) -> "Gusts":
        for name in ("position", "speed", "vertical"):
            check_count(getattr(self, name), len(self.time), "time", (name,))
        for place, rows in self.stations().items():
            where = "" if self.position is None else f" at {place:g} m"
            if len(rows) < FEWEST:
                raise ModelError(
                    f"too few readings{where}",
                    got="1",
                    expected=f"at least {FEWEST}",
                    field=("time",),
                )
            for earlier, later in pairwise(rows):
                if self.time[later] <= self.time[earlier]:
                    raise ModelError(
                        f"readings out of order{where}",
                        got=f"{self.time[later]:g} s after {self.time[earlier]:g} s",
                        expected="a time that increases",
                        field=("time", later),
                    )
        return self

    def stations(self) -> dict[float, list[int]]:
        """Return the places in m in their order along the line, and the readings at each."""
        found: dict[float, list[int]] = {}
        places = self.position or (0.0,) * len(self.time)
        for row, place in enumerate(places):
            found.setdefault(place, []).append(row)
        return dict(sorted(found.items()))
