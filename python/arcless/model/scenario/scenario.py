"""A scenario whose parts fit together, and what a run of it takes."""

from collections.abc import Mapping
from functools import cached_property
from typing import Any

from pydantic import ConfigDict, model_validator

from arcless.display import cards
from arcless.model.pantograph.placement import placed
from arcless.model.scenario.as_built_rules import check_as_built
from arcless.model.scenario.as_typed import changes_of
from arcless.model.scenario.overrides import apply
from arcless.model.scenario.scenario_data import ScenarioData
from arcless.model.scenario.scenario_rules import check_scenario, check_speed
from arcless.model.scenario.step_rules import check_controllers, check_steps
from arcless.model.scenario.stepping import Choice, choose, time_step_of
from arcless.model.settings.certainty import spelt_out
from arcless.model.settings.run_settings import Solver
from arcless.units import plain


class Scenario(ScenarioData):
    """A scenario: line, pantographs, speed, solver, analysis section and output."""

    model_config = ConfigDict(defer_build=False)

    @classmethod
    def prepare(cls, data: dict[str, Any]) -> dict[str, Any]:
        """Name the pantographs P1, P2, … where no name is given; spell certainty out."""
        data = spelt_out(data)
        placements = data.get("pantographs")
        if not isinstance(placements, (list, tuple)):
            return data
        named = [
            {**item, "name": item.get("name") or f"P{index}"} if isinstance(item, dict) else item
            for index, item in enumerate(placements, start=1)
        ]
        return {**data, "pantographs": named}

    def in_words(self) -> list[str]:
        """Return line, speed and number of pantographs, in words."""
        count = len(self.pantographs)
        pantographs = f"{count} {'pantograph' if count == 1 else 'pantographs'}"
        return [f"line {plain(self.line.name)}", self._speed_in_words(), pantographs]

    def _speed_in_words(self) -> str:
        text = f"{3.6 * self.top_speed:.4g} km/h"
        return text if self.speed is not None else f"up to {text}"

    def _repr_html_(self) -> str:
        begin, end = self.analysis_range()
        rows = [
            ("Line", f"{self.line.name}: {self.line.in_words()[0]}"),
            *((f"Pantograph {one.name}", one.in_words()) for one in self.pantographs),
            ("Speed", self.as_typed("speed") or self._speed_in_words()),
            ("Supply", self.line.design.supply or "not given"),
            ("State", "as designed" if self.as_built.is_empty else "as built"),
            ("Analysis section", f"{begin:g} – {end:g} m"),
        ]
        line = cards.folded("Line", *self.line.card_parts())
        title = f"Scenario {self.name}"
        return cards.card(title, cards.facts(rows), line, about=self.description)

    @model_validator(mode="after")
    def _check(self) -> "Scenario":
        check_speed(self)
        if any(isinstance(placement.distance_, str) for placement in self.pantographs):
            # The fields are those given: only what follows from them is put in.
            object.__setattr__(self, "pantographs", placed(self.pantographs, self.top_speed))
        check_scenario(self)
        check_steps(self, self.stepping)
        check_controllers(self, self.time_step_s)
        check_as_built(self)
        return self

    @cached_property
    def choice(self) -> Choice:
        """Settings that a run takes where `solver` leaves them to auto, and the reason."""
        return choose(self)

    def model_copy(
        self, *, update: Mapping[str, Any] | None = None, deep: bool = False
    ) -> "Scenario":
        """Return a copy that chooses again: the changes may change the choice."""
        copied = super().model_copy(update=update, deep=deep)
        copied.__dict__.pop("choice", None)
        return copied

    @property
    def stepping(self) -> Solver:
        """The solver settings of a run: with nothing left to auto."""
        return self.choice.solver

    @property
    def time_step_s(self) -> float:
        """Time step in s, also when it is given as one element or left to auto."""
        return time_step_of(self, self.stepping)

    @property
    def changes(self) -> dict[str, str]:
        """Fields that were set since the scenario was read, by dotted path, values as typed."""
        return changes_of(self.to_dict())

    def with_(self, **changes: Any) -> "Scenario":
        """Return a changed copy; this scenario stays as it is.

        Parameters
        ----------
        **changes
            New values by dotted path: ``with_(speed="300 km/h")`` or, with dots,
            ``with_(**{"line.contact_wire.tension": "24 kN"})``. List items are numbered from 0.

        Returns
        -------
        Scenario
            The copy, validated as a file is.
        """
        return apply(self, changes)
