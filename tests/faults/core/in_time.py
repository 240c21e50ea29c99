"""Values of a step taken at another instant than that of the balance, and what goes with it."""

from tests.support.mutants import Mutation

RESPONSE = "closed_forms/test_pantograph_response.py::test_response"
IMPACT = "closed_forms/test_compliant_impact.py::test_a_bounce"
TIME_STEP = "orders/test_time_step.py::test_order"

IN_TIME = [
    Mutation(
        "contact where it is at the end of the step",
        "dynamics/run.rs",
        "let position = between(&self.travel.positions);",
        "let position = self.travel.positions[step + 1];",
        ("orders/test_time_step_of_a_run.py::test_order",),
    ),
    Mutation(
        "given forces of pantographs at the end of the step",
        "dynamics/given.rs",
        "let between = |a: &[f64]| (1.0 - old) * a[step + 1] + old * a[step];",
        "let between = |a: &[f64]| a[step + 1] + 0.0 * old;",
        (TIME_STEP, RESPONSE),
    ),
    Mutation(
        "loads of the line at the end of the step",
        "dynamics/loads.rs",
        "*size = (1.0 - old) * load.sizes[step + 1] + old * load.sizes[step];",
        "*size = load.sizes[step + 1] + 0.0 * old;",
        (TIME_STEP,),
    ),
    Mutation(
        "masses recorded at the end of the step",
        "dynamics/watch.rs",
        "r.masses.push(u + keep * d - start);",
        "r.masses.push(u + 0.0 * keep * d + d - start);",
        (TIME_STEP, RESPONSE),
    ),
    Mutation(
        "compliance of the contact without the weight of the balance",
        "dynamics/stepper.rs",
        "contact_compliance: 1.0 / (contact_stiffness * c.stiffness),",
        "contact_compliance: 1.0 / contact_stiffness,",
        (IMPACT, RESPONSE),
    ),
    Mutation(
        "rate of the moving roof dropped",
        "dynamics/given.rs",
        "self.balance = [between(&ground.displacement), between(&ground.rate)];",
        "self.balance = [between(&ground.displacement), 0.0 * between(&ground.rate)];",
        (RESPONSE,),
    ),
    Mutation(
        "forces of the present position 1 % low with updated kinematics",
        "dynamics/stepper.rs",
        "force[c] -= residual[c];",
        "force[c] -= 0.99 * residual[c];",
        ("orders/test_time_step_updated.py::test_order",),
    ),
    Mutation(
        "influence columns that are not renewed with updated kinematics",
        "dynamics/updated.rs",
        "        self.columns.forget();\n",
        "",
        ("references/test_literal_step.py::test_every_step",),
    ),
    Mutation(
        "bend with the length of the piece before it",
        "element/chain.rs",
        "rigidity: bending_stiffness * mean,",
        "rigidity: bending_stiffness * before,",
        ("orders/test_element_length_point_masses.py::test_frequencies",),
    ),
]
