"""Monitors of runs: evaluate outputs while a run steps, and decide whether it continues."""

from collections.abc import Mapping
from math import isinf

from arcless.simulate import Look
from arcless.study.definition.expressions import Expression, UndefinedError
from arcless.study.definition.quantities import values
from arcless.study.optimisation.constraints import FILTERED, RISING, Constraint, key_of
from arcless.study.optimisation.pruning import Comparison, Monitoring

# Faded part of the filter, times a force of a million newtons.
_FADED = 1e-6


class RunMonitor:
    """Watches the runs of one variant.

    Parameters
    ----------
    watch
        What for.
    outputs
        The expressions of the study.
    variables
        Values of the variables that are numbers, by name.
    searches
        Whether a static force is searched for. Then the first run, whose force is nearly the one
        that is searched for, stands for the last one, which nobody knows to be the last before it
        ends; and no constraint is hard.
    """

    def __init__(
        self,
        watch: Monitoring,
        outputs: Mapping[str, Expression],
        variables: Mapping[str, float],
        *,
        searches: bool,
    ) -> None:
        self._watch, self._outputs, self._variables = watch, outputs, variables
        self._hard = () if searches else watch.hard
        self.places = [number / watch.looks for number in range(1, watch.looks)]
        self.so_far: dict[str, list[float | None]] = {name: [] for name in watch.seen}

    def see(self, look: Look) -> str | None:
        """Return why the run is to be stopped; None to continue."""
        if look.run > 1:
            return None
        numbers = {**values(look.assessment), **self._variables}
        for name, known in self.so_far.items():
            known.append(self._value(name, numbers))
        where = f"at {look.position_m:.6g} m, {look.time_s:.6g} s"
        for bound in self._hard:
            value = self._certain(bound, numbers, look)
            if value is not None and bound.excess(value) > 0.0:
                self.so_far[bound.output][-1] = value
                limit = bound.at_most if bound.at_most is not None else bound.at_least
                found = f"{bound.output} is {value:.6g} {where}"
                return f"{found}, {limit:g} is allowed: it can only get worse"
        behind = (self._behind(test) for test in self._watch.comparisons)
        return next((f"{why} ({where})" for why in behind if why is not None), None)

    def _behind(self, test: Comparison) -> str | None:
        """Return why a run is not as good as it has to be at its last look; None if it is."""
        known = self.so_far[test.output]
        if len(known) > len(test.bars) or known[-1] is None:
            return None
        bar = test.bars[len(known) - 1]
        seen = [test.measure(value) for value in known if value is not None]
        measure = min(seen) if test.best_so_far else seen[-1]
        if isinf(bar.limit) or measure <= bar.limit:
            return None
        of = test.output if test.constraint is None else f"the excess of {test.output}"
        shown = test.sign * measure
        return f"{of} so far {shown:.6g}; {bar.words}"

    def _certain(
        self, bound: Constraint, numbers: Mapping[str, float | None], look: Look
    ) -> float | None:
        """Return a value that the output will at least reach, on the side of the bound."""
        expression = self._outputs[bound.output].text
        key = key_of(expression)
        value = self._value(bound.output, numbers)
        if key in FILTERED:
            settled = look.settled()
            if settled is None:
                return None
            value = self._value(bound.output, {**values(settled), **self._variables})
            return None if value is None else value - (_FADED if key in RISING else -_FADED)
        if key == "contact_loss_percent" and value is not None:
            return value * look.share
        return value

    def _value(self, name: str, numbers: Mapping[str, float | None]) -> float | None:
        try:
            return self._outputs[name].value(numbers)
        except UndefinedError:
            return None
