"""Values of a step taken at another instant than that of the balance, and what goes with it."""

from tests.support.mutants import Mutation

RESPONSE = "closed_forms/test_pantograph_response.py::test_response"
IMPACT = "closed_forms/test_compliant_impact.py::test_a_bounce"
TIME_STEP = "orders/test_time_step.py::test_order"

IN_TIME = [
    Mutation("contact where it is at the end of the step", "Run::step",
             "let position = A;", "let position = self.travel.positions[step + 1];",
             ("orders/test_time_step_of_a_run.py::test_order",)),
    Mutation("given forces of pantographs at the end of the step", "Drive::begin",
             "(1.0 - A) * B[step + 1] + A * B[step]", "B[step + 1] + 0.0 * A",
             (TIME_STEP, RESPONSE)),
    Mutation("loads of the line at the end of the step", "Loads::begin",
             "(1.0 - A) * B[step + 1] + A * B[step]", "B[step + 1] + 0.0 * A", (TIME_STEP,)),
    Mutation("masses recorded at the end of the step", "record_contacts",
             "A + B * C - D", "A + 0.0 * B * C + C - D", (TIME_STEP, RESPONSE)),
    Mutation("compliance of the contact without the weight of the balance", "assemble",
             "1.0 / (A * B)", "1.0 / A", (IMPACT, RESPONSE)),
    Mutation("rate of the moving roof dropped", "Drive::begin",
             "between(&A.rate)", "0.0 * between(&A.rate)", (RESPONSE,)),
    Mutation("forces of the present position 1 % low with updated kinematics",
             "Prepared::free_increment",
             "-= A[B];", "-= 0.99 * A[B];", ("orders/test_time_step_updated.py::test_order",)),
    Mutation("bend with the length of the piece before it", "BendElement::new",
             "rigidity: A * mean", "rigidity: A * before",
             ("orders/test_element_length_point_masses.py::test_frequencies",)),
]  # fmt: skip
