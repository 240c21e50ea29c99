"""Balance of forces where several wires are clamped together."""

import numpy as np

from arcless.equilibrium.equilibrium import Equilibrium

GRAVITY = 9.81


def balance_at(found: Equilibrium, clamps: list[int], mass: float) -> tuple[np.ndarray, np.ndarray]:
    """Sum of forces at each clamp, and sizes of the pulls along the track in ascending order (N).

    For chains of segments without bending stiffness; `mass` is that of a clamp in kg.
    """
    mesh, points = found.mesh, found.positions
    segments = mesh.parts["segments"]
    nodes = segments["nodes"]
    tension, rest = found.arrays["wire_tension"], found.arrays["wire_rest_length"]
    sums, along = [], []
    for clamp in clamps:
        rows = np.flatnonzero((nodes == clamp).any(axis=1))
        far = np.where(nodes[rows, 0] == clamp, nodes[rows, 1], nodes[rows, 0])
        away = points[far] - points[clamp]
        pull = tension[rows, None] * away / np.linalg.norm(away, axis=1)[:, None]
        weight = GRAVITY * (mass + 0.5 * np.sum(segments["mass"][rows] * rest[rows]))
        sums.append(pull.sum(axis=0) - [0.0, 0.0, weight])
        along.append(sorted(np.abs(pull[:, 0])))
    return np.array(sums), np.array(along)
