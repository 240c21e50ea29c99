"""A beam with a machine on it falls on three supports that hold it from below only.

Run it with ``python examples/dropped_beam.py``; it takes a second. Nothing in it is railway: the
step of the founding paper (``arcless.lcp.PublishedStep``) serves any elastic system that can lift
off. See ``docs/guide/lcp.md``.
"""

import numpy as np

from arcless import lcp

L, EI, MU = 6.0, 2.0e6, 16.0  # m, N m², kg/m: a steel beam 160 mm high
MACHINE, G = 500.0, 9.81  # kg on the first quarter, m/s²
DAMPING = 1e-3  # s, proportional to the stiffness: 4 % of critical at 84 rad/s
ELEMENTS = 12
SUPPORTS = [0, 6, 12]  # nodes: left end, middle, right end
DROP = 0.020  # m


def beam() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return mass, stiffness and weight; unknowns are deflection and rotation of each node."""
    a = L / ELEMENTS
    k = np.array([[12, 6, -12, 6], [6, 4, -6, 2], [-12, -6, 12, -6], [6, 2, -6, 4]])
    m = np.array([[156, 22, 54, -13], [22, 4, 13, -3], [54, 13, 156, -22], [-13, -3, -22, 4]])
    unit = np.outer([1, a, 1, a], [1, a, 1, a])  # rotations times a length
    size = 2 * ELEMENTS + 2
    mass, stiffness, weight = np.zeros((size, size)), np.zeros((size, size)), np.zeros(size)
    for e in range(ELEMENTS):
        part = slice(2 * e, 2 * e + 4)
        mass[part, part] += MU * a / 420 * m * unit
        stiffness[part, part] += EI / a**3 * k * unit
        weight[part] -= MU * G * a * np.array([1 / 2, a / 12, 1 / 2, -a / 12])
    quarter = ELEMENTS // 4 * 2
    mass[quarter, quarter] += MACHINE
    weight[quarter] -= MACHINE * G
    return mass, stiffness, weight


def main(tau: float = 1e-3, duration: float = 5.0) -> tuple[np.ndarray, np.ndarray]:
    """Drop the beam; return the forces of the supports (N) and the gaps (m) of all steps."""
    mass, stiffness, weight = beam()
    contact_map = np.zeros((len(weight), 3))
    contact_map[np.multiply(2, SUPPORTS), range(3)] = 1.0  # forces on deflections

    beam_in_time = lcp.PublishedStep(mass, DAMPING * stiffness, stiffness, tau)
    u_1 = u_2 = np.zeros(len(weight))  # at rest, 20 mm above the supports
    steps = []
    for _ in range(round(duration / tau)):
        step = beam_in_time.step(u_1, u_2, weight, contact_map, np.full(3, DROP))
        steps.append(step)
        u_1, u_2 = step.u, u_1

    force, gap = np.array([s.force for s in steps]), np.array([s.gap for s in steps])
    report(force, gap, tau)
    print(f"at most {max(s.info.pivots for s in steps)} pivots in a step")
    return force, gap


def report(force: np.ndarray, gap: np.ndarray, tau: float) -> None:
    """Print what happened, and the last state beside its closed form."""
    closed = force > 0
    print(f"first touch after {1e3 * tau * (1 + closed.any(axis=1).argmax()):.0f} ms")
    for j, name in enumerate(("left", "middle", "right")):
        openings = np.count_nonzero(closed[:-1, j] & ~closed[1:, j])
        print(f"{name:6}  lifts off {openings} times, closed {closed[:, j].mean():4.0%} of steps")

    # The right end stays in the air: a beam on two supports, half of it beyond the second one.
    P, q, span = MACHINE * G, MU * G, L / 2
    print("at rest          computed    closed form")
    for name, value, exact in (
        ("left, N       ", force[-1, 0], P / 2),
        ("middle, N     ", force[-1, 1], P / 2 + q * L),
        ("right, N      ", force[-1, 2], 0.0),
        ("right gap, mm ", 1e3 * gap[-1, 2], 1e3 * (P / 16 - q * span / 4) * span**3 / EI),
        ("impulse, N s  ", tau * force.sum(), (P + q * L) * tau * len(force)),
    ):
        print(f"{name}  {value:9.4f}      {exact:9.4f}")


if __name__ == "__main__":
    main()
