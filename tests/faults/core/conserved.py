"""What a run conserves: its state between two parts, its energy, its units, left and right."""

from tests.support.mutants import Mutation

PARTS = "conservation/test_save_resume.py::test_parts"

CONSERVED = [
    Mutation("a run goes on without its old accelerations", "Run::walk",
             'walk.numbers("line_acceleration", A)?;', "", (PARTS,)),
    Mutation("a run goes on from the inertia of a line at rest", "put_back",
             "self.p.go_on(&mut A);", "", (PARTS,)),
    Mutation("forces on their way to an actuator forgotten between two parts", "walk_rider",
             'walk_waiting(&mut A, B, &name("waiting"))?;', "", (PARTS,)),
    Mutation("dampers to ground booked twice", "book_springs",
             "A.dissipated_line -= B;", "",
             ("conservation/test_energy.py::test_the_ledger_closes",)),
    Mutation("damping of a dropper times its elongation, not its rate", "Begin::run",
             "A + B * C + D * E;", "A + B * C + D * (C + 0.0 * E);",
             ("conservation/test_units.py::test_mass_and_time",)),
    Mutation("lateral position of the wire without its sign", "weighted",
             "{ A } else", "{ A.abs() } else",
             ("conservation/test_mirror.py::test_left_and_right",)),
]  # fmt: skip
