"""Alignment that is given by hand, with the correlation that it has."""

from arcless.comparison.alignment.correlation import correlation
from arcless.comparison.alignment.place import Alignment
from arcless.comparison.alignment.trace import Trace
from arcless.errors import ComparisonError


def correlation_at(
    line: Trace, measured: Trace, offset_m: float, scale: float, *, method: str
) -> Alignment:
    """Return a given alignment with the correlation that it has; None where that is not defined.

    Parameters
    ----------
    line, measured
        As in `aligned`.
    offset_m, scale
        The alignment.
    method
        Its name.

    Raises
    ------
    ComparisonError
        Nothing overlaps.
    """
    origin = float(measured.position_m[0])
    places = origin + offset_m + scale * (measured.position_m - origin)
    values, known = line.at(places[measured.valid])
    if not known.any():
        low, high = (float(line.position_m[line.valid][end]) for end in (0, -1))
        raise ComparisonError(
            "the measurement does not overlap the run",
            got=f"{places[0]:.1f} to {places[-1]:.1f} m",
            expected=f"a part of {low:.1f} to {high:.1f} m",
            hint="align by correlation, or give another offset",
        )
    pairs = values[known], measured.values[measured.valid][known]
    r = correlation(*pairs)
    overlap = places[measured.valid][known]
    return Alignment(
        method, origin, False, offset_m, scale, r,
        overlap_m=(float(overlap[0]), float(overlap[-1])),
    )  # fmt: skip
