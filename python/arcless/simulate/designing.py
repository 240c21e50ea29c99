"""What to say of a line that cannot be designed: measured heights, steady arms in curves."""

from collections.abc import Mapping
from math import tan

import numpy as np
from numpy.typing import NDArray

from arcless.errors import EquilibriumError
from arcless.mesh import Mesh
from arcless.model import Line, SteadyArmBar

# Measured heights and arms this near to a dropper may be why it would have to push. In m.
NEIGHBOURS = 50.0
# An arm without stagger carries nothing, and rounding decides which way. In N; a tenth of a clamp.
LOOSE_ARM = 0.1


def why_pushing(mesh: Mesh, line: Line, heights: Mapping[float, float], link: int) -> str | None:
    """Return a hint for a dropper that would have to push, where more than pre-sag may be why."""
    x = next(dropper.x for dropper in mesh.droppers if dropper.link == link)
    if heights:
        near = [place for place in sorted(heights) if abs(place - x) < NEIGHBOURS]
        at = near.index(min(near, key=lambda place: abs(place - x)))
        read = [f"{heights[place]:.4g} m at {place:g} m" for place in near[max(at - 1, 0) : at + 2]]
        return f"measured were {', '.join(read)}: the wire cannot hang like that; look at these"
    arm, track = line.steady_arm, line.track
    if not track.curves or not isinstance(arm, SteadyArmBar):
        return None
    supports, height = line.support_positions(), line.geometry.contact_wire_height
    inner = range(1, len(supports) - 1)
    index = min(inner, key=lambda number: abs(supports[number] - x), default=None)
    if index is None:
        return None
    left, here, right = supports[index - 1 : index + 2]
    turn = track.mean_direction(here, right, height) - track.mean_direction(left, here, height)
    pull = line.contact_wire.tension * abs(turn)
    return (
        f"in the curve the steady arm at support {index + 1} pulls with some {pull:.0f} N and, with"
        f" its slope, lifts the wire by {pull * tan(arm.slope):.0f} N: try a flatter arm"
    )


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
