"""What a run conserves: its state between two parts, its energy, its units, left and right."""

from tests.support.mutants import Mutation

PARTS = "conservation/test_save_resume.py::test_parts"

CONSERVED = [
    Mutation(
        "a run goes on without its old accelerations",
        "dynamics/resume.rs",
        'walk.numbers("line_acceleration", line.a.as_flattened_mut().iter_mut())?;',
        "",
        (PARTS,),
    ),
    Mutation(
        "a run goes on from the inertia of a line at rest",
        "dynamics/resume.rs",
        "self.p.go_on(&mut self.state);",
        "",
        (PARTS,),
    ),
    Mutation(
        "forces on their way to an actuator forgotten between two parts",
        "dynamics/resume.rs",
        'walk_waiting(&mut rider.actuator, walk, &name("waiting"))?;',
        "",
        (PARTS,),
    ),
    Mutation(
        "dampers to ground booked twice",
        "dynamics/ledger.rs",
        "self.entries.dissipated_line -= lost;",
        "",
        ("conservation/test_energy.py::test_the_ledger_closes",),
    ),
    Mutation(
        "damping of a dropper times its elongation, not its rate",
        "dynamics/links.rs",
        "k[i] * e[i] + viscosity[i] * rate;",
        "k[i] * e[i] + viscosity[i] * (e[i] + 0.0 * rate);",
        ("conservation/test_units.py::test_mass_and_time",),
    ),
    Mutation(
        "lateral position of the wire without its sign",
        "dynamics/path.rs",
        "lateral: if DIM == 3 { r[1] } else { 0.0 },",
        "lateral: if DIM == 3 { r[1].abs() } else { 0.0 },",
        ("conservation/test_mirror.py::test_left_and_right",),
    ),
]
