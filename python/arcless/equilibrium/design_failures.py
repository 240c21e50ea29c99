"""Errors of a designed line that cannot stand: steady arms that would push."""

import numpy as np
from numpy.typing import NDArray

from arcless.errors import EquilibriumError
from arcless.mesh import Mesh
from arcless.model import Line

# An arm without stagger carries nothing, and rounding decides which way. In N; a tenth of a clamp.
LOOSE_ARM = 0.1


def check_arms(mesh: Mesh, line: Line, tension: NDArray[np.float64]) -> None:
    """Refuse a designed line that a steady arm would have to push aside."""
    for support in mesh.supports:
        force = 0.0 if support.steady_arm is None else float(tension[support.steady_arm])
        if force < -LOOSE_ARM:
            bent = "stagger and curve" if line.track.curves else "the staggers of three supports"
            raise EquilibriumError(
                f"the steady arm at {support.name} would have to push",
                where=f"{support.x:.2f} m",
                got=f"a force of {force:.1f} N",
                expected="a tension",
                hint=f"{bent} nearly cancel there, and leaning droppers decide: change the stagger"
                " of this support, or move the messenger wire towards the contact wire",
            )
