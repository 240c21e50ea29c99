"""Sensitivity of σ to parameters of line and pantographs, by central differences of whole runs.

With the deviation σ(p) of runs that differ in one parameter alone, over the relative step h,

    E_h = ln(σ(p(1 + h))/σ(p(1 − h))) / ln((1 + h)/(1 − h))

is the change of σ in % for 1 % of p. Its error is of second order, so that it differs from E_{h/2}
by three quarters of it where σ is smooth; where σ scatters (droppers that slacken, time steps), the
difference shows that: it is the uncertainty that is told. Runs go through `batch`: those that share
a line share its statics.

Source: J. Nocedal & S. J. Wright, Numerical Optimization, 8.1 (central differences), from
memory (C).
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from math import log

from arcless.assess import Assessment
from arcless.display.numbers import signed
from arcless.errors import ModelError
from arcless.explanation import Effect, Sensitivities, Sensitivity
from arcless.explanation.sensitivity import LEAST
from arcless.model import Scenario
from arcless.results import Result
from arcless.simulate.batches.batch import Outcome, batch
from arcless.simulate.runs.job import Cancel, Progress

# Whole step in % that is usual, and its limits. Smaller, σ scatters by more than it changes;
# larger, the answer is no slope any more.
STEP_PERCENT, LEAST_PERCENT, MOST_PERCENT = 5.0, 0.1, 30.0


@dataclass(frozen=True)
class Parameter:
    """A value that is varied: name in words, the fields that have it, SI value of each."""

    name: str
    values: dict[str, float]

    def varied(self, scenario: Scenario, factor: float) -> Scenario:
        """Return the scenario with the values times a factor."""
        return scenario.with_(**{path: factor * value for path, value in self.values.items()})


def sensitivities(
    run: Result | Scenario,
    *,
    step_percent: float = STEP_PERCENT,
    workers: int | None = None,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> Sensitivities:
    """Compute how σ of the contact force follows dropper stiffness, tensions and masses.

    Four runs for each parameter and one as it is, each with the mean force found again where the
    scenario gives one.

    Parameters
    ----------
    run
        A scenario, or a result, whose scenario is taken.
    step_percent
        Step of the differences in % of each parameter.
    workers, progress, cancel
        As `arcless.batch` takes them.

    Raises
    ------
    ModelError
        The step is out of range.
    ArclessError
        The scenario as it is cannot be run.
    """
    if not LEAST_PERCENT <= step_percent <= MOST_PERCENT:
        raise ModelError(
            "step of the differences",
            got=f"{step_percent:g} %",
            expected=f"{LEAST_PERCENT:g} to {MOST_PERCENT:g} %",
        )
    scenario = run.scenario if isinstance(run, Result) else run
    scenario = scenario.model_copy(update={"certainty": None})
    chosen = list(parameters(scenario))
    step = step_percent / 100.0
    factors = (1.0 - step, 1.0 - step / 2.0, 1.0 + step / 2.0, 1.0 + step)
    made, found = variants(scenario, chosen, factors)
    own, *varied = batch(made, workers=workers, progress=progress, cancel=cancel)
    if own.error is not None or own.assessment is None:
        raise own.error or AssertionError("a run that is not watched is not stopped")
    runs = iter(varied)
    for one in chosen:
        if one.name not in found:
            four = list(islice(runs, len(factors)))
            found[one.name] = _sensitivity(one, own.assessment, four, factors)
    told = tuple(found[one.name] for one in chosen)
    return Sensitivities(step_percent, len(made), told, tuple(_left_out(scenario)))


def variants(
    scenario: Scenario, chosen: Sequence[Parameter], factors: Sequence[float]
) -> tuple[list[Scenario], dict[str, Sensitivity]]:
    """Return the scenario and its variants, and the parameters that cannot be varied."""
    made, found = [scenario], dict[str, Sensitivity]()
    for one in chosen:
        try:
            made += [one.varied(scenario, factor) for factor in factors]
        except ModelError as error:
            found[one.name] = Sensitivity(one.name, tuple(one.values), (), f"out of range: {error}")
    return made, found


def parameters(scenario: Scenario) -> Iterator[Parameter]:
    """Yield the parameters of a scenario that are varied."""
    line = scenario.line
    for name, part in (("dropper", line.dropper), ("hanger", line.hanger)):
        if part is not None:
            yield Parameter(f"{name} stiffness", {f"line.{name}.stiffness": part.stiffness})
    for field in ("contact_wire", "messenger_wire", "auxiliary_wire"):
        wire = getattr(line, field)
        if wire is not None and wire.tension > 0.0:
            words = field.replace("_", " ")
            yield Parameter(f"tension of the {words}", {f"line.{field}.tension": wire.tension})
    yield from _masses(scenario)


def _masses(scenario: Scenario) -> Iterator[Parameter]:
    """Yield the masses of each pantograph model, in all places where it stands."""
    models: dict[str, list[int]] = {}
    for number, placement in enumerate(scenario.pantographs):
        models.setdefault(placement.model.name, []).append(number)
    for name, numbers in models.items():
        model = scenario.pantographs[numbers[0]].model
        of = f" of {name}" if len(models) > 1 else ""
        for i, part in enumerate(model.masses):
            paths = [f"pantographs.{number}.model.masses.{i}.mass" for number in numbers]
            place = f"{i + 1} of {len(model.masses)}"
            words = f"pantograph mass {place} from the base{of}"
            # Without a head of its own, the last mass carries the strips.
            if model.head is None and i > 0 and i == len(model.masses) - 1:
                words = f"mass of the collector head ({place}){of}"
            yield Parameter(words, dict.fromkeys(paths, part.mass))
        if model.head is not None:
            paths = [f"pantographs.{number}.model.head.mass" for number in numbers]
            yield Parameter(f"strip mass{of}", dict.fromkeys(paths, model.head.mass))


def _left_out(scenario: Scenario) -> Iterator[str]:
    kinds = {one.model.name: one.model for one in scenario.pantographs if not one.model.masses}
    for name in sorted(kinds):
        kind = "given by matrices" if kinds[name].fmu is None else "an FMU"
        yield f"pantograph {name} is {kind}: it has no single masses to vary"


def _sensitivity(
    parameter: Parameter, own: Assessment, runs: Sequence[Outcome], factors: Sequence[float]
) -> Sensitivity:
    paths = tuple(parameter.values)
    for outcome, factor in zip(runs, factors, strict=True):
        if outcome.assessment is None:
            why = f"the run at {signed(100.0 * (factor - 1.0))} % failed: {outcome.error}"
            return Sensitivity(parameter.name, paths, (), why)
    found = []
    for place, pantograph in enumerate(own.pantographs):
        middle = pantograph.std_force_N
        values = [one.assessment.pantographs[place].std_force_N for one in runs if one.assessment]
        if min(middle, *values) <= 0.0:
            return Sensitivity(parameter.name, paths, (), "the contact force is constant")
        found.append(effect(pantograph.name, middle, values, factors))
    return Sensitivity(parameter.name, paths, tuple(found))


def effect(
    pantograph: str, middle: float, values: Sequence[float], factors: Sequence[float]
) -> Effect:
    """Return the effect of a parameter from five deviations.

    Parameters
    ----------
    pantograph
        Name of the pantograph.
    middle
        σ as it is, N.
    values, factors
        σ in N at four factors of the parameter: whole step down, half down, half up, whole up.
    """

    def slope(one: tuple[float, float], other: tuple[float, float]) -> float:
        return log(other[1] / one[1]) / log(other[0] / one[0])

    low, less, more, high = zip(factors, values, strict=True)
    whole, half = slope(low, high), slope(less, more)
    down, up = (100.0 * (1.0 - value / middle) for value in (values[0], values[-1]))
    below, above = slope(low, (1.0, middle)), slope((1.0, middle), high)
    uncertainty = abs(whole - half)
    return Effect(
        pantograph=pantograph,
        percent_per_percent=whole,
        uncertainty=uncertainty,
        below=below,
        above=above,
        significant=abs(whole) > max(uncertainty, LEAST),
        linear=abs(above - below) <= abs(whole),
        lowers_percent=max(down, up),
        better="less" if down >= up else "more",
    )
