"""Largest and least numbers that lines and pantographs may be made of, in SI.

Each is far beyond what anybody builds or assumes to make a part rigid, so that nobody who means a
number is refused; and low enough that what steps are made of, sums and products of stiffness, mass
and damping, stays inside of what numbers hold and tell apart. A number beyond is a slip: a unit
written twice, or a power too much.
"""

MASS = 1e6  # kg; a locomotive has 1e5
MASS_PER_METRE = 1e4  # kg/m; a conductor rail has 10
AXIAL_STIFFNESS = 1e13  # N; a conductor rail has 2e8
BENDING_STIFFNESS = 1e13  # N m²; a conductor rail has 3e5
TENSION = 1e9  # N; a contact wire breaks at 5e4
STIFFNESS = 1e13  # N/m; a cube of steel of 1 m has 2e11
ANGULAR_STIFFNESS = 1e13  # N m/rad
DAMPING = 1e9  # N s/m; the wave impedance of a wire is 200, of a rail track 1e6
ANGULAR_DAMPING = 1e9  # N m s/rad
# Shares of Rayleigh damping; with these all that moves in a second is damped a hundred times more
# than it takes to stop it swinging.
MASS_SHARE = 1e4  # 1/s
STIFFNESS_SHARE = 1e2  # s
# Divisors: waves run at the root of tension over mass, a stretch is tension over EA.
LEAST_MASS_PER_METRE = 1e-6  # kg/m
LEAST_TENSION = 1e-3  # N
LEAST_AXIAL_STIFFNESS = 1e-3  # N
# A clamp takes 0.04 m of its wire; points nearer than a micrometre are one in a mesh.
LEAST_CLAMP_DISTANCE = 0.1  # m
# Readings over time or along the line may begin before the run and end after it.
TIME = 1e6  # s; a train is on its way for 1e5
PLACE = 1e6  # m; a line is at most 1e5 long
AERODYNAMIC = 1e6  # N/(m/s)²; pantographs have 0.01
RATE = 1e12  # N/s
SHARE = 1e6  # of a coordinate in a direction
# No run lasts for one period of a lower frequency, and its filter cannot be solved for.
LEAST_FREQUENCY = 1e-3  # Hz; bands of contact force begin at 0.1
