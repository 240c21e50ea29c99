"""Numbers of a comparison as text, for the page and the terminal."""

from arcless.comparison.indicators import Indicator, Judged
from arcless.display.numbers import number, pair

# Quantities of the first screen: those by which runs are judged first.
MAIN = (
    "mean_force_N", "std_force_N", "statistical_max_N", "statistical_min_N", "NQ_percent",
    "contact_loss_percent", "max_uplift_at_support_mm", "min_dropper_force_N",
)  # fmt: skip
NONE = "–"


def value(one: Indicator, run: int) -> str:
    """Return the value of a run, with its ± where that is known."""
    return pair(one.values[run], one.uncertainties[run], one.decimals)


def difference(one: Indicator, run: int) -> str:
    """Return the difference to the first run with its sign and its percentage, where it has one."""
    text = signed(one.differences[run], one.decimals)
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
