"""Lines of the core spoiled one at a time, and the checks of tests/verification that must notice.

Each is a slip of the kind that compiles: a factor, a sign, a term or a column left as it was.
Source files move on; then `old` is to be found anew (a quick test says where), never dropped.
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
    Mutation(
        "half of the period error taken from the mass",
        "dynamics/period.rs",
        "2.0 * error * h * h * tension",
        "1.0 * error * h * h * tension",
        (WAVES,),
    ),
    Mutation(
        "weight of the old state left out of the period error",
        "scheme.rs",
        "alpha_f * (1.0 - alpha_f) - alpha_m * (1.0 - alpha_m)",
        "-alpha_m * (1.0 - alpha_m)",
        (WAVES,),
    ),
    Mutation(
        "old acceleration counts twice in the velocity of the balance",
        "scheme.rs",
        "velocity_from_a: keep_f * h * (1.0 - 0.5 * gamma / beta),",
        "velocity_from_a: keep_f * h * (1.0 - gamma / beta),",
        (OSCILLATOR,),
    ),
    Mutation(
        "γ of generalised-α 0.1 too large",
        "scheme.rs",
        "gamma: 0.5 - alpha_m + alpha_f,",
        "gamma: 0.6 - alpha_m + alpha_f,",
        (OSCILLATOR,),
    ),
    Mutation(
        "backward difference forgets 1 % of the old velocity",
        "scheme.rs",
        "acceleration_from_v: -1.0 / h,",
        "acceleration_from_v: -0.99 / h,",
        (OSCILLATOR,),
    ),
    Mutation(
        "α of the old velocity dropped",
        "dynamics/stepper.rs",
        "old_a[k] + alpha * old_v[k] -",
        "old_a[k] -",
        (LEDGER,),
    ),
]

ELEMENTS = [
    Mutation(
        "EA and tension 1 % high, in the tangent alone",
        "element/tangent.rs",
        "let axial = weight * l * section.axial_stiffness;",
        "let axial = weight * l * 1.01 * section.axial_stiffness;",
        ("closed_forms/test_frequencies.py::test_across",),
    ),
    Mutation(
        "EI halved, in the tangent alone",
        "element/tangent.rs",
        "let bb = 2.0 * f.t * one",
        "let bb = f.t * one",
        (f"{RAIL}::test_first_frequency", f"{RAIL}::test_force_in_the_middle"),
    ),
    Mutation(
        "tension of a bar 1 % low, in the tangent alone",
        "element/bar.rs",
        "let geometric = tension / self.length;",
        "let geometric = 0.99 * tension / self.length;",
        ("closed_forms/test_compound_elasticity.py::test_elasticity",),
    ),
    Mutation(
        "bends of a chain 1 % too stiff",
        "element/chain.rs",
        "rigidity: bending_stiffness * mean,",
        "rigidity: 1.01 * bending_stiffness * mean,",
        (f"{RAIL}::test_sag",),
    ),
    Mutation(
        "consistent mass 1 % low",
        "linalg/mass.rs",
        "let c = factor * m * l / 420.0;",
        "let c = 0.99 * factor * m * l / 420.0;",
        ("closed_forms/test_point_mass.py::test_frequencies_with_an_insert",),
    ),
]

STATICS = [
    Mutation(
        "weight of cubic elements points up",
        "statics/assembly.rs",
        "let w = wire.mass * gravity * l;",
        "let w = -wire.mass * gravity * l;",
        (f"{TROLLEY}::test_sag",),
    ),
    Mutation(
        "segments of a chain carry half of their weight",
        "statics/chain.rs",
        "let half = 0.5 * segment.mass",
        "let half = 0.25 * segment.mass",
        (f"{TROLLEY}::test_sag", f"{RAIL}::test_sag"),
    ),
    Mutation(
        "weight of a dropper on its upper node alone",
        "statics/assembly.rs",
        "residual[node][Self::UP] += 0.5 * weight;",
        "residual[node][Self::UP] += weight * f64::from(u8::from(node == link.nodes[0]));",
        ("closed_forms/test_force_balance.py::test_droppers_carry_the_contact_wire",),
    ),
    Mutation(
        "designed droppers longer, not shorter, by their stretch",
        "statics/design.rs",
        "length - tension / link.stiffness;",
        "length + tension / link.stiffness;",
        ("references/test_dropper_lengths.py::test_as_built",),
    ),
    Mutation(
        "heat does not lengthen cubic elements",
        "statics/alteration.rs",
        "wire.section.rest_length *= factor(self.length_factor[k]);",
        "",
        ("closed_forms/test_tensioning_springs.py::test_travel_of_free_ends",),
    ),
]

CONTACTS = [
    Mutation(
        "a contact stays where it first touched",
        "dynamics/contacts.rs",
        "        self.place = place;\n        if strip.looks_aside()",
        "        if self.is_new {\n            self.place = place;\n        }\n"
        "        if strip.looks_aside()",
        ("references/test_en50318_2002.py::test_ranges",),
    ),
    Mutation(
        "influence columns of the element before",
        "dynamics/path.rs",
        "number: self.before + number,",
        "number: self.before + number.saturating_sub(1),",
        (LEDGER,),
    ),
    Mutation(
        "stale column of a contact that slides along its strip",
        "dynamics/contacts.rs",
        "strip.read(&self.columns, self.lateral, &mut self.column);",
        "",
        (LEDGER,),
    ),
    Mutation(
        "contacts and slack droppers coupled symmetrically",
        "dynamics/contact.rs",
        "self.h[j * n + m + k] = rise / p.coefficients.stiffness - pulled;",
        "self.h[j * n + m + k] = rise / p.coefficients.stiffness + pulled;",
        (CONTACT,),
    ),
    Mutation(
        "slack droppers left out of the gaps",
        "dynamics/contact.rs",
        "self.h[j * n + m + k] = rise / p.coefficients.stiffness - pulled;",
        "self.h[j * n + m + k] = rise / p.coefficients.stiffness;",
        (CONTACT,),
    ),
    Mutation(
        "compliance of the contact as if the balance stood at the end of the step",
        "dynamics/stepper.rs",
        "contact_compliance: 1.0 / (contact_stiffness * c.stiffness),",
        "contact_compliance: 1.0 / contact_stiffness,",
        (CONTACT,),
    ),
    Mutation(
        "gap with the whole increment of the head",
        "dynamics/run.rs",
        "keep * inner(e, &rider.delta)",
        "inner(e, &rider.delta)",
        (CONTACT,),
    ),
    Mutation(
        "slope of the wire turned round where displacements are read",
        "dynamics/place.rs",
        "w[0] * a[c] + w[1] * a[DIM + c] + w[2]",
        "w[0] * a[c] - w[1] * a[DIM + c] + w[2]",
        (LEDGER,),
    ),
]

RIDERS = [
    Mutation(
        "damping of the pantograph dropped from the old velocity",
        "dynamics/rider.rs",
        "r.damping[k] * vf + ",
        "0.0 * r.damping[k] * vf + ",
        ("closed_forms/test_pantograph_response.py::test_response", LEDGER),
    ),
]

ENERGY = [
    Mutation(
        "the scheme's share of the traction not booked",
        "dynamics/contact_energy.rs",
        "on_line - by_scheme - force * rise + aside",
        "on_line - force * rise + aside",
        (LEDGER,),
    ),
    Mutation(
        "work of the wire that slides sideways not booked",
        "dynamics/contact_energy.rs",
        "on_line - by_scheme - force * rise + aside",
        "on_line - by_scheme - force * rise",
        (LEDGER,),
    ),
]

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
