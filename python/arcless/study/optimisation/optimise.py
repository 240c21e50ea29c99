"""Optimisation: a design that chooses its next variants by the outputs of earlier ones."""

from collections.abc import Collection, Mapping, Sequence

from arcless.errors import ModelError
from arcless.model import Scenario
from arcless.model.fields.part import nearest
from arcless.study.designs.plan import refuse_drawn
from arcless.study.optimisation.constraints import Constraint, check_hard
from arcless.study.optimisation.search import Search
from arcless.study.optimisation.search_settings import SearchSettings
from arcless.study.variables.variables import Axis
from arcless.units import show


class Optimise(SearchSettings):
    """A search for the best values by Optuna."""

    def plan(self, axes: Sequence[Axis], seed: int) -> Search:
        """Return the plan, which fills during the search."""
        for axis in axes:
            refuse_drawn(axis, "an optimisation")
        return Search.of(self, tuple(axes), seed)

    def check(
        self, outputs: Mapping[str, str], scenario: Scenario, varied: Collection[str]
    ) -> None:
        """Refuse objectives and constraints that are impossible.

        Parameters
        ----------
        outputs
            Expressions by name.
        scenario, varied
            The base, and the fields that are varied.

        Raises
        ------
        ModelError
            An output that there is not; a constraint without bound; one that is hard on what may
            still get better, or where a mean force is searched for.
        """
        named: list[tuple[str, tuple[str, ...]]] = [
            (name, ("design", "objectives", name)) for name in self.objectives
        ]
        named += [
            (bound.output, ("design", "constraints", str(index), "output"))
            for index, bound in enumerate(self.constraints)
        ]
        for name, place in named:
            if name not in outputs:
                hint = nearest(name, list(outputs))
                expected = "the name of an output"
                raise ModelError("no output", got=show(name), expected=expected, hint=hint,
                                 field=place)  # fmt: skip
        searches = any(
            placed.mean_force is not None
            and not {"pantographs", f"pantographs.{i}", f"pantographs.{i}.static_force"} & {*varied}
            for i, placed in enumerate(scenario.pantographs)
        )
        for index, bound in enumerate(self.constraints):
            try:
                self._check_bound(bound, outputs[bound.output], searches=searches)
            except ModelError as error:
                error.field = ("design", "constraints", str(index), *error.field)
                raise

    @staticmethod
    def _check_bound(bound: Constraint, expression: str, *, searches: bool) -> None:
        if bound.at_most is None and bound.at_least is None:
            raise ModelError("no bound", expected="at_most or at_least")
        if not bound.hard:
            return
        check_hard(bound, expression)
        if searches:
            raise ModelError(
                "a hard constraint in a search for a mean force",
                expected="static_force: none of several runs is known to be the one that counts",
                hint="leave `hard` away; `pruning` looks at the first run of the search",
                field=("hard",),
            )
