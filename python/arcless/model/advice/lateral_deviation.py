"""A contact wire at rest that lies farther aside than collector heads allow."""

from collections.abc import Sequence

from arcless.model.line.line import Line
from arcless.model.line.track_rules import ROUNDING, farthest
from arcless.model.pantograph.pantograph import LATERAL_LIMITS
from arcless.model.pantograph.placement import PantographPlacement

# Lateral deviation allowed for a head of 1.60 m and for one of 1.95 m. In m.
ALLOWED = tuple(LATERAL_LIMITS.values())


def deviation_warnings(line: Line, placements: Sequence[PantographPlacement] = ()) -> list[str]:
    """Return a sentence when the wire at rest lies farther aside than heads allow.

    Parameters
    ----------
    line
        The line; wind and uplift are not in this, the assessment of a run has them.
    placements
        Pantographs that run below it; those that say how wide their heads are count, each with its
        sway. Without any such, narrow heads count.
    """
    worst = farthest(line)
    twin = line.twin_contact_wires
    aside = abs(worst.distance) + (0.0 if twin is None else 0.5 * twin.widest)
    place = f"at {worst.x:.4g} m, in span {worst.span}"
    where = f"the contact wire at rest lies {aside:.3g} m aside {place}"
    field = "line.track.curves" if worst.curve_part else "line.geometry.stagger_contact_wire"
    known = [(each, each.model.lateral_limit) for each in placements]
    told = []
    for placement, limit in known:
        if limit is None or aside + placement.sway <= limit + ROUNDING:
            continue
        sway = f" and the head sways by {placement.sway:.3g} m" if placement.sway else ""
        name = placement.name or placement.model.name
        told.append(f"{field}: {where}{sway}; the head of pantograph {name} allows {limit:.3g} m")
    if any(limit is not None for _, limit in known) or aside <= ALLOWED[0] + ROUNDING:
        return told
    heads = "0.40 m are allowed for a head of 1.60 m"
    if aside > ALLOWED[1] + ROUNDING:
        heads += ", 0.55 m for one of 1.95 m"
    return [f"{field}: {where}; {heads}"]
