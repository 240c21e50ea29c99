"""The other family of elements: the same run with none of its errors of discretisation.

Two families share no such error. Explicit steps have chains of point masses: waves keep their speed
by a corrected mass, points yield as those of a fitted chain. Cubic elements with residual
flexibility and a step that is solved for have another dispersion, other corners under forces and
another error of the period. What both agree on is not of either; halving the elements of one family
alone would keep what its members have in common.
"""

from math import ceil

from arcless.model.scenario.scenario import Scenario
from arcless.model.settings.run_settings import Solver
from arcless.model.settings.schemes import EXPLICIT, CentralDifference, GeneralisedAlpha

# Cubic elements, m, and step, s, that are within 1.3 % on trailing pantographs, which are the
# hardest, with twice the step.
CUBIC, CUBIC_STEP = 0.725, 0.5e-3
# Chains: half of what goes with 1 ms, at half of that step, so the bound of stability is the same.
CHAIN_CONTACT, CHAIN_MESSENGER, CHAIN_STEP = 0.225, 0.3, 0.5e-3
# A chain of 0.45 m serves as well as cubic elements of 0.725 m.
CUBIC_PER_CHAIN = CUBIC / (2 * CHAIN_CONTACT)
# Least values that the model files allow, m and s.
LEAST_ELEMENT, LEAST_STEP = 0.05, 1e-5
# The scheme must not ring where the contact is rigid, see `advice`.
QUIET_RADIUS = 0.0


def other_family(scenario: Scenario, *, chains: bool = True) -> Scenario:
    """Return the scenario with the other family of elements, refined; the physics is the same.

    Parameters
    ----------
    scenario
        What is to be compared.
    chains
        False where the line refuses explicit steps: then cubic elements are refined, and what they
        have in common with coarser ones is not seen.

    Returns
    -------
    Scenario
        With elements and a step as above or, where those given are as fine, with what is twice as
        fine as they are. Contacts are recorded at the same rate.
    """
    solver = scenario.stepping
    updated = solver.kinematics == "updated"
    to_chains = chains and not steps_on_chains(solver) and may_be_chains(scenario)
    parts = _parts_of_a_step(scenario.time_step_s, CHAIN_STEP if to_chains else CUBIC_STEP)
    contact, messenger = _lengths(solver, to_chains=to_chains)
    # Central differences damp nothing: a rigid contact would ring with them.
    explicit = to_chains and not updated and scenario.contact.law != "rigid"
    # Explicit steps always have it, chains that are solved for never.
    flexible = explicit or (not (to_chains or updated) and may_be_chains(scenario))
    made = Solver(
        scheme=CentralDifference(name=EXPLICIT) if explicit else _quiet(scenario),
        time_step=scenario.time_step_s / parts,
        wire_model="lumped" if to_chains else "hermite",
        kinematics=solver.kinematics,
        residual_flexibility=flexible,
        motion=solver.motion,
        dimension=solver.dimension,
        contact_wire_element=contact,
        messenger_wire_element=messenger,
        gravity=solver.gravity,
    )
    every = {"contact_every": parts * scenario.output.contact_every}
    output = scenario.output.model_copy(update={**every, "energy": "never"})
    return scenario.model_copy(update={"solver": made, "output": output})


def steps_on_chains(solver: Solver) -> bool:
    """Return whether wires are chains of point masses, also where other settings imply it."""
    return solver.wires == "lumped"


def may_be_chains(scenario: Scenario) -> bool:
    """Return whether wires may be chains, with a kink to round: not for a rail without tension."""
    return scenario.line.wave_speed is not None


def _parts_of_a_step(step_s: float, longest_s: float) -> int:
    """Return in how many a step is divided: whole, so that controllers and records keep time."""
    # A trifle is taken off so that a step of whole parts is not one too many by rounding.
    wanted = max(2, ceil(step_s / longest_s - 1e-9))
    return max(1, min(wanted, int(step_s / LEAST_STEP + 1e-9)))


def _lengths(solver: Solver, *, to_chains: bool) -> tuple[float, float]:
    """Return the longest elements of contact and messenger wire in m."""
    own = (solver.contact_wire_element_m, solver.messenger_wire_element_m)
    if to_chains:
        bounds, share = (CHAIN_CONTACT, CHAIN_MESSENGER), 0.5 / CUBIC_PER_CHAIN
    elif steps_on_chains(solver):
        bounds, share = (CUBIC, CUBIC), CUBIC_PER_CHAIN
    else:
        bounds, share = (CUBIC, CUBIC), 0.5
    contact, messenger = (
        max(LEAST_ELEMENT, min(bound, share * length))
        for bound, length in zip(bounds, own, strict=True)
    )
    return contact, messenger


def _quiet(scenario: Scenario) -> GeneralisedAlpha:
    """Return a scheme that is solved for, and that no rigid contact makes ring."""
    if scenario.contact.law == "rigid":
        return GeneralisedAlpha(name="generalised-alpha", spectral_radius=QUIET_RADIUS)
    return GeneralisedAlpha(name="generalised-alpha")
