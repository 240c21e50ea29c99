"""Constraints of outputs; hard ones on what can only get worse: a run that breaks one is over."""

from pydantic import Field

from arcless.errors import ModelError
from arcless.model.fields.part import Part

# Numbers of an assessment that can only grow, or only fall, as more of a run is known.
RISING = (
    "max_force_N", "unfiltered_max_force_N", "max_uplift_at_support_mm", "max_gap_mm",
    "longest_loss_s", "contact_loss_percent", "NQ_percent", "contact_point_range_mm",
    "slack_droppers_max",
)  # fmt: skip
FALLING = ("min_force_N", "unfiltered_min_force_N", "min_dropper_force_N", "criteria.uplift_space")
# Of these the filter looks ahead: they are certain in the part where it has settled.
FILTERED = ("max_force_N", "min_force_N")


class Constraint(Part):
    """A constraint: a bound of an output."""

    output: str = Field(description="Name of the output.")
    at_most: float | None = Field(default=None, description="Highest value that is allowed.")
    at_least: float | None = Field(default=None, description="Lowest value that is allowed.")
    hard: bool = Field(
        default=False, description="Whether a run that violates it for good is stopped immediately."
    )

    def excess(self, value: float) -> float:
        """Return by how much a value is outside; 0 or less where it is allowed."""
        above = -float("inf") if self.at_most is None else value - self.at_most
        below = -float("inf") if self.at_least is None else self.at_least - value
        return max(above, below)


def check_hard(bound: Constraint, expression: str) -> None:
    """Refuse a hard constraint that a run could break and yet keep in the end.

    Raises
    ------
    ModelError
        The output is none that can only get worse, or the bound is on its other side.
    """
    known, side = (RISING, "at_most") if bound.at_most is not None else (FALLING, "at_least")
    if key_of(expression) not in known:
        raise ModelError(
            "a hard constraint on what may still get better",
            got=f"{side} of {expression}",
            expected=f"at_most of {', '.join(RISING)}; or at_least of {', '.join(FALLING)}",
            hint="leave `hard` away: the constraint then counts when the run is over",
        )


def key_of(expression: str) -> str:
    """Return the key that an expression is, without the name of a pantograph before it."""
    text = expression.strip()
    return text if text.startswith("criteria.") else text.rpartition(".")[2]
