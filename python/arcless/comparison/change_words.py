"""Differences between two runs in one sentence: better, worse, the same."""

from typing import TYPE_CHECKING

from arcless.display.numbers import signed

if TYPE_CHECKING:
    from arcless.comparison.compared import Compared
    from arcless.comparison.indicators import Indicator

# Quantities that are the better the lower they are, and their names in a sentence.
LOWER_IS_BETTER = {
    "std_force_N": "standard deviation of the force",
    "max_force_N": "maximum force",
    "contact_loss_percent": "contact loss",
    "max_uplift_at_support_mm": "uplift at supports",
}


def change_words(compared: "Compared") -> list[str]:
    """Return a sentence for each run but the first: better in this, worse in that, no change.

    A difference changes nothing where it is no larger than its ±, or rounds to zero as it is
    printed. A measurement is neither better nor worse than a simulation: it has no sentence, and
    there is none where the first is one.
    """
    if compared.sides[0].placed is not None:
        return []
    return [
        f"{name}, compared with {compared.names[0]}: {_words(compared, run)}."
        for run, (name, side) in enumerate(zip(compared.names, compared.sides, strict=True))
        if run and side.placed is None
    ]


def _words(compared: "Compared", run: int) -> str:
    several = len(compared.pantographs) > 1
    better: list[str] = []
    worse: list[str] = []
    same: list[str] = []
    unknown: list[str] = []
    for key, what in LOWER_IS_BETTER.items():
        for one in (each for each in compared.indicators if each.key == key):
            whose = f"{what} of {one.pantograph}" if several and one.pantograph else what
            text = signed(one.differences[run], one.decimals)
            difference = one.differences[run]
            if difference is None:
                unknown.append(whose)
            elif _unchanged(one, run):
                same.append(whose)
            else:
                (better if difference < 0.0 else worse).append(f"{whose} ({text}\u00a0{one.unit})")
    parts = [
        (better, "better: {}"),
        (worse, "worse: {}"),
        (same, "no change beyond the ± or the rounding: {}"),
        (unknown, "not known of both: {}"),
    ]
    return "; ".join(form.format(", ".join(which)) for which, form in parts if which)


def _unchanged(one: "Indicator", run: int) -> bool:
    """Say whether a difference is too small to be told."""
    text = signed(one.differences[run], one.decimals)
    return one.too_close_to_tell(run) or not any(digit in text for digit in "123456789")
