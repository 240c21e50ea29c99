"""Laws for a controlled pantograph on three lines: none, a PID, and one that is learnt.

``python examples/control_baselines.py`` runs the laws of ``examples/control_laws`` and prints σ of
the contact force on a part of the line that they were not made on; it takes some minutes.
``--learn`` makes them first, with the extra ``control``: by CMA-ES in the environment of
``arcless.control``, in less than ten minutes on two cores, the same numbers from the same seed.
``--others`` runs the laws where they were not made: slower, on supports as built, with noise.
``--certainty 8`` says how sure each σ is.
"""

import argparse
import json
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

import arcless
from arcless import control
from arcless.model.pantograph.controller import Pid
from arcless.simulate.setup.pid import PidLaw

LAWS = Path(__file__).with_name("control_laws")
# A simple, a stitched and a compound line; spans that the laws are made on, and those that are
# assessed, counted from 1.
CASES = {
    "en50318-ac-simple-320-planar": ((3, 10), (11, 16)),
    "germany-re-330-300": ((3, 9), (10, 15)),
    "shinkansen-compound-240": ((3, 9), (10, 15)),
}
# Not the force that was asked for: fed back, it turns the law into an integrator, which can press
# more or less after all.
OBSERVE = tuple(name for name in control.DEFAULT if name != "asked_force_N")
# For the PID of a scenario, which sees the contact force; the learnt law does not.
PID_SEES = "contact_force_N"
PID = {"proportional": 1.0, "derivative": 0.05, "filter": 0.02}  # docs/guide/control.md
STARTS = 2  # of each candidate of a generation
GENERATIONS = 5, 40  # of the search for the PID, and for the law
SEED = 1
# Standard deviation of the noise of a sample, in the units of the signals, of good sensors.
NOISE = {
    "strip_force_N": 5.0,
    "frame_acceleration_m_s2": 1.0,
    "frame_displacement_m": 1e-4,
    "frame_velocity_m_s": 0.03,
}
MEAN_WITHIN, MOST_RUNS = 0.5, 12  # N
SUPPORT_ERROR = 0.01  # standard deviation of the height of a support as built, m
Floats = np.ndarray


def scored(case: str, spans: tuple[int, int]) -> tuple[float, float]:
    """Return from where to where these spans reach, m."""
    supports = arcless.load(case).line.support_positions()
    return supports[spans[0] - 1], supports[spans[1]]


def make_task(case: str) -> control.Task:
    """Prepare the line of a case; episodes are scored where the laws may be made."""
    stretch = scored(case, CASES[case][0])
    return control.task(case, observe=(*OBSERVE, PID_SEES), stretch_m=stretch)


def mean_return(
    task: control.Task, law: Callable[[Floats], Floats], candidates: int, seeds: list[int]
) -> Floats:
    """Return the mean return of candidates, each from the starts of the seeds.

    `law` takes what is seen, a row for each candidate and start, and returns forces in N.
    """
    count = candidates * len(seeds)
    env = control.PantographVectorEnv(count, task=task, autoreset=False)
    seen, _ = env.reset(seed=seeds * candidates)
    total, ended = np.zeros(count), np.zeros(count, dtype=bool)
    while not ended.all():
        action = law(seen)[:, None] / task.action_unit_N
        seen, rewards, terminated, truncated, _ = env.step(action)
        total += rewards
        ended |= terminated | truncated
    return total.reshape(candidates, len(seeds)).mean(axis=1)


class Pids:
    """PID laws side by side, a law of a scenario for each row that is seen."""

    def __init__(self, settings: list[dict[str, float]], target: float, sample_time: float) -> None:
        self.laws = [PidLaw(Pid(target=target, **one), sample_time) for one in settings]

    def __call__(self, seen: Floats) -> Floats:
        """Return the forces in N; the contact force is the last signal."""
        pairs = zip(self.laws, seen[:, -1].tolist(), strict=True)
        # Limits are those of the actuator; without an integral part they change nothing here.
        return np.array([law(force, lambda wanted: wanted) for law, force in pairs])


def pid_of(numbers: Floats) -> dict[str, float]:
    """Return the settings of a PID for numbers of the search, whose zeros are those of `PID`."""
    factors = np.exp(np.clip(numbers, -5.0, 3.0))
    return {name: value * float(f) for (name, value), f in zip(PID.items(), factors, strict=True)}


def search(
    cost: Callable[[list[Floats], list[int]], Floats],
    size: int,
    spread: float,
    generations: int,
    seed: int,
) -> Floats:
    """Return what CMA-ES finds for the lowest cost, a number for each candidate."""
    import cma

    options = {"seed": seed, "verbose": -9, "maxiter": generations, "tolfun": 0, "tolx": 0}
    strategy = cma.CMAEvolutionStrategy(np.zeros(size), spread, options)
    for generation in range(generations):
        # Other starts in each generation, the same ones for all of its candidates.
        first = 1000 * seed + STARTS * generation
        candidates = strategy.ask()
        strategy.tell(candidates, cost(candidates, list(range(first, first + STARTS))).tolist())
    return np.asarray(strategy.result.xfavorite)


def learn(case: str, generations: tuple[int, int], seed: int = SEED) -> tuple[Any, dict, dict]:
    """Tune a PID and learn a law; returns law, settings of the PID, and what it took."""
    task = make_task(case)
    sample, target = task.sample_time_s, task.target_force_N
    shape = len(OBSERVE), len(control.TIME_CONSTANTS_S)
    began, used = time.perf_counter(), time.process_time()

    def pid_cost(candidates: list[Floats], seeds: list[int]) -> Floats:
        settings = [pid_of(numbers) for numbers in candidates for _ in seeds]
        return -mean_return(task, Pids(settings, target, sample), len(candidates), seeds)

    def law_cost(candidates: list[Floats], seeds: list[int]) -> Floats:
        gains = np.repeat(np.array(candidates).reshape(-1, *shape), len(seeds), axis=0)
        law = control.FilteredLaw(OBSERVE, gains, sample)
        return -mean_return(task, lambda seen: law(seen[:, :-1]), len(candidates), seeds)

    pid = pid_of(search(pid_cost, len(PID), 0.5, generations[0], seed))
    gains = search(law_cost, shape[0] * shape[1], 0.2, generations[1], seed)
    law = control.FilteredLaw(OBSERVE, gains.reshape(shape), sample)
    took = {
        "seed": seed,
        "generations_pid": generations[0],
        "generations_law": generations[1],
        "processor_s": round(time.process_time() - used, 1),
        "wall_s": round(time.perf_counter() - began, 1),
    }
    seen = replace(task, signals=task.signals[:-1])
    return law, pid, {"task": seen, "about": {"learnt": took, "pid": pid}}


def scenario_of(case: str, **changes: Any) -> arcless.Scenario:
    """Return a case assessed on spans that its laws were not made on.

    Its static force is the one that gives the mean force without control; from there that of each
    law is found, so that all press with the same mean.
    """
    begin, end = scored(case, CASES[case][1])
    section = {"analysis.spans": None, "analysis.from": begin, "analysis.to": end}
    scenario = arcless.load(case).with_(**section, **changes)
    if scenario.pantographs[0].mean_force is None:
        return scenario
    forces = json.loads(arcless.run(scenario).dataset.attrs["static_force_found"])
    found = forces[scenario.pantographs[0].name]
    force = {"pantographs.0.mean_force": None, "pantographs.0.static_force": found}
    return scenario.with_(**force)


def at_mean(
    scenario: arcless.Scenario, target: float, controllers: dict[str, Any] | None
) -> arcless.Result:
    """Run a scenario with the static force that gives a mean force in N, within half a newton.

    A search by `mean_force` asks for 0.02 N, which a law that chatters at a limit does not repeat.
    """
    for _ in range(MOST_RUNS):
        result = arcless.run(scenario, controllers=controllers)
        off = target - result.assessment.pantographs[0].mean_force_N
        if abs(off) <= MEAN_WITHIN:
            return result
        force = scenario.pantographs[0].static_force or 0.0
        scenario = scenario.with_(**{"pantographs.0.static_force": force + off})
    raise SystemExit(f"{scenario.name}: the mean force of {target:g} N was not reached")


class Noisy:
    """Law that sees its signals with noise."""

    def __init__(self, law: control.FilteredLaw) -> None:
        self.law, self.sizes = law, np.array([NOISE.get(name, 0.0) for name in law.observe])
        self.begin()

    def begin(self) -> None:
        """Forget all that was seen, and begin the noise again."""
        self.law.begin()
        self.random = np.random.default_rng(SEED)

    def __call__(self, seen: Floats) -> Floats:
        """Return the forces in N."""
        return self.law(seen + self.sizes * self.random.normal(size=seen.shape))


def assessed(
    case: str, scenario: arcless.Scenario, law: str, certainty: int | None = None
) -> dict[str, Any]:
    """Run a law, and return what the assessment says, and the root mean square of its force."""
    file, controllers = LAWS / f"{case}.json", None
    field, name = "pantographs.0.controller", scenario.pantographs[0].name
    given = arcless.load(case).pantographs[0]
    target = given.mean_force or given.static_force
    if law.startswith("learnt"):
        scenario = scenario.with_(**{field: dict(control.ACTUATOR)})
        controllers = {name: control.load_law(file)}
        if law == "learnt, noise":
            controllers[name].law = Noisy(controllers[name].law)
    elif law != "none":
        tuned = law == "PID, tuned"
        pid = json.loads(file.read_text(encoding="utf-8"))["about"]["pid"] if tuned else PID
        scenario = scenario.with_(**{field: {**control.ACTUATOR, "pid": {"target": target, **pid}}})
    result = at_mean(scenario, target, controllers)
    if certainty is not None:
        result = arcless.run(result.scenario, controllers=controllers, certainty=certainty)
    force, effort = result.assessment.pantographs[0], 0.0
    if law != "none":
        place, (begin, end) = result.dataset["position"].values[:, 0], scenario.analysis_range()
        inside = (place >= begin) & (place <= end)
        effort = float(np.sqrt((result.dataset["control_force"].values[inside, 0] ** 2).mean()))
    return {
        "mean": force.mean_force_N, "std": force.std_force_N, "min": force.min_force_N,
        "loss": force.contact_loss_percent, "effort": effort,
        "sure": (force.certainty or {}).get("std_force_N", {}),
    }  # fmt: skip


def compare(cases: list[str], certainty: int | None = None) -> dict[tuple[str, str], dict]:
    """Print and return what each law does on each line."""
    heads = ("mean N", "σ N", "min N", "lost %", "effort N")
    print(f"{'':48}" + "".join(f"{head:>10}" for head in heads))
    found = {}
    for case in cases:
        scenario = scenario_of(case)
        for law in ("none", "PID of the guide", "PID, tuned", "learnt"):
            one = found[case, law] = assessed(case, scenario, law, certainty)
            numbers = [one[key] for key in ("mean", "std", "min", "loss", "effort")]
            line = f"{f'{case}, {law}':48}" + "".join(f"{number:10.1f}" for number in numbers)
            print(line + (f"  {one['sure']}" if certainty else ""), flush=True)
    return found


def elsewhere(case: str) -> dict[str, dict[str, Any]]:
    """Return changes of a case under which its laws were not made, by what they are."""
    scenario, random = arcless.load(case), np.random.default_rng(SEED)
    assert scenario.speed is not None
    count = len(scenario.line.support_positions())
    heights = [
        {"support": number, "height_error": SUPPORT_ERROR * float(random.normal())}
        for number in range(2, count)
    ]
    return {
        "10 % slower": {"speed": 0.9 * scenario.speed},
        "supports ± 10 mm": {"as_built.support_height_errors": heights},
    }


def others(cases: list[str]) -> dict[tuple[str, str], list[float]]:
    """Print and return σ in N of the laws where they were not made."""
    laws = ("none", "PID, tuned", "learnt", "learnt, noise")
    print(f"{'':48}" + "".join(f"{law:>15}" for law in laws))
    found = {}
    for case in cases:
        for what, changes in {"as it is": {}, **elsewhere(case)}.items():
            scenario = scenario_of(case, **changes)
            numbers = [assessed(case, scenario, law)["std"] for law in laws]
            found[case, what] = numbers
            line = f"{f'{case}, {what}':48}"
            print(line + "".join(f"{number:15.1f}" for number in numbers), flush=True)
    return found


def main(arguments: Sequence[str] = ()) -> dict[tuple[str, str], Any]:
    """Learn if that is asked for, then compare."""
    parser = argparse.ArgumentParser(description="Laws for a controlled pantograph.")
    parser.add_argument("--learn", action="store_true", help="make the laws first")
    parser.add_argument("--generations", nargs=2, type=int, default=GENERATIONS, metavar="N",
                        help="of the search for PID and law")  # fmt: skip
    parser.add_argument("--seed", type=int, default=SEED)
    parser.add_argument("--others", action="store_true", help="run them where they were not made")
    parser.add_argument("--certainty", type=int, help="starts that say how sure σ is")
    parser.add_argument("--case", action="append", choices=list(CASES), help="all without")
    given = parser.parse_args(list(arguments))
    cases = given.case or list(CASES)
    for case in cases if given.learn else ():
        law, pid, more = learn(case, tuple(given.generations), given.seed)
        LAWS.mkdir(exist_ok=True)
        control.save_law(LAWS / f"{case}.json", law, more["task"], more["about"])
        print(case, more["about"]["learnt"], pid, flush=True)
    return others(cases) if given.others else compare(cases, given.certainty)


if __name__ == "__main__":
    main(sys.argv[1:])
