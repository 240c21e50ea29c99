"""A controlled pantograph: a PID and a damper to the sky, each with less and more delay.

Run it with ``python examples/controlled.py``; it takes some ten seconds.
"""

from collections.abc import Callable, Sequence

import arcless

CASE = "en50318-ac-simple-275-planar"
STATIC_FORCE = 120.0
CONTROLLER = "pantographs.0.controller"
# 200 times a second, within 100 N.
TIMING = {"sample_time": "5 ms", "minimum_force": "-100 N", "maximum_force": "100 N"}
PID = {"target": "120 N", "proportional": 1.0, "derivative": "50 ms", "filter": "20 ms"}


def sky_damper(sample: arcless.ControlInput) -> float:
    """Damp the first mass against the sky: N for its velocity in m/s."""
    return -200.0 * sample.velocities_m_s[0]


def main(delays: Sequence[int] = (0, 10, 20, 40)) -> dict[str, float]:
    """Print and return the standard deviation of the contact force in N; delays in ms."""
    plain = arcless.load(CASE).with_(
        **{"pantographs.0.mean_force": None, "pantographs.0.static_force": STATIC_FORCE}
    )
    cases: dict[str, tuple[dict, Callable | None]] = {"not controlled": ({}, None)}
    for delay in delays:
        timing = {**TIMING, "delay": f"{delay} ms"}
        cases[f"PID, {delay} ms late"] = ({CONTROLLER: {**timing, "pid": PID}}, None)
        cases[f"sky damper, {delay} ms late"] = ({CONTROLLER: timing}, sky_damper)
    found = {}
    print(f"{'':28}{'mean N':>8}{'σ N':>8}{'min N':>8}")
    for name, (changes, function) in cases.items():
        controllers = {"P1": function} if function else None
        result = arcless.run(plain.with_(**changes), controllers=controllers)
        force = result.assessment.pantographs[0]
        found[name] = force.std_force_N
        print(f"{name:28}{force.mean_force_N:8.1f}{force.std_force_N:8.1f}{force.min_force_N:8.1f}")
    return found


if __name__ == "__main__":
    main()
