"""Options of what is above the force sensors of a measurement."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from arcless.measurements import Head


def head_of(mass: str | None, lift: str | None, down: bool) -> "Head | None":
    """Return what is above the force sensors, from the options; None where nobody gives it."""
    from arcless.errors import ModelError

    if mass is None and lift is None and not down:
        return None
    from arcless.measurements import Head

    if mass is None:
        alone = "--head-lift" if lift is not None else "--acceleration-down"
        raise ModelError(
            f"{alone} without --head-mass", expected="the mass above the force sensors"
        )
    try:
        return Head.of(mass, lift, acceleration_down=down)
    except ModelError as error:
        error.where = "--head-mass, --head-lift" if error.where is None else error.where
        raise
