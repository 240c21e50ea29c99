"""A line at rest without a scenario: the numbers are those of a scenario with the line."""

from pathlib import Path

import numpy as np
import pytest

import arcless
from arcless.errors import ModelError
from arcless.model.shipped.library import shipped
from arcless.report import statics_page

# Each line with a scenario of it: lines of droppers, in space, on stitch wires, rails, bridles.
PAIRS = {
    "ac-simple-55": "en50318-ac-simple-320-planar",
    "norway-s25": "norway-s25-250",
    "spain-ca-160-3kv": "spain-ca-160-3kv-160",
    "ac-simple-overlap": "ac-simple-overlap-275",
}
# One of each kind; every line of `PAIRS` rests by itself there. The rest is for `make evidence`.
KINDS = {
    "conductor-rail-3", "germany-re-200", "shinkansen-heavy-compound", "siemens-sicat-sx",
    "spain-ca-220-25kv", "trolley-bridles",
}  # fmt: skip


@pytest.mark.parametrize(("line", "scenario"), PAIRS.items())
def test_forces_and_lengths_are_those_of_a_scenario(line: str, scenario: str) -> None:
    found, other = arcless.statics(arcless.load_line(line)), arcless.statics(arcless.load(scenario))
    assert other.scenario.line == found.scenario.line
    for one, another in zip(found.droppers, other.droppers, strict=True):
        assert (one["name"], one["x_m"]) == (another["name"], another["x_m"])
        # Two families of elements: forces differ by 0.3 % at most, as `ALONE` says.
        assert one["force_N"] == pytest.approx(another["force_N"], rel=3e-3)
        # That of the droppers' strain and of the sag between them, below a millimetre.
        assert one["length_m"] == pytest.approx(another["length_m"], abs=1e-3)
    elasticity = (np.array(each.elasticity_m_per_N) for each in (found, other))
    # Chains of points wind around the smooth curve, most between a support and the first dropper.
    np.testing.assert_allclose(*elasticity, rtol=0.02)
    lowest = (each.natural_frequencies_Hz[0] for each in (found, other))
    assert next(lowest) == pytest.approx(next(lowest), rel=1e-3)


@pytest.mark.parametrize(
    "name",
    [name if name in KINDS else pytest.param(name, marks=pytest.mark.evidence)
     for name in shipped("line")],
)  # fmt: skip
def test_every_shipped_line_rests_by_itself(name: str, tmp_path: Path) -> None:
    found = arcless.statics(arcless.load_line(name))
    told = found.to_dict()
    assert (told["scenario"], told["line"]) == (None, name)
    assert told["resonance_speeds"]["speeds"] == []
    assert "without pantographs" in told["resonance_speeds"]["notes"][0]
    assert told["as_built"] is None
    found.write_supports(tmp_path / "supports.csv")
    statics_page.write(found, tmp_path / "page.html", resonance=told["resonance_speeds"])
    assert ">Scenario<" not in (tmp_path / "page.html").read_text("utf-8")


def test_two_wires_yield_nothing_at_their_anchors() -> None:
    found = arcless.statics(arcless.load_line("spain-ca-160-3kv")).equilibrium
    end = found.support_places()[-1]
    elasticity = found.elasticity(np.array([0.0, 0.5, end - 0.5, end]))
    assert elasticity[0] == elasticity[-1] == 0.0
    assert np.all(elasticity[1:3] > 0.0)


def test_what_is_no_model_is_told_as_before() -> None:
    with pytest.raises(ModelError, match="not a scenario"):
        arcless.statics("norway-s25")  # type: ignore[arg-type]
