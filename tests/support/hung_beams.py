"""Wires between hinged ends, joined by links and held by springs, under forces at rest: exact.

With G the compliances of the wires at the places concerned (Green's function of EI w⁗ − T w″ = δ),
B what a link adds to its elongation as they rise, and 1/k on the diagonal of S,

    u = G (f − B t),   t = (S + BᵀGB)⁻¹ BᵀG f,   u = (G − GB (S + BᵀGB)⁻¹ BᵀG) f

Derived here. Independent of the program.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tests.support.beams import Beam, Floats

Place = tuple[int, float]  # number of the wire, m
# Lower end, upper end or the ground, N/m.
Link = tuple[Place, Place | None, float]


@dataclass(frozen=True)
class Hung:
    """Wires, and what joins them."""

    wires: Sequence[Beam]
    links: Sequence[Link]

    def _between(self, one: Sequence[Place], other: Sequence[Place]) -> Floats:
        return np.array(
            [
                [float(self.wires[a].under_force(x, 1.0, y)) if a == b else 0.0 for b, y in other]
                for a, x in one
            ]
        ).reshape(len(one), len(other))

    def _ends(self) -> tuple[list[Place], Floats]:
        """Places of the links, and B."""
        ends: list[Place] = []
        b = np.zeros((2 * len(self.links), len(self.links)))
        for number, (lower, upper, _) in enumerate(self.links):
            b[len(ends), number] = -1.0
            ends.append(lower)
            if upper is not None:
                b[len(ends), number] = 1.0
                ends.append(upper)
        return ends, b[: len(ends)]

    def tensions(self, at: Place) -> Floats:
        """Change of the tension of each link under 1 N that lifts a place, 1."""
        ends, b = self._ends()
        soft = np.diag([1.0 / k for *_, k in self.links])
        within = soft + b.T @ self._between(ends, ends) @ b
        return np.asarray(np.linalg.solve(within, b.T @ self._between(ends, [at])[:, 0]))

    def lift(self, at: Place, force: Place | None = None) -> float:
        """Rise of a place under 1 N there, or at another place, m/N."""
        force = force or at
        free = float(self._between([at], [force])[0, 0])
        if not self.links:
            return free
        ends, b = self._ends()
        return free - float(self._between([at], ends)[0] @ b @ self.tensions(force))
