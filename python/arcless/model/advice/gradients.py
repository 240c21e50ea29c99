"""Gradients of the contact wire that are steeper than the standard allows."""

from itertools import pairwise

from arcless.model.line.line import Line

KMH = 3.6
PLACE = "line.geometry.height_changes"
# EN 50119, as read in the source S11 of the design data (mark A): up to a speed in km/h, the
# greatest gradient and the greatest change of gradient in ‰. Between 200 and 250 km/h the table
# is silent; the last row is taken there, the strict side.
GRADIENTS = ((60, 20, 10), (100, 6, 3), (120, 4, 2), (160, 2, 1), (200, 1, 0.5))
FASTEST = (0.4, 0.2)
# Gradients are differences of heights over lengths; this lies far below any drawing. In ‰.
ROUNDING = 1e-6


def allowed_gradient(speed: float) -> tuple[float, float]:
    """Return the greatest gradient and change of gradient in ‰ at a speed in m/s."""
    for fastest, gradient, change in GRADIENTS:
        if speed * KMH <= fastest * (1 + ROUNDING):
            return gradient, change
    return FASTEST


def gradient_warnings(line: Line, speed: float) -> list[str]:
    """Return a sentence for the steepest gradient and the sharpest change that go too far."""
    supports, heights = line.support_positions(), line.contact_wire_heights()
    found = []
    slopes = [
        1e3 * (behind - before) / (right - left)
        for (before, behind), (left, right) in zip(
            pairwise(heights), pairwise(supports), strict=True
        )
    ]
    steepest, sharpest = allowed_gradient(speed)
    at_speed = f"at {speed * KMH:.0f} km/h"
    worst = max(range(len(slopes)), key=lambda span: abs(slopes[span]))
    if abs(slopes[worst]) > steepest + ROUNDING:
        found.append(
            f"{PLACE}: a gradient of {slopes[worst]:.3g} ‰ in span {worst + 1};"
            f" EN 50119 allows {steepest:g} ‰ {at_speed}"
        )
    turns = [behind - before for before, behind in pairwise(slopes)]
    worst = max(range(len(turns)), key=lambda place: abs(turns[place]), default=0)
    if turns and abs(turns[worst]) > sharpest + ROUNDING:
        found.append(
            f"{PLACE}: the gradient changes by {abs(turns[worst]):.3g} ‰ at support {worst + 2};"
            f" EN 50119 allows {sharpest:g} ‰ {at_speed}: put a span of half the gradient between"
        )
    return found
