"""Ends of a wire: anchors, weights on a pulley, devices of constant force, springs.

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

from typing import Literal

Ends = Literal["fixed", "constant_force", "weights", "spring"]
# Of the place where the weights were chosen: the mass is there whatever gravity a run has, m/s².
GRAVITY = 9.81
# Of most tensioning wheels.
USUAL_RATIO = 3.0
