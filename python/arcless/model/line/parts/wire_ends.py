"""What holds the ends of a wire: anchors, weights on a pulley, devices of constant force, springs.

A weight m on a pulley of ratio n pulls the wire by T = n m g, and goes n times as far as the end of
the wire. Lagrange's equation for the way u of that end, with the kinetic energy ½ m (n u̇)²:

    n² m ü = n m g − T_wire,      n² m = n T/g

so along the wire the end has the mass n T/g: 7 t for 22 kN and n = 3. A wave along the wire, whose
impedance is Z = √(EA μ), some 4.5 kN s/m, finds the end as good as anchored above Z g/(2π n T),
0.1 Hz.

Friction of pulley and bearings takes the share 1 − η of the work. Where the wire grows longer the
weight sinks and pulls with η T; where it grows shorter it lifts the weight with T/η. In between the
device holds still.
"""

from typing import TYPE_CHECKING, Literal

from arcless.errors import ModelError

if TYPE_CHECKING:
    from arcless.model.line.parts.components import Wire

Ends = Literal["fixed", "constant_force", "weights", "spring"]
# Of the place where the weights were chosen: the mass is there whatever gravity a run has, m/s².
GRAVITY = 9.81
# Of most tensioning wheels.
USUAL_RATIO = 3.0


def check_ends(wire: "Wire") -> None:
    """Raise `ModelError` for the first thing that does not fit the kind of ends."""
    if wire.ends == "spring" and wire.end_stiffness is None:
        raise ModelError(
            "missing field",
            expected=wire._expected("end_stiffness"),
            field=("end_stiffness",),
        )
    said = f"with ends: {wire.ends}" if wire.ends else "without ends"
    for name, kinds, what in (
        ("end_stiffness", ("spring",), "stiffness of a spring that is not there"),
        ("end_ratio", ("weights",), "ratio of a pulley that is not there"),
        ("end_efficiency", ("weights", "constant_force"), "friction of a device that has none"),
    ):
        if getattr(wire, name) is not None and wire.ends not in kinds:
            raise ModelError(
                what,
                got=f"{name} {said}",
                expected=f"ends: {' or '.join(kinds)}, or no {name}",
                field=(name,),
            )
    # A contact wire without tension that is no rail is told so itself, `ContactWire`.
    if wire.ends == "weights" and wire.tension == 0 and getattr(wire, "kind", "") != "wire":
        raise ModelError(
            "weights at a rail without tension",
            got="ends: weights",
            expected="ends: constant_force, its ends then slide",
            field=("ends",),
        )
