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
    Mutation(
        "bends of fitted chains with EI of the wire",
        "statics/chain.rs",
        "bend.stiffness * x / x.tanh()",
        "bend.stiffness",
        (CHAINS, MESH),
    ),
    Mutation(
        "chains yield between points as their curves do",
        "dynamics/rounded.rs",
        "(g - self.taut.wire.at(0.0)) / self.taut.tension",
        "0.0 * (g - self.taut.wire.at(0.0)) / self.taut.tension",
        (CHAINS,),
    ),
    Mutation(
        "kinks between points sharp, as those of a string",
        "dynamics/rounded.rs",
        "0.5 * (s.abs() + self.rise * self.faded(s))",
        "0.5 * s.abs()",
        (CHAINS,),
    ),
    Mutation(
        "droppers of chains without what their wires yield",
        "statics/flexibility.rs",
        "let share = 1.0 + given * r;",
        "let share = 1.0 + 0.0 * given * r;",
        (DROPPERS,),
    ),
]

MOVING = [
    Mutation(
        "ends of pieces along the wire not drawn to the inside of curves",
        "dynamics/explicit/stretch.rs",
        "let force = reach.lean * grid.thrust[number];",
        "let force = 0.0 * reach.lean * grid.thrust[number];",
        (CURVE,),
    ),
    Mutation(
        "filter turned round for what fitted bends add to the speed of waves",
        "dynamics/explicit/waves.rs",
        "(1.0 - courant) / 12.0 - more",
        "(1.0 - courant) / 12.0 + more",
        (CUBIC,),
    ),
    Mutation(
        "second term of the filter left out",
        "dynamics/explicit/waves.rs",
        "self.second[point] = mean(&waves.mass) * b;",
        "self.second[point] = 0.0 * mean(&waves.mass) * b;",
        (CUBIC,),
    ),
    Mutation(
        "damping of wires in proportion to stiffness left out of explicit steps",
        "dynamics/explicit/layout.rs",
        "self.lag[point] = segment.damping.beta / self.h;",
        "self.lag[point] = 0.0 * segment.damping.beta / self.h;",
        (CUBIC,),
    ),
    Mutation(
        "tension that a run adds does not turn wires back",
        "dynamics/explicit/kernels.rs",
        "at.thrust[l] * this.slope[l]",
        "0.0 * at.thrust[l] * this.slope[l]",
        (CUBIC,),
    ),
    Mutation(
        "reaches over cuts stretched by their last strand alone",
        "dynamics/explicit/stretch.rs",
        "rise(self.first, to) - rise(self.first, from) + before;",
        "rise(self.first, to) - rise(self.first, from) + 0.0 * before;",
        (CUBIC,),
    ),
    Mutation(
        "filter across cuts without what contacts and links have pushed",
        "dynamics/explicit/stepping.rs",
        "self.copy_forces(own, grid);\n        widest(Sweep {",
        "widest(Sweep {",
        (CUBIC,),
    ),
    Mutation(
        "a run of explicit steps goes on without its last increments",
        "dynamics/explicit/mod.rs",
        "row.s.iter_mut().chain(row.d.iter_mut())",
        "row.s.iter_mut()",
        (PARTS,),
    ),
]

LINKED = [
    Mutation(
        "links of explicit steps with β of 1/2 in the place of 1/4",
        "dynamics/explicit/cluster.rs",
        "super::BETA * k + 0.5 / h * c",
        "2.0 * super::BETA * k + 0.5 / h * c",
        (CUBIC,),
    ),
    Mutation(
        "response of linked points as if nothing were filtered",
        "dynamics/explicit/clusters.rs",
        "inverse.map(|own| own * (1.0 + own * felt))",
        "inverse",
        (CUBIC,),
    ),
    Mutation(
        "links do not answer to a contact beside them within the step",
        "dynamics/explicit/push.rs",
        "self.answer(grid, number, place * DIM + component, felt * change);",
        "",
        (CUBIC, FAR_APART),
    ),
    Mutation(
        "droppers without mass in explicit steps",
        "dynamics/explicit/layout.rs",
        "let half = 0.5 * link.mass * Geometry",
        "let half = 0.0 * link.mass * Geometry",
        (CUBIC,),
    ),
]

CLOSES = "conservation/test_energy_explicit.py::test_the_ledger_closes"
GUESTS = "conservation/test_energy_explicit.py::test_wires_at_points_of_others"
FALLS = "conservation/test_energy_explicit.py::test_switching_falls_with_the_step"

BOOKED = [
    Mutation(
        "contacts press on the wire where they were a step ago",
        "dynamics/stepper.rs",
        "let place = &contacts.all[j].place;\n            let change",
        "let place = &contacts.all[j].ends[0];\n            let change",
        (CLOSES,),
    ),
    Mutation(
        "gaps are those of the contacts a step ago",
        "dynamics/watch.rs",
        "let place = &contact.place;",
        "let place = &contact.ends[0];",
        (FALLS,),
    ),
    Mutation(
        "ends of wires at points of others stay behind by a millionth",
        "dynamics/explicit/guests.rs",
        "= accelerated(w, guest.filter",
        "= (1.0 - 1e-6) * accelerated(w, guest.filter",
        (GUESTS,),
    ),
    Mutation(
        "damping along the wire of an older velocity",
        "dynamics/explicit/stretch.rs",
        "*s = x + lag * d;",
        "*s = x + 1.001 * lag * d;",
        (CLOSES,),
    ),
    Mutation(
        "damping across the wire a thousandth too much",
        "dynamics/explicit/kernels.rs",
        "-alpha[l] * d[l]",
        "-1.001 * alpha[l] * d[l]",
        (CLOSES,),
    ),
    Mutation(
        "energy of the motion without the filter",
        "dynamics/explicit/energy/tables.rs",
        "filtered: [0, 1].map(|c| Filtered::new(&weight[c], &filter, &second)),",
        "filtered: [0, 1].map(|c| Filtered::new(&weight[c], &vec![0.0; filter.len()], &second)),",
        (CLOSES,),
    ),
]

EXPLICIT = [*YIELDING, *MOVING, *LINKED, *BOOKED]
