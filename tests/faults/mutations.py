"""Lines of the core spoiled one at a time, and the checks of tests/verification that must notice.

Each is a slip of the kind that compiles: a factor, a sign, a term or a column left as it was. It is
found by the function that it stands in, in whatever file that is, and by the least of an expression
that tells it from the rest of the function; capital letters are operands of any name. Where that is
written in another way, a quick test fails: then `old` is to be found again, never dropped.
"""

from tests.support.mutants import Mutation

OSCILLATOR = "closed_forms/test_damped_oscillator.py::test_frequency_and_damping"
TROLLEY = "closed_forms/test_trolley_wire.py"
RAIL = "closed_forms/test_conductor_rail.py"
SPRINGS = "closed_forms/test_tensioning_springs.py"
CONTACT = "conservation/test_contact_law.py::test_law"
LEDGER = "conservation/test_rolling_head.py::test_ledger"
WAVES = "closed_forms/test_wave_speed.py::test_phase_speed_with_period_correction"
RESPONSE = "closed_forms/test_pantograph_response.py::test_response"
IMPACT = "closed_forms/test_compliant_impact.py::test_a_bounce"
TIME_STEP = "orders/test_time_step.py::test_order"
PARTS = "conservation/test_save_resume.py::test_parts"
CHAINS = "closed_forms/test_elasticity_shipped.py::test_chains"
CUBIC = "orders/test_explicit_steps.py::test_shorter_cubic_elements"
DROPPERS = "closed_forms/test_obstacles.py::test_dropper"
CURVE = "closed_forms/test_curve.py::test_families"
CLOSES = "conservation/test_energy_explicit.py::test_the_ledger_closes"
GUESTS = "conservation/test_energy_explicit.py::test_wires_at_points_of_others"
FALLS = "conservation/test_energy_explicit.py::test_switching_falls_with_the_step"

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
    Mutation("α of the old velocity dropped", "Implicit::new",
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
    Mutation("weight of a dropper on its upper node alone", "wire_and_weight_residual",
             "+= 0.5 * weight;", "+= weight * f64::from(u8::from(node == link.nodes[0]));",
             ("closed_forms/test_force_balance.py::test_droppers_carry_the_contact_wire",)),
    Mutation("designed droppers longer, not shorter, by their stretch", "store_lengths",
             "A - B / C;", "A + B / C;", ("references/test_dropper_lengths.py::test_as_built",)),
    Mutation("heat does not lengthen cubic elements", "applied",
             "wire.section.rest_length *= A;", "", (f"{SPRINGS}::test_travel_of_free_ends",)),
    Mutation("heat does not lengthen chains", "applied",
             "segment.rest_length *= A;", "", (f"{SPRINGS}::test_travel_of_free_ends",)),
]  # fmt: skip

CONTACTS = [
    Mutation("a contact stays where it first touched", "locate_points",
             "self.point = point;", "if self.is_new { self.point = point; }",
             ("references/test_en50318_2002.py::test_ranges",)),
    Mutation("influence columns of the element before", "weighted_point",
             "number: A + B,", "number: A + B.saturating_sub(1),", (LEDGER,)),
    Mutation("stale column of a contact that slides along its strip",
             "Contact::interpolate_vectors",
             "strip.interpolate(&self.columns, A, &mut B);", "", (LEDGER,)),
    Mutation("contacts and slack droppers coupled symmetrically", "link_coupling",
             "A / B - C", "A / B + C", (CONTACT,)),
    Mutation("slack droppers left out of the gaps", "link_coupling",
             "A / B - C", "A / B", (CONTACT,)),
    Mutation("compliance of the contact as if the balance stood at the end of the step",
             "Wires::new", "1.0 / (A * B)", "1.0 / A", (CONTACT,)),
    Mutation("gap with the whole increment of the head", "measure_gaps",
             "A * inner(B, &C.delta)", "inner(B, &C.delta)", (CONTACT,)),
    Mutation("slope of the wire turned round where displacements are read",
             "SlidelinePoint::displacement",
             "+ A * B[DIM + C] + D", "- A * B[DIM + C] + D", (LEDGER,)),
]  # fmt: skip

RIDERS = [
    Mutation("damping of the pantograph dropped from the old velocity",
             "PantographState::predict",
             "+ A.damping[B] * C", "+ 0.0 * A.damping[B] * C", (RESPONSE, LEDGER)),
]  # fmt: skip

ENERGY = [
    Mutation("the scheme's share of the traction not booked", "ContactEnergies::add",
             "A - B - C * D + E;", "A - C * D + E;", (LEDGER,)),
    Mutation("work of the wire that slides sideways not booked", "ContactEnergies::add",
             "A - B - C * D + E;", "A - B - C * D;", (LEDGER,)),
]  # fmt: skip

# Values of a step taken at another instant than that of the balance, and what goes with it.

IN_TIME = [
    Mutation("contact where it is at the end of the step", "Histories::at",
             "between(A), B[step + 1]", "B[step + 1], B[step + 1]",
             ("orders/test_time_step_of_a_run.py::test_order",)),
    Mutation("given forces of pantographs at the end of the step", "Excitation::read",
             "(1.0 - A) * B[step + 1] + A * B[step]", "B[step + 1] + 0.0 * A",
             (TIME_STEP, RESPONSE)),
    Mutation("loads of the line at the end of the step", "Histories::at",
             "between(&A.sizes)", "A.sizes[step + 1]", (TIME_STEP,)),
    Mutation("masses recorded at the end of the step", "record_contacts",
             "A + B * C - D", "A + 0.0 * B * C + C - D", (TIME_STEP, RESPONSE)),
    Mutation("compliance of the contact without the weight of the balance", "Wires::new",
             "1.0 / (A * B)", "1.0 / A", (IMPACT, RESPONSE)),
    Mutation("rate of the moving roof dropped", "Excitation::read",
             "between(&A.rate)", "0.0 * between(&A.rate)", (RESPONSE,)),
    Mutation("forces of the present position 1 % low with updated kinematics",
             "Implicit::predict",
             "-= A[B];", "-= 0.99 * A[B];", ("orders/test_time_step_updated.py::test_order",)),
    Mutation("bend with the length of the piece before it", "BendElement::new",
             "rigidity: A * mean", "rigidity: A * before",
             ("orders/test_element_length.py::test_frequencies",)),
]  # fmt: skip

# What a run conserves: its state between two parts, its energy, its units, left and right.

CONSERVED = [
    Mutation("a run goes on without its old accelerations", "WireState::archive",
             'archive.numbers("line_acceleration", A)?;', "", (PARTS,)),
    Mutation("a run goes on from the inertia of a line at rest", "restore",
             "A.wires.resume(&mut B.wires);", "", (PARTS,)),
    Mutation("forces on their way to an actuator forgotten between two parts", "archive_pantograph",
             'archive_pending_forces(&mut A, B, &name("waiting"))?;', "", (PARTS,)),
    Mutation("dampers to ground booked twice", "separate_ground_dampers",
             "A.dissipated_line -= B;", "",
             ("conservation/test_energy.py::test_the_ledger_closes",)),
    Mutation("damping of a dropper times its elongation, not its rate", "PredictTensions::run",
             "A + B * C + D * E;", "A + B * C + D * (C + 0.0 * E);",
             ("conservation/test_units.py::test_mass_and_time",)),
    Mutation("lateral position of the wire without its sign", "weighted_point",
             "{ A } else", "{ A.abs() } else",
             ("conservation/test_mirror.py::test_left_and_right",)),
]  # fmt: skip

# Explicit steps, and the chains they step: what makes them yield, move and damp as wires do.

YIELDING = [
    Mutation("bends of fitted chains with EI of the wire", "bending",
             "A * B / B.tanh()", "A",
             # At rest points yield the more instead, and no check notices: in motion these do.
             ("closed_forms/test_explicit_waves.py::test_phase_speed",
              "closed_forms/test_moving_kink.py::test_kink",
              "closed_forms/test_obstacles.py::test_spring")),
    Mutation("chains yield between points as their curves do",
             "SmoothedSegment::residual_flexibility", "(A - B) / C", "0.0 * (A - B) / C",
             (CHAINS,)),
    Mutation("kinks between points sharp, as those of a string", "Corner::value",
             "0.5 * (A + B * C)", "0.5 * A", (CHAINS,)),
    Mutation("droppers of chains without what their wires yield", "set_stiffness",
             "1.0 + A * B", "1.0 + 0.0 * A * B", (DROPPERS,)),
]  # fmt: skip

MOVING = [
    Mutation("ends of pieces along the wire not drawn to the inside of curves", "add_curve_forces",
             "A.half_turn * B", "0.0 * A.half_turn * B", (CURVE,)),
    Mutation("filter turned round for what fitted bends add to the speed of waves",
             "filter_weights",
             "(1.0 - A) / 12.0 - B", "(1.0 - A) / 12.0 + B", (CUBIC,)),
    Mutation("second term of the filter left out", "correct_dispersion",
             "= mean(&A) * B;", "= 0.0 * mean(&A) * B;", (CUBIC,)),
    Mutation("damping of wires in proportion to stiffness left out of explicit steps",
             "add_segments",
             "A.beta / B", "0.0 * A.beta / B", (CUBIC,)),
    Mutation("tension that a run adds does not turn wires back", "WireForceKernel::advance",
             "A.axial_force[B] * C", "0.0 * A.axial_force[B] * C", (CUBIC,)),
    Mutation("reaches over cuts stretched by their last strand alone", "AxialForces::add",
             "- rise_at(A, B) + C;", "- rise_at(A, B) + 0.0 * C;", (CUBIC,)),
    Mutation("filter across cuts without what contacts and links have pushed",
             "Explicit::advance_island",
             "self.copy_ghost_forces(A, B);", "", (CUBIC,)),
    Mutation("a run of explicit steps goes on without its last increments",
             "ChainState::transverse_motion",
             "A.chain(B)", "A", (PARTS,)),
]  # fmt: skip

LINKED = [
    Mutation("links of explicit steps with β of 1/2 in the place of 1/4", "force_columns",
             "A * B + 0.5 / C * D", "2.0 * A * B + 0.5 / C * D", (CUBIC,)),
    Mutation("response of linked points as if nothing were filtered", "ChainBuilder::member",
             "A.map(|B| B * (1.0 + B * C))", "A", (CUBIC,)),
    Mutation("links do not answer to a contact beside them within the step", "Explicit::add_force",
             "self.add_stiff_response(A, B, C * D + E, F * G);", "", (CUBIC,)),
    Mutation("masses on wires left out of explicit steps", "node_masses",
             ".chain(on_wires)", ".chain(on_wires.take(0))", (CUBIC,)),
]  # fmt: skip

BOOKED = [
    Mutation("contacts press on the wire where they were a step ago", "apply",
             "let point = &A.point;", "let point = &A.ends[0];", (CLOSES,)),
    Mutation("gaps are those of the contacts a step ago", "wire_at",
             "let place = &A.point;", "let place = &A.ends[0];", (FALLS,)),
    Mutation("ends of wires at points of others stay behind by a millionth", "accelerate_tied_ends",
             "= filtered_acceleration(", "= (1.0 - 1e-6) * filtered_acceleration(", (GUESTS,)),
    Mutation("damping along the wire of an older velocity", "clear_master_forces",
             "A + B * C;", "A + 1.001 * B * C;", (CLOSES,)),
    Mutation("damping across the wire a thousandth too much", "WireForceKernel::advance",
             ", -A * B", ", -1.001 * A * B", (CLOSES,)),
    Mutation("energy of the motion without the filter", "EnergyForm::new",
             "FilteredMass::new(&A, &B, &C)",
             "FilteredMass::new(&A, &vec![0.0; B.len()], &C)", (CLOSES,)),
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
    *YIELDING,
    *MOVING,
    *LINKED,
    *BOOKED,
]
