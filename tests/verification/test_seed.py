"""The check of hanger joints fails on a line whose hangers have no effect."""

from collections.abc import Callable

import pytest

from arcless.results import Result
from arcless.validate import seed
from arcless.validate.observation import observe

# A wire of next to no weight, which no hanger's force can bend, on hangers that hold next to
# nothing and joints without mass.
NO_EFFECT = {
    "line.dropper.clamp_mass_contact_wire": 0.0,
    "line.dropper.stiffness": 36.0,
    "line.contact_wire.mass": 0.05,
}


@pytest.mark.parametrize("name", ["praks-180", "praks-360"])
def test_without_the_effect_of_hangers_nothing_is_located(
    run_once: Callable[..., Result], name: str
) -> None:
    with_hangers, without = (observe(run_once(name, changes)) for changes in ({}, NO_EFFECT))
    assert with_hangers.changes.located == len(with_hangers.changes.joints) == 9
    assert without.changes.located < 7
    assert without.changes.rms_ratio < seed.FASTER
    rows = [row for row in seed.rows([without]) if row.case == seed.JOINTS]
    assert [row.verdict for row in rows] == ["outside", "outside"]
