"""Explicit steps, and the chains they step: what makes them yield, move and damp as wires do."""

from tests.support.mutants import Mutation

CHAINS = "closed_forms/test_elasticity_shipped.py::test_chains"
MESH = "references/test_dropper_lengths.py::test_mesh"
CUBIC = "orders/test_explicit_steps.py::test_shorter_cubic_elements"
FAR_APART = "conservation/test_far_apart.py::test_trailing"
PARTS = "conservation/test_save_resume.py::test_parts"
DROPPERS = "closed_forms/test_obstacles.py::test_dropper"
CURVE = "closed_forms/test_curve.py::test_families"

YIELDING = [
    Mutation("bends of fitted chains with EI of the wire", "bending",
             "A * B / B.tanh()", "A", (CHAINS, MESH)),
    Mutation("chains yield between points as their curves do", "Rounded::own",
             "(A - B) / C", "0.0 * (A - B) / C", (CHAINS,)),
    Mutation("kinks between points sharp, as those of a string", "Corner::at",
             "0.5 * (A + B * C)", "0.5 * A", (CHAINS,)),
    Mutation("droppers of chains without what their wires yield", "set",
             "1.0 + A * B", "1.0 + 0.0 * A * B", (DROPPERS,)),
]  # fmt: skip

MOVING = [
    Mutation("ends of pieces along the wire not drawn to the inside of curves", "lean",
             "A.lean * B", "0.0 * A.lean * B", (CURVE,)),
    Mutation("filter turned round for what fitted bends add to the speed of waves", "shares",
             "(1.0 - A) / 12.0 - B", "(1.0 - A) / 12.0 + B", (CUBIC,)),
    Mutation("second term of the filter left out", "keep_speed",
             "= mean(&A) * B;", "= 0.0 * mean(&A) * B;", (CUBIC,)),
    Mutation("damping of wires in proportion to stiffness left out of explicit steps",
             "add_segments",
             "A.beta / B", "0.0 * A.beta / B", (CUBIC,)),
    Mutation("tension that a run adds does not turn wires back", "Forces::go",
             "A.thrust[B] * C", "0.0 * A.thrust[B] * C", (CUBIC,)),
    Mutation("reaches over cuts stretched by their last strand alone", "Pulled::stretch",
             "- rise(A, B) + C;", "- rise(A, B) + 0.0 * C;", (CUBIC,)),
    Mutation("filter across cuts without what contacts and links have pushed", "Explicit::go",
             "self.copy_forces(A, B);", "", (CUBIC,)),
    Mutation("a run of explicit steps goes on without its last increments", "Grid::across",
             "A.chain(B)", "A", (PARTS,)),
]  # fmt: skip

LINKED = [
    Mutation("links of explicit steps with β of 1/2 in the place of 1/4", "forces",
             "A * B + 0.5 / C * D", "2.0 * A * B + 0.5 / C * D", (CUBIC,)),
    Mutation("response of linked points as if nothing were filtered", "Chains::member",
             "A.map(|B| B * (1.0 + B * C))", "A", (CUBIC,)),
    Mutation("links do not answer to a contact beside them within the step", "Explicit::push",
             "self.answer(A, B, C * D + E, F * G);", "", (CUBIC, FAR_APART)),
    Mutation("droppers without mass in explicit steps", "masses",
             "0.5 * A.mass * Geometry", "0.0 * A.mass * Geometry", (CUBIC,)),
]  # fmt: skip

CLOSES = "conservation/test_energy_explicit.py::test_the_ledger_closes"
GUESTS = "conservation/test_energy_explicit.py::test_wires_at_points_of_others"
FALLS = "conservation/test_energy_explicit.py::test_switching_falls_with_the_step"

BOOKED = [
    Mutation("contacts press on the wire where they were a step ago", "respond",
             "let place = &A.place;", "let place = &A.ends[0];", (CLOSES,)),
    Mutation("gaps are those of the contacts a step ago", "wire_at",
             "let place = &A.place;", "let place = &A.ends[0];", (FALLS,)),
    Mutation("ends of wires at points of others stay behind by a millionth", "take_along",
             "= accelerated(", "= (1.0 - 1e-6) * accelerated(", (GUESTS,)),
    Mutation("damping along the wire of an older velocity", "release",
             "A + B * C;", "A + 1.001 * B * C;", (CLOSES,)),
    Mutation("damping across the wire a thousandth too much", "Forces::go",
             ", -A * B", ", -1.001 * A * B", (CLOSES,)),
    Mutation("energy of the motion without the filter", "Form::new",
             "Filtered::new(&A, &B, &C)", "Filtered::new(&A, &vec![0.0; B.len()], &C)", (CLOSES,)),
]  # fmt: skip

EXPLICIT = [*YIELDING, *MOVING, *LINKED, *BOOKED]
