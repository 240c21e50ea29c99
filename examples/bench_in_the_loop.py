"""A test bench in a loop with the line: a pantograph that is not ours, and a wire that is computed.

The bench measures the contact force and drives its plate to the height of the wire a millisecond
later. Here the bench is computed as well, so that the example runs anywhere: a pantograph stepped
by itself, which feels the wire through a spring. Run it with ``python examples/test_bench.py``; it
takes some seconds.
"""

import numpy as np

import arcless

CASE = "en50318-ac-simple-320-planar"
FORCE = 150.0  # N
SPRING = 50e3  # N/m, between collector and plate


class Bench:
    """Masses of the shipped pantograph, stepped by the semi-implicit Euler rule."""

    def __init__(self, scenario: arcless.Scenario, height: float) -> None:
        masses = scenario.pantographs[0].model.masses
        self.mass = np.array([part.mass for part in masses])
        self.damping = np.array([part.damping for part in masses])
        self.stiffness = np.array([part.stiffness for part in masses])
        self.base = height  # the plate where the bench begins
        # At rest under the force; the spring to the base is then not stretched.
        below = np.cumsum(FORCE / self.stiffness[:0:-1])[::-1]
        self.u = FORCE / SPRING + np.append(below, 0.0)
        self.start = self.u[0]
        self.v = np.zeros(len(masses))

    def press(self, height: float, h: float) -> float:
        """Move for h seconds under a plate at a height in m; returns the measured force in N."""
        inner = 10  # the machine does not wait for the computer
        for _ in range(inner):
            measured = max(0.0, SPRING * (self.u[-1] + self.base - height))
            stretch, rate = np.diff(self.u, prepend=0.0), np.diff(self.v, prepend=0.0)
            stretch[0] -= self.start
            pull = self.stiffness * stretch + self.damping * rate
            force = np.append(pull[1:], -measured) - pull
            force[0] += FORCE
            self.v += force / self.mass * h / inner
            self.u += self.v * h / inner
        return measured


def main(case: str = CASE) -> dict[str, np.ndarray]:
    """Print mean and deviation of bench and run; return their contact forces in N."""
    scenario = arcless.load(case).with_(
        **{"pantographs.0.mean_force": None, "pantographs.0.static_force": FORCE}
    )
    loop = arcless.realtime(scenario)
    height, force, forces = loop.height_m[0], FORCE, []
    bench = Bench(scenario, height)
    _, end = scenario.travel_range()
    while loop.position_m + loop.speed_m_s * loop.time_step_s < end:
        height = loop.step(force)[0]  # here a real bench drives its plate and waits for the clock
        force = bench.press(height, loop.time_step_s)
        forces.append(force)
    run = arcless.run(scenario).dataset["contact_force"].values[:, 0]
    found = {"bench": np.array(forces), "run": run[: len(forces)]}
    print(f"{'':8}{'mean N':>8}{'σ N':>8}{'min N':>8}{'max N':>8}")
    for name, values in found.items():
        shown = (values.mean(), values.std(), values.min(), values.max())
        print(f"{name:8}" + "".join(f"{value:8.1f}" for value in shown))
    return found


if __name__ == "__main__":
    main()
