"""Where bridles hang, so that their clamps are at the height of the contact wire."""

from arcless.mesh.division.systems import WireSystem
from arcless.model.line.line import Line
from arcless.model.line.parts.components import SteadyArmSpring
from arcless.model.line.parts.contact_supports import Bridle


def clamp_forces(
    line: Line, bridle: Bridle, system: WireSystem, index: int, gravity: float
) -> tuple[float, float]:
    """Return the vertical forces in N on the two clamps of a support's bridle, by design.

    Notes
    -----
    With all clamps at the height of their support, a string of weight w between held points d apart
    puts w d/2 on each, and T Δz/d where one is higher by Δz. Half of what hangs between the clamps
    goes to either. Without sag in these lengths: exact to the second order of the slopes.
    """
    reach, tension = 0.5 * bridle.length, line.contact_wire.tension
    weight, arm = line.contact_wire.mass * gravity, line.steady_arm
    heights, last = system.held_heights, len(system.supports) - 1
    hung = weight * reach + bridle.clamp_mass * gravity
    if isinstance(arm, SteadyArmSpring):
        hung += 0.5 * arm.mass * gravity

    def force(neighbour: int) -> float:
        far = reach if 0 < neighbour < last else 0.0
        apart = abs(system.supports[neighbour] - system.supports[index]) - reach - far
        rise = heights[index] - heights[neighbour]
        return 0.5 * weight * apart + tension * rise / apart + hung

    return force(index - 1), force(index + 1)


def rise(line: Line, bridle: Bridle, system: WireSystem, index: int, gravity: float) -> float:
    """Return how far above its clamps a bridle hangs at a support, in m.

    Notes
    -----
    Each half, of horizontal tension T_b, rises by R a/T_b from its clamp with the force R, and by
    w_b a²/2T_b more under its own weight. Two unlike forces give the mean of two heights; then the
    clamps are off by less than |R₁ − R₂| a/2T, because the contact wire between them resists.
    """
    reach = 0.5 * bridle.length
    force = 0.5 * sum(clamp_forces(line, bridle, system, index, gravity))
    own = 0.5 * bridle.mass * gravity * reach
    return (force + own) * reach / bridle.tension
