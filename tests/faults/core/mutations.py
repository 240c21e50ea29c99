"""Lines of the core spoiled one at a time, and the checks of tests/verification that must notice.

Each is a slip of the kind that compiles: a factor, a sign, a term or a column left as it was. It is
found by the function that it stands in, in whatever file that is, and by the least of an expression
that tells it from the rest of the function; capital letters are operands of any name. Where that is
written in another way, a quick test fails: then `old` is to be found again, never dropped.
"""

from tests.faults.core.conserved import CONSERVED
from tests.faults.core.explicit import EXPLICIT
from tests.faults.core.in_time import IN_TIME
from tests.support.mutants import Mutation

OSCILLATOR = "closed_forms/test_damped_oscillator.py::test_frequency_and_damping"
TROLLEY = "closed_forms/test_trolley_wire.py"
RAIL = "closed_forms/test_conductor_rail.py"
CONTACT = "conservation/test_contact_law.py::test_law"
LEDGER = "conservation/test_rolling_head.py::test_ledger"

WAVES = "closed_forms/test_wave_speed.py::test_phase_speed_with_period_correction"

SCHEME = [
    Mutation("half of the period error taken from the mass", "with_correct_period",
             "2.0 * A * B * B * C", "A * B * B * C", (WAVES,)),
    Mutation("weight of the old state left out of the period error", "AlphaScheme::period_error",
             "A * (1.0 - A) - B * (1.0 - B)", "-B * (1.0 - B)", (WAVES,)),
    Mutation("old acceleration counts twice in the velocity of the balance",
             "AlphaScheme::coefficients",
             "A * B * (1.0 - 0.5 * C / D)", "A * B * (1.0 - C / D)", (OSCILLATOR,)),
    Mutation("γ of generalised-α 0.1 too large", "generalised_alpha",
             "0.5 - A + B", "0.6 - A + B", (OSCILLATOR,)),
    Mutation("backward difference forgets 1 % of the old velocity", "backward_difference",
             "acceleration_from_v: -1.0 / A", "acceleration_from_v: -0.99 / A", (OSCILLATOR,)),
    Mutation("α of the old velocity dropped", "assemble",
             "A + B * C - (", "A - (", (LEDGER,)),
]  # fmt: skip

ELEMENTS = [
    Mutation("EA and tension 1 % high, in the tangent alone", "TangentPoint::new",
             "axial_stiffness;", "axial_stiffness * 1.01;",
             ("closed_forms/test_frequencies.py::test_across",)),
    Mutation("EI halved, in the tangent alone", "TangentPoint::add",
             "let bb = 2.0 * A", "let bb = A",
             (f"{RAIL}::test_first_frequency", f"{RAIL}::test_force_in_the_middle")),
    Mutation("tension of a bar 1 % low, in the tangent alone", "BarState::tangent",
             "= A / B;", "= 0.99 * A / B;",
             ("closed_forms/test_compound_elasticity.py::test_elasticity",)),
    Mutation("bends of a chain 1 % too stiff", "BendElement::new",
             "rigidity: A", "rigidity: 1.01 * A", (f"{RAIL}::test_sag",)),
    Mutation("consistent mass 1 % low", "add_hermite",
             "/ 420.0", "/ 420.0 * 0.99",
             ("closed_forms/test_point_mass.py::test_frequencies_with_an_insert",)),
]  # fmt: skip

STATICS = [
    Mutation("weight of cubic elements points up", "add_weight",
             "A.mass * B", "-A.mass * B", (f"{TROLLEY}::test_sag",)),
    Mutation("segments of a chain carry half of their weight", "add_chain_forces",
             "0.5 * A.mass", "0.25 * A.mass", (f"{TROLLEY}::test_sag", f"{RAIL}::test_sag")),
    Mutation("weight of a dropper on its upper node alone", "wires_and_weight",
             "+= 0.5 * weight;", "+= weight * f64::from(u8::from(node == link.nodes[0]));",
             ("closed_forms/test_force_balance.py::test_droppers_carry_the_contact_wire",)),
    Mutation("designed droppers longer, not shorter, by their stretch", "complete",
             "A - B / C;", "A + B / C;", ("references/test_dropper_lengths.py::test_as_built",)),
    Mutation("heat does not lengthen cubic elements", "applied",
             "wire.section.rest_length *= A;", "",
             ("closed_forms/test_tensioning_springs.py::test_travel_of_free_ends",)),
]  # fmt: skip

CONTACTS = [
    Mutation("a contact stays where it first touched", "seek",
             "self.place = place;", "if self.is_new { self.place = place; }",
             ("references/test_en50318_2002.py::test_ranges",)),
    Mutation("influence columns of the element before", "weighted",
             "number: A + B,", "number: A + B.saturating_sub(1),", (LEDGER,)),
    Mutation("stale column of a contact that slides along its strip", "Contact::read",
             "strip.read(&self.columns, A, &mut B);", "", (LEDGER,)),
    Mutation("contacts and slack droppers coupled symmetrically", "enter_contacts",
             "A / B - C;", "A / B + C;", (CONTACT,)),
    Mutation("slack droppers left out of the gaps", "enter_contacts",
             "A / B - C;", "A / B;", (CONTACT,)),
    Mutation("compliance of the contact as if the balance stood at the end of the step", "assemble",
             "1.0 / (A * B)", "1.0 / A", (CONTACT,)),
    Mutation("gap with the whole increment of the head", "measure_gaps",
             "A * inner(B, &C.delta)", "inner(B, &C.delta)", (CONTACT,)),
    Mutation("slope of the wire turned round where displacements are read", "Place::displacement",
             "+ A * B[DIM + C] + D", "- A * B[DIM + C] + D", (LEDGER,)),
]  # fmt: skip

RIDERS = [
    Mutation("damping of the pantograph dropped from the old velocity",
             "RiderState::free_increment",
             "+ A.damping[B] * C", "+ 0.0 * A.damping[B] * C",
             ("closed_forms/test_pantograph_response.py::test_response", LEDGER)),
]  # fmt: skip

ENERGY = [
    Mutation("the scheme's share of the traction not booked", "book_contacts",
             "A - B - C * D + E;", "A - C * D + E;", (LEDGER,)),
    Mutation("work of the wire that slides sideways not booked", "book_contacts",
             "A - B - C * D + E;", "A - B - C * D;", (LEDGER,)),
]  # fmt: skip

MUTATIONS = [
    *SCHEME,
    *ELEMENTS,
    *STATICS,
    *CONTACTS,
    *RIDERS,
    *ENERGY,
    *IN_TIME,
    *CONSERVED,
    *EXPLICIT,
]
