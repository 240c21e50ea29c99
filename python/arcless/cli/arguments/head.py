"""Options of what is above the force sensors of a measurement."""

from typing import TYPE_CHECKING, Annotated

import typer

if TYPE_CHECKING:
    from arcless.measurements import Head

HeadMassOption = Annotated[
    str | None,
    typer.Option(
        "--head-mass",
        metavar="MASS",
        help='Of a CSV file: mass above the force sensors, such as "5.2 kg"; its inertia is'
        " taken off.",
    ),
]
HeadLiftOption = Annotated[
    str | None,
    typer.Option(
        "--head-lift",
        metavar="FORCE",
        help='With --head-mass: lift of the air above the sensors, "8 N", or "0.002 N/(m/s)2"'
        " times the speed squared.",
    ),
]
AccelerationDownOption = Annotated[
    bool,
    typer.Option(
        "--acceleration-down",
        help="With --head-mass: accelerations are positive downwards; upwards without it.",
    ),
]


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
