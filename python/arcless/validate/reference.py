"""Published ranges and values that a run can be held against, each with source and mark.

Marks: A, read in the named source; C*, remembered and only checked for plausibility, hence
unverified as a number of the standard. Verdicts on unverified ranges never decide anything.
"""

from dataclasses import dataclass
from math import inf

from arcless.assess import decides
from arcless.assess.quantities import QUANTITIES, label_of

VERIFIED = "A"
INSIDE = "inside"
OUTSIDE = "outside"
# Behind a verdict on a value that is nearer to a bound than it is sure: it decides nothing.
CLOSE = "too close to tell"


@dataclass(frozen=True, slots=True)
class Range:
    """Range that a published source allows for one quantity.

    Parameters
    ----------
    key : str
        Key of the quantity in the assessment.
    label, unit : str
        How to print it.
    low, high : float or None
        Bounds in `unit`; None where there is none.
    mark : str
        Confidence mark of the bounds.
    strict : bool
        Whether the bounds themselves are not allowed.
    digits : int
        Decimals of a printed value.
    """

    key: str
    label: str
    unit: str
    low: float | None
    high: float | None
    mark: str
    strict: bool = False
    digits: int = 1

    def verdict(self, value: float | None, uncertainty: float | None = None) -> str:
        """Say where a value lies: inside, outside, or outside of an unverified range.

        Of a value that is nearer to a bound than its uncertainty, that it is too close to tell.
        """
        if value is not None and uncertainty is not None and self._distance(value) < uncertainty:
            return f"{INSIDE if self._allows(value) else OUTSIDE}, {CLOSE}"
        if value is not None and self._allows(value):
            return INSIDE
        return OUTSIDE if decides(self.mark) else f"{OUTSIDE} (unverified)"

    @property
    def limit(self) -> str:
        """The bounds as text, with as many decimals as they need."""
        bounds = [bound for bound in (self.low, self.high) if bound is not None]
        shown = min(self.digits, 3) if any(bound % 1 for bound in bounds) else 0
        texts = [f"{bound:.{shown}f}" for bound in bounds]
        if len(texts) > 1:
            return " … ".join(texts)
        sign = (">" if self.strict else "≥") if self.high is None else "<" if self.strict else "≤"
        return f"{sign} {texts[0]}"

    def _distance(self, value: float) -> float:
        """Return how far a value is from the nearest bound."""
        return min(abs(value - bound) for bound in (self.low, self.high) if bound is not None)

    def _allows(self, value: float) -> bool:
        low = -inf if self.low is None else self.low
        high = inf if self.high is None else self.high
        return low < value < high if self.strict else low <= value <= high


@dataclass(frozen=True, slots=True)
class Case:
    """A shipped scenario together with the ranges published for it."""

    scenario: str
    title: str
    source: str
    ranges: tuple[Range, ...]


def _ranges(mark: str, bounds: dict[str, tuple[float, float]]) -> tuple[Range, ...]:
    return tuple(
        Range(key, label_of(key), QUANTITIES[key].unit, *bounds[key], mark) for key in bounds
    )


_EN_50318_2002 = (
    "EN 50318:2002, as quoted in table III of Wang, Liu, Mu, Huang, Wang, Gao, "
    '"An Extended Habedank\'s Equation-Based EMTP Model of Pantograph Arcing" (2015); '
    "the standard itself was not read"
)
_AC_SIMPLE = (
    "remembered as the ranges of EN 50318:2018 for AC simple; the standard was not read, "
    "so these are no proof either way"
)

# Nothing says that the published model is planar: both forms of the line are held against it.
_AC_SIMPLE_RANGES = {
    275: _ranges(
        "C*",
        {
            "mean_force_N": (141.5, 146.5),
            "std_force_N": (31.9, 34.8),
            "std_force_0_5Hz_N": (26.4, 28.9),
            "std_force_5_20Hz_N": (16.2, 19.4),
            "max_force_N": (219.0, 244.0),
            "min_force_N": (71.0, 86.0),
            "contact_point_range_mm": (38.0, 49.0),
            "max_uplift_at_support_mm": (41.0, 51.0),
            "contact_loss_percent": (0.0, 0.0),
        },
    ),
    320: _ranges(
        "C*",
        {
            "mean_force_N": (166.5, 171.5),
            "std_force_N": (49.5, 62.9),
            "std_force_0_5Hz_N": (38.7, 44.4),
            "std_force_5_20Hz_N": (29.0, 46.2),
            "max_force_N": (295.0, 343.0),
            "min_force_N": (55.0, 82.0),
            "contact_point_range_mm": (41.0, 61.0),
            "max_uplift_at_support_mm": (49.0, 62.0),
            "contact_loss_percent": (0.0, 0.0),
        },
    ),
}

CASES = (
    Case(
        "en50318-2002-250",
        "EN 50318:2002, 250 km/h",
        _EN_50318_2002,
        _ranges(
            VERIFIED,
            {
                "mean_force_N": (110.0, 120.0),
                "std_force_N": (26.0, 31.0),
                "statistical_max_N": (190.0, 210.0),
                "statistical_min_N": (20.0, 40.0),
                "max_force_N": (175.0, 210.0),
                "min_force_N": (50.0, 75.0),
                "max_uplift_at_support_mm": (48.0, 55.0),
                "contact_loss_percent": (0.0, 0.0),
            },
        ),
    ),
    Case(
        "en50318-2002-300",
        "EN 50318:2002, 300 km/h",
        _EN_50318_2002,
        _ranges(
            VERIFIED,
            {
                "mean_force_N": (110.0, 120.0),
                "std_force_N": (32.0, 40.0),
                "statistical_max_N": (210.0, 230.0),
                "statistical_min_N": (-5.0, 20.0),
                "max_force_N": (190.0, 225.0),
                "min_force_N": (30.0, 55.0),
                "max_uplift_at_support_mm": (55.0, 65.0),
                "contact_loss_percent": (0.0, 0.0),
            },
        ),
    ),
    *(
        Case(
            f"en50318-ac-simple-{speed}{suffix}",
            f"AC simple, {form}{speed} km/h",
            _AC_SIMPLE,
            ranges,
        )
        for suffix, form in (("", ""), ("-planar", "planar, "))
        for speed, ranges in _AC_SIMPLE_RANGES.items()
    ),
)


@dataclass(frozen=True, slots=True)
class DropperLengths:
    """Dropper lengths published for one span of a shipped scenario, in metres."""

    scenario: str
    title: str
    source: str
    mark: str
    lengths: tuple[float, ...]
    tolerance: float


# 3 mm: the source prints whole millimetres, and an equilibrium of its data is 2–3 mm off.
DROPPERS = DropperLengths(
    scenario="en50318-ac-simple-320-planar",
    title="AC simple, statics",
    source="vivek-nexus/pantograph-catenary-model-ui, constants/defaultsValues.js (S1)",
    mark=VERIFIED,
    lengths=(1.017, 0.896, 0.810, 0.758, 0.741, 0.758, 0.810, 0.896, 1.017),
    tolerance=3e-3,
)
