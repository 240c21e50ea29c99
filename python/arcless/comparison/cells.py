"""Numbers of a comparison as text, for the page and the terminal."""

from arcless.comparison.indicators import Indicator, Judged
from arcless.display.numbers import number, pair

# Quantities of the first screen: those by which runs are judged first.
MAIN = (
    "mean_force_N", "std_force_N", "statistical_max_N", "statistical_min_N", "NQ_percent",
    "contact_loss_percent", "max_uplift_at_support_mm", "min_dropper_force_N",
)  # fmt: skip
NONE = "–"
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


def limit(one: Judged, run: int) -> str:
    """Return value and limit of a criterion in a run: ``52.1 / 45.8``."""
    value, most = (number(found, one.decimals) for found in (one.values[run], one.limits[run]))
    return f"{value} / {most}"


def signed(found: float | None, decimals: int) -> str:
    """Return a number with its sign, plus or a real minus; zero has none."""
    text = number(found, decimals)
    if found is None or not any(digit in text for digit in "123456789"):
        return text.removeprefix("−")
    return text if text.startswith("−") else f"+{text}"
