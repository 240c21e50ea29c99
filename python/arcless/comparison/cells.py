"""Numbers of a comparison as text, for the page and the terminal."""

from pathlib import Path

from arcless.assess import NOT_JUDGED, Assessment
from arcless.comparison.alignment import Alignment
from arcless.comparison.alignment.place import POOR_CORRELATION
from arcless.comparison.indicators import Indicator, Judged
from arcless.comparison.measured.acceptance import Accepted
from arcless.comparison.measured.bands import Band
from arcless.display.numbers import number, pair, signed

# Quantities of the first screen: those by which runs are judged first.
MAIN = (
    "mean_force_N", "std_force_N", "statistical_max_N", "statistical_min_N", "NQ_percent",
    "contact_loss_percent", "max_uplift_at_support_mm", "min_dropper_force_N",
)  # fmt: skip
NONE = "–"
# Ways by which positions of a measurement were put on the line.
WAYS = {
    "correlation": "correlation of the {}",
    "supports": "supports, by the {}",
    "given": "offset given",
    "none": "as they are",
    "reference": "others are placed on it",
}
# In place of the next best correlation, where the search found one maximum.
NO_OTHER = "no other place in the search"
# Stands once in each report; 26.6 less 23.7 may well be 3.0.
DIFFERENCES_READ = "Differences to the first run, {}, are of the unrounded numbers."
IN_MEMORY = "in memory, no file"
# Of a difference that is no larger than its uncertainty, as of a criterion.
TOO_CLOSE = "too close to tell"


def value(one: Indicator, run: int) -> str:
    """Return the value of a run, with its ± where that is known."""
    return pair(one.values[run], one.uncertainties[run], one.decimals)


def difference(one: Indicator, run: int) -> str:
    """Return the difference to the first run with its sign, and its ± and percentage if known.

    One that is smaller than its ± has the words for that and no percentage.
    """
    text = signed(one.differences[run], one.decimals)
    sure = number(one.difference_uncertainties[run], one.decimals)
    if one.difference_uncertainties[run] is not None and float(sure):
        text = f"{text} ± {sure}"
    if one.too_close_to_tell(run):
        return f"{text} ({TOO_CLOSE})"
    share = one.percents[run]
    return text if share is None else f"{text} ({signed(share, 1)}\u00a0%)"


def section(one: Assessment) -> str:
    """Return the section that was assessed: ``200 to 1000 m``."""
    return f"{one.section_m[0]:.0f} to {one.section_m[1]:.0f} m"


def speed(one: Assessment) -> str:
    """Return the speed: ``320 km/h``."""
    return f"{3.6 * one.speed_m_s:.4g} km/h"


def decided(one: Assessment) -> tuple[str, str]:
    """Return how many limits that decide are not met, in words, and the state of that."""
    missed = sum(each.fails for each in one.criteria)
    if missed:
        return f"{missed} not met", "missed"
    return ("met", "met") if one.is_judged else (NOT_JUDGED, "open")


def unsaid(whole: str, name: str, file: Path | None) -> str:
    """Return the whole name of a run; empty where its short name or its file says it."""
    return "" if name.endswith(whole) or whole in str(file) else whole


def origin(file: Path | None, digest: str | None) -> str:
    """Return where a run or a measurement was read, with its digest."""
    return IN_MEMORY if file is None else f"{file} (SHA-256 {digest})"


def limit(one: Judged, run: int) -> str:
    """Return value and limit of a criterion in a run: ``52.1 / 45.8``."""
    value, most = (number(found, one.decimals) for found in (one.values[run], one.limits[run]))
    return f"{value} / {most}"


def amount(found: float | None, unit: str) -> str:
    """Return a force with its unit: ``12.3 N``."""
    return NONE if found is None else f"{number(found, 1)}\u00a0{unit}"


def band_difference(one: Band, run: int) -> str:
    """Return the difference of a band to the first run with its sign and its percentage."""
    text, share = signed(one.differences_N[run], 1), one.percents[run]
    return text if share is None else f"{text} ({signed(share, 1)}\u00a0%)"


def accepted(one: Accepted) -> tuple[str, str, str, str, str]:
    """Return simulated and measured value, difference, tolerance with its mark, and verdict."""
    difference = signed(one.difference, one.decimals)
    if one.percent is not None:
        difference = f"{difference} ({signed(one.percent, 1)}\u00a0%)"
    words = {None: NONE, True: "yes", False: "no"}
    return (
        number(one.simulated, one.decimals), number(one.measured, one.decimals), difference,
        NONE if one.tolerance is None else f"{one.tolerance} ({one.mark})", words[one.within],
    )  # fmt: skip


def alignment(by: Alignment) -> tuple[str, str, str, str, str]:
    """Return way, offset, drift, correlation, and the next best one with its offset."""
    if by.method == "reference":
        return WAYS[by.method], NONE, NONE, NONE, NONE
    drift = f"{signed(1e3 * (by.scale - 1.0), 2)}\u00a0m/km" if by.scale != 1.0 else NONE
    following = NO_OTHER if by.correlation is not None else NONE
    if by.next_correlation is not None and by.next_offset_m is not None:
        following = (
            f"{number(by.next_correlation, 3)} at {signed(by.next_offset_m, 1)}\u00a0m"
            f"{', not sure' if by.ambiguous else ''}"
        )
    way, offset = WAYS[by.method].format(by.channel), f"{signed(by.offset_m, 2)}\u00a0m"
    alike = number(by.correlation, 3)
    if by.correlation is not None and by.correlation < POOR_CORRELATION:
        alike = f"{alike}, poor"
    return way, offset, drift, alike, following
