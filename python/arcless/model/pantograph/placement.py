"""A pantograph on the train: which, how far behind the first one, with what force."""

from typing import Annotated

from pydantic import Field, PrivateAttr, model_validator

from arcless.errors import ModelError
from arcless.model.fields.part import Name, Part, Unit
from arcless.model.fields.rule_errors import both_given
from arcless.model.pantograph.controller import Controller
from arcless.model.pantograph.pantograph import Pantograph
from arcless.model.pantograph.roof import RoofMotion
from arcless.model.pantograph.spacing import TSI, Word, tsi_spacing

# Variables of an FMU that fields of a placement need.
_NEEDED = {
    "mean_force": "static_force",
    "roof_motion": "base_height",
    "controller": "control_force",
}


class PantographPlacement(Part):
    """A pantograph on the train, and the force it is run with."""

    model: Pantograph = Field(
        description="Pantograph: shipped name, file relative to this one, or written here.",
        json_schema_extra={"reference": "pantograph"},
    )
    name: Name = Field(default="", description="Name in results; P1, P2, … without it.")
    distance_: Annotated[float | Word, Unit("m", minimum=0, words=(TSI,))] = Field(
        default=0.0,
        alias="distance",
        description="Distance behind the first pantograph; tsi: behind the one before it, that of"
        " the TSI for the speed (200 m from 250 km/h, 85 m above 120, 15 m above 80, else 8 m).",
    )
    static_force: Annotated[float, Unit("N", above=0, maximum=2000)] | None = Field(
        default=None, description="Static force; excludes mean_force."
    )
    mean_force: Annotated[float, Unit("N", above=0, maximum=2000)] | None = Field(
        default=None, description="Mean contact force to reach; the static force is then found."
    )
    sway: Annotated[float, Unit("m", minimum=0, maximum=1)] = Field(
        default=0.0,
        description="Largest displacement of the collector head across the track by roll of the"
        " vehicle and by tolerances of the track; added to the lateral position that is assessed.",
    )
    roof_motion: RoofMotion | None = Field(
        default=None, description="Vertical motion of the roof below; the roof is still without."
    )
    controller: Controller | None = Field(
        default=None, description="A force decided on during the run; none without."
    )

    # Where the distance is a word, what it is at the speed of the scenario, in m.
    _found: float | None = PrivateAttr(default=None)

    @model_validator(mode="after")
    def _check_force(self) -> "PantographPlacement":
        if self.static_force is not None and self.mean_force is not None:
            raise both_given(
                "static_force",
                "mean_force",
                expected="one of the two",
                hint="leave static_force out: mean_force finds it",
            )
        if self.start_force is None:
            raise ModelError(
                "no force given",
                expected="static_force or mean_force, since the pantograph has no static_force",
                field=("static_force",),
            )
        return self

    @model_validator(mode="after")
    def _check_fmu(self) -> "PantographPlacement":
        """Refuse what an FMU has no variable for."""
        fmu = self.model.fmu
        if fmu is None:
            return self
        for field, variable in _NEEDED.items():
            if getattr(self, field) is not None and getattr(fmu, variable) is None:
                raise ModelError(
                    "the FMU has no variable for it",
                    expected=f"model.fmu.{variable}, the name of a variable of the FMU",
                    hint=f"name one, or leave {field} out",
                    field=(field,),
                )
        if self.controller is not None and self.controller.mass is not None:
            raise ModelError(
                "no such mass",
                got=f"{self.controller.mass}",
                expected="no mass for an FMU: its control_force acts where the FMU says",
                field=("controller", "mass"),
            )
        return self

    @property
    def distance(self) -> float:
        """Distance behind the first pantograph in m, also when it is given by a word."""
        if not isinstance(self.distance_, str):
            return self.distance_
        assert self._found is not None  # a scenario sets it before anything asks
        return self._found

    def in_words(self) -> str:
        """Return model, force, and distance behind the first pantograph, in words."""
        kind = "static" if self.mean_force is None else "mean"
        behind = f", {self.distance:g} m behind the first" if self.distance else ""
        return f"{self.model.name}, {kind} force {self.start_force:g} N{behind}"

    def at(self, distance: float) -> "PantographPlacement":
        """Return a copy that knows its distance behind the first pantograph in m."""
        placed = self.model_copy()
        placed._found = distance
        return placed

    @property
    def start_force(self) -> float | None:
        """The force given: static or mean here, otherwise the pantograph's static force, in N."""
        given = self.static_force if self.static_force is not None else self.mean_force
        return given if given is not None else self.model.static_force


def placed(
    placements: tuple[PantographPlacement, ...], speed: float
) -> tuple[PantographPlacement, ...]:
    """Return pantographs that know the distances which words stand for at a speed in m/s."""
    found: list[PantographPlacement] = []
    for placement in placements:
        if isinstance(placement.distance_, str):
            before = found[-1].distance if found else 0.0
            found.append(placement.at(before + tsi_spacing(speed)))
        else:
            found.append(placement)
    return tuple(found)
