"""Draw the figures of curves and of gusts: `python docs/make_track.py docs/images`."""

import re
import sys
import tempfile
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from drawing import BLUE, GREY, ORANGE, save, set_up

import arcless
from arcless.model.files.yaml_reader import parse
from arcless.simulate import StaticsResult, statics

GUIDE = Path(__file__).parent / "guide"


def curved() -> StaticsResult:
    """The example of the guide: AC simple in space, in a curve and on a gradient."""
    text = (GUIDE / "track.md").read_text("utf-8")
    data, _ = parse(re.findall(r"```yaml\n(geometry:.*?)```", text, re.DOTALL)[0], "track.md")
    changes = {f"line.geometry.{name}": value for name, value in data["geometry"].items()}
    base = arcless.load("en50318-ac-simple-275").with_(speed="160 km/h")
    return statics(base.with_(**changes, **{"line.track": data["track"]}))


def draw_track(file: Path) -> None:
    """Draw plan, forces of the steady arms, and height of the contact wire."""
    found = curved()
    mesh, points = found.equilibrium.mesh, found.equilibrium.positions
    figure, (plan, arms, side) = plt.subplots(
        3, 1, figsize=(8.0, 5.6), sharex=True, layout="constrained", height_ratios=(3, 2, 1.5)
    )
    for nodes, colour, label in (
        (mesh.messenger_nodes, GREY, "messenger wire"),
        (mesh.contact_nodes, BLUE, "contact wire"),
    ):
        plan.plot(points[nodes, 0], points[nodes, 1], color=colour, lw=1.3, label=label)
    line = found.scenario.line
    for curve in line.track.curves:
        plan.axvspan(curve.from_, curve.to, color="0.93", label="curve to the left")
        inner = (curve.from_ + curve.transition, curve.to - curve.transition)
        plan.axvspan(*inner, color="0.86", label=f"R = {curve.radius:g} m")
    plan.axhline(0.0, color="0.5", lw=0.5)
    plan.set(ylabel="y, m (left is up)", ylim=(-0.35, 0.45))
    plan.legend(loc="upper left", ncols=4, frameon=False)
    held = [s for s in mesh.supports if s.steady_arm is not None]
    rows = [s.steady_arm for s in held]
    force = (
        found.equilibrium.arrays["strut_tension"][rows] * mesh.parts["struts"]["direction"][rows, 1]
    )
    x = np.array([s.x for s in held])
    arms.bar(x, force, width=12, color=BLUE, label="as found")
    arms.plot(x, by_hand(line, x), "o", color=ORANGE, ms=3, label="T × (bend − turn), by hand")
    arms.axhline(0.0, color="0.5", lw=0.5)
    arms.set(ylabel="arm, N (left is up)")
    arms.legend(loc="lower left", frameon=False)
    side.plot(points[mesh.contact_nodes, 0], points[mesh.contact_nodes, 2], color=BLUE, lw=1.3)
    side.set(xlabel="position along the track, m", ylabel="height, m")
    save(figure, file)


def by_hand(line: Any, x: np.ndarray) -> np.ndarray:
    """Force of an arm: tension times the bend of the stagger, less the turn of the track."""
    supports, height = line.support_positions(), line.geometry.contact_wire_height
    pattern = line.geometry.stagger_contact_wire
    found = []
    for place in x:
        k = int(np.argmin(np.abs(np.array(supports) - place)))
        y = [pattern[i % len(pattern)] for i in (k - 1, k, k + 1)]
        left, here, right = supports[k - 1 : k + 2]
        bend = (y[1] - y[0]) / (here - left) - (y[2] - y[1]) / (right - here)
        turn = line.track.mean_direction(here, right, height)
        turn -= line.track.mean_direction(left, here, height)
        found.append(line.contact_wire.tension * (bend - turn))
    return np.array(found)


def draw_gusts(file: Path) -> None:
    """Draw the gusts of the guide, and how far they blow the wire aside at the pantograph."""
    text = (GUIDE / "as-built.md").read_text("utf-8")
    readings = re.findall(r"```csv\n(# gusts\.csv.*?)```", text, re.DOTALL)[0]
    changes: dict[str, Any] = {
        "as_built.wind.speed": "12 m/s",
        "line.contact_wire.diameter": "13.2 mm",
        "line.messenger_wire.diameter": "12 mm",
    }
    base = arcless.load("en50318-ac-simple-275")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "gusts.csv"
        path.write_text(readings, encoding="utf-8")
        gusty = base.with_(**changes, **{"as_built.gusts": str(path)})
    steady, blown = (
        arcless.run(scenario).dataset["contact_lateral"][:, 0]
        for scenario in (base.with_(**changes), gusty)
    )
    time, x = blown["time"].values, gusty.travel_range()[0] + gusty.top_speed * blown["time"].values
    figure, (wind, side) = plt.subplots(
        2, 1, figsize=(8.0, 3.8), sharex=True, layout="constrained", height_ratios=(1.4, 2)
    )
    gusts = gusty.as_built.gusts
    assert gusts is not None
    stations = gusts.stations()
    pressures = []
    for shade, (place, rows) in zip((BLUE, ORANGE), stations.items(), strict=True):
        speed = np.interp(time, np.array(gusts.time)[rows], np.array(gusts.speed)[rows])
        wind.plot(time, speed, color=shade, lw=1.2, label=f"at {place:g} m")
        pressures.append(0.5 * gusty.as_built.wind.air_density * (speed**2 - 12**2))
    wind.set(ylabel="wind, m/s", ylim=(10, 29))
    wind.legend(loc="upper left", ncols=2, frameon=False)
    share = np.interp(x, list(stations), [0.0, 1.0])
    line = gusty.line
    sag = line.span_list()[0].length ** 2 / (8 * line.contact_wire.tension)
    quasi = sag * 0.0132 * ((1 - share) * pressures[0] + share * pressures[1])
    moved = 1e3 * (blown - steady).values
    side.plot(time, moved, color=BLUE, lw=1, label="blown aside at the pantograph")
    side.plot(
        time, 1e3 * quasi, color=GREY, lw=0.9, ls="--", label="Δf L²/8T, the middle of a span"
    )
    side.set(xlabel="time, s", ylabel="across, mm", xlim=(0, time[-1]))
    side.legend(loc="upper left", frameon=False)
    save(figure, file)


def main(folder: str) -> None:
    set_up()
    draw_track(Path(folder) / "track-curve.svg")
    draw_gusts(Path(folder) / "gusts.svg")


if __name__ == "__main__":
    main(*sys.argv[1:])
