"""Results whose bits are kept: every shipped scenario, and each way there is to make a run.

A case returns its arrays and numbers by name. A refusal is part of the behaviour, so it counts too.
"""

import tempfile
from collections.abc import Callable, Iterator, Mapping
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

import arcless
from arcless.model.shipped.library import shipped

Case = Callable[[], dict[str, Any]]

IN_SPACE = "en50318-ac-simple-320"
PLANAR = "en50318-ac-simple-320-planar"
# Schemes with a matrix; the shipped scenarios take explicit steps where their line allows it.
SCHEMES: dict[str, dict[str, Any]] = {
    "trapezoidal, energies": {"solver.scheme": "trapezoidal", "output.energy": "always"},
    "hht": {"solver.scheme": {"name": "hht", "alpha": -0.05}},
    "generalised-alpha": {"solver.scheme": "generalised-alpha"},
    "lumped, generalised-alpha": {
        "solver.scheme": "generalised-alpha",
        "solver.wire_model": "lumped",
    },
    "explicit, energies": {"output.energy": "always"},
}
# A matrix is factorised in every step: a long step and a given force make it a matter of seconds.
UPDATED: dict[str, Any] = {
    "solver.scheme": "backward-difference",
    "solver.kinematics": "updated",
    "solver.time_step": "5 ms",
    "pantographs.0.mean_force": None,
    "pantographs.0.static_force": "150 N",
}
LUMPED = {"solver.wire_model": "lumped"}
# Two pantographs at the spacing where the second one feels the first, and three.
TRAINS = {
    "two pantographs": [0.0, 60.0],
    "three pantographs": [0.0, 100.0, 200.0],
}
# Neither bits of the motion, nor what is the same on two days.
PASSING = {
    "created", "arcless_version", "wall_time_s", "setup_time_s", "real_time_factor", "command",
}  # fmt: skip


def cases() -> Iterator[tuple[str, Case]]:
    """Yield each case with its name, in the order in which they are kept."""
    for name in shipped("scenario"):
        yield f"run {name}", partial(_run, name, {})
    yield f"run {IN_SPACE}, updated, lumped", partial(_run, IN_SPACE, UPDATED | LUMPED)
    yield f"run {PLANAR}, updated, lumped", partial(_run, PLANAR, UPDATED | LUMPED)
    yield f"run {PLANAR}, updated", partial(_run, PLANAR, UPDATED)
    for base in (IN_SPACE, PLANAR):
        for name, changes in SCHEMES.items():
            yield f"run {base}, {name}", partial(_run, base, changes)
        for name, behind in TRAINS.items():
            yield f"run {base}, {name}", partial(_train, base, behind)
    yield "statics", partial(_statics, IN_SPACE)
    yield "stopped and resumed", partial(_resumed, IN_SPACE, {})
    yield "stopped and resumed, matrix", partial(_resumed, PLANAR, SCHEMES["hht"])
    yield "written while it runs", _streamed
    yield "session, forces given", partial(_session, IN_SPACE, simulated=False)
    yield "session, pantographs simulated", partial(_session, IN_SPACE, simulated=True)
    yield "session, matrix", partial(_session, PLANAR, simulated=True, **SCHEMES["hht"])
    yield "batch", _batch
    yield "study", _study


def bits_of_result(result: arcless.Result) -> dict[str, Any]:
    """Every variable of a result (series, extremes, statics) and every attribute."""
    plain = result.latest
    found = {name: plain[name].values for name in plain}
    found |= {f"@{key}": str(value) for key, value in plain.attrs.items() if key not in PASSING}
    assessed = {k: v for k, v in result.assessment.to_dict().items() if k not in _UNASSESSED}
    return found | {"assessment": str(assessed)}


# Passing ones, and a sentence made of the criteria, which are compared.
_UNASSESSED = {"verdict", "version", "wall_time_s", "setup_time_s", "real_time_factor"}


def _load(name: str, changes: Mapping[str, Any]) -> arcless.Scenario:
    scenario = arcless.load(name)
    return scenario.with_(**changes) if changes else scenario


def _run(name: str, changes: Mapping[str, Any]) -> dict[str, Any]:
    return bits_of_result(arcless.run(_load(name, changes)))


def _train(name: str, behind: list[float]) -> dict[str, Any]:
    pantographs = [
        {"model": "ac-simple", "name": f"p{k}", "mean_force": "169.3 N", "distance": f"{d} m"}
        for k, d in enumerate(behind)
    ]
    return bits_of_result(arcless.run(arcless.load(name).with_(pantographs=pantographs)))


def _statics(name: str) -> dict[str, Any]:
    return {"statics": str(arcless.statics(arcless.load(name)).to_dict())}


def _resumed(name: str, changes: Mapping[str, Any]) -> dict[str, Any]:
    first = arcless.run(_load(name, changes), until="600 m")
    return bits_of_result(arcless.resume(first))


def _streamed() -> dict[str, Any]:
    with tempfile.TemporaryDirectory() as folder:
        return bits_of_result(arcless.run(arcless.load(IN_SPACE), to=Path(folder) / "result.nc"))


def _session(name: str, *, simulated: bool, **changes: Any) -> dict[str, Any]:
    force = {"pantographs.0.mean_force": None, "pantographs.0.static_force": "150 N"}
    loop = arcless.realtime(_load(name, {**changes, **force}), simulated=simulated)
    heights, forces, saved = [], [], None
    pushed = 0.0 if simulated else 150.0
    for step in range(2000):
        given = pushed if simulated else pushed + 40.0 * np.sin(0.02 * step)
        if step == 1500:
            saved = loop.save()
        loop.step(given)
        heights.append(loop.height_m.copy())
        forces.append(loop.contact_force_N.copy())
    assert saved is not None
    numbers = {f"state {key}": values for key, values in saved.numbers.items()}
    return {"height": np.array(heights), "force": np.array(forces), **numbers}


def _batch() -> dict[str, Any]:
    speeds = ("220 km/h", "260 km/h", "300 km/h")
    base = arcless.load(PLANAR)
    outcomes = arcless.batch([base.with_(speed=s) for s in speeds], keep="result")
    found = {}
    for outcome in outcomes:
        assert outcome.result is not None
        for key, value in bits_of_result(outcome.result).items():
            found[f"{outcome.index} {key}"] = value
    return found


def _study() -> dict[str, Any]:
    with tempfile.TemporaryDirectory() as folder:
        text = (
            f"format: arcless-study/1\nname: golden\nscenario: {PLANAR}\n"
            "variables: {speed: {field: speed, values: [220 km/h, 250 km/h]}}\n"
            "design: {kind: grid}\noutputs: {sigma: std_force_N, least: min_force_N}\n"
        )
        file = Path(folder) / "golden.yaml"
        file.write_text(text)
        study = arcless.study.load(file)
        place = Path(folder) / "out"
        arcless.study.run(study, place)
        rows = arcless.study.StudyFolder(study, place).rows()
        return {f"row {row.variant}": str([row.status, row.outputs]) for row in rows}
