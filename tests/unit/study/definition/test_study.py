"""Study files: what is read from them, and what each mistake is told as."""

import re
from pathlib import Path
from typing import Any

import pytest

from arcless.errors import ModelError
from arcless.model.settings.schemes import EXPLICIT
from arcless.study import load
from arcless.study.definition.study import Study
from arcless.study.evaluation.variants import in_order, scenario, variant
from tests.support.studies import QUICK, SHORT, data, study

FILE = f"""\
format: arcless-study/1
name: small
scenario: {SHORT}
set:
  solver.time_step: 4 ms
variables:
  tension: {{field: line.contact_wire.tension, range: [18 kN, 26 kN], count: 5}}
  force:
    field: pantographs.0.static_force
    distribution:
      kind: normal
      mean: {{value: 90 N, mark: assumed, note: a guess}}
      standard_deviation: 5 N
design: {{kind: sobol, count: 8}}
outputs:
  - std_force_N
  - P1.max_force_N
"""


def changed(tmp_path: Path, old: str, new: str) -> Path:
    assert old in FILE
    file = tmp_path / "study.yaml"
    file.write_text(FILE.replace(old, new, 1))
    return file


def test_a_file_is_read(tmp_path: Path) -> None:
    found = load(changed(tmp_path, "", ""))
    assert isinstance(found, Study)
    assert found.base.solver.time_step == 0.004
    assert [(axis.name, axis.unit) for axis in found.axes] == [("tension", "N"), ("force", "N")]
    assert found.axes[0].levels == (18e3, 20e3, 22e3, 24e3, 26e3)
    assert found.plan.count == 8
    assert list(found.expressions) == ["std_force_N", "P1.max_force_N"]
    assert found.provenance["variables.force.distribution.mean"].mark == "assumed"


@pytest.mark.parametrize(
    ("old", "new", "line", "message"),
    [
        ("arcless-study/1", "arcless-study/2", 1, 'wrong format: got "arcless-study/2"'),
        ("name: small", "nam: small", 2, 'unknown field: got "nam".*did you mean name?'),
        ("solver.time_step", "solver.timestep", 5, "unknown field.*did you mean time_step?"),
        ("4 ms", "4 kN", 5, "solver.time_step: got .*expected a time"),
        ("contact_wire.tension", "contact_wire.tensoin", 7, "did you mean tension?"),
        ("static_force", "1.static_force", 9, "variables.force.field: .*unknown field: got .1."),
        ("[18 kN, 26 kN]", "[26 kN, 18 kN]", 7, 'empty range: got ."26 kN", "18 kN".'),
        ("[18 kN, 26 kN]", "[18 kN, 18 kN]", 7, "empty range"),
        ("18 kN", "18 kg", 7, 'range.0: got "18 kg", expected a force.*unit of a mass'),
        ("count: 5", "count: 1", 7, "count: got 1, expected greater than or equal to 2"),
        (", count: 5", ", values: [1]", 7, "both values and range given"),
        ("range: [18 kN, 26 kN], count: 5", "description: none", 7, "no values given"),
        ("kind: normal", "kind: norml", 11, 'kind: got "norml".*did you mean normal?'),
        ("5 N\n", "-5 N\n", 13, 'not positive: got "-5 N"'),
        ("kind: sobol", "kind: soble", 14, "did you mean sobol?"),
        ("count: 8", "count: 0", 14, "count: got 0"),
        ("count: 8", "count: 1000000000", 14, "got 1 000 000 000 variants, expected at most"),
        ("kind: sobol, count: 8", "kind: grid", 8, "values cannot be counted"),
        ("std_force_N", "std_force", 15, "unknown key.*did you mean std_force_N?"),
        ("P1.max", "P2.max", 15, 'unknown key: got "P2.max_force_N"'),
        ("static_force", "static_force\n    fild: 1", 10, "unknown field.*did you mean field?"),
        (
            "pantographs.0.static_force",
            "line.contact_wire.tension",
            9,
            "two values for one field.*variable tension has it already",
        ),
        (
            "solver.time_step: 4 ms",
            "pantographs.0.static_force: 80",
            9,
            "two values for one field.*set has it, too",
        ),
        ("  tension:", "  status:", 7, "name of a column.*every table has"),
        ("  tension:", "  two words:", 7, "name of a column.*a letter first"),
        ("  tension:", "  mean_force_N:", 7, "name of a column.*a key of the assessment"),
        ("  - std_force_N", "  - tension", 15, "name of a column.*a variable"),
        (str(SHORT), "en50318-ac-simple", 3, "unknown scenario.*did you mean en50318-ac-simple-"),
        ("line.contact_wire.tension, range", "line, range", 7, "a number without unit"),
        (
            "line.contact_wire.tension, range: [18 kN, 26 kN], count: 5",
            "line, values: [none.yaml]",
            7,
            "no such file",
        ),
    ],
)  # fmt: skip
def test_mistakes(tmp_path: Path, old: str, new: str, line: int, message: str) -> None:
    file = changed(tmp_path, old, new)
    with pytest.raises(ModelError) as caught:
        load(file)
    said = str(caught.value)
    assert f"{file}:{line}" in said.partition(": ")[0], said
    assert re.search(message.replace("?", r"\?"), said), said


@pytest.mark.parametrize(
    ("executor", "message"),
    [
        ({"kind": "dusk"}, "did you mean dask"),
        ({"kind": "threads", "workers": 0}, "workers"),
        ({"kind": "threads", "scheduler": "tcp://x:1"}, "scheduler without Dask"),
        ({"kind": "dask", "scheduler": "x:1"}, "scheduler"),
        ({"kind": "dask", "scheduler": "tcp://x:1", "workers": 2}, "both scheduler and workers"),
    ],
)
def test_mistakes_of_executors(executor: dict[str, Any], message: str) -> None:
    with pytest.raises(ModelError, match=message):
        study(executor=executor)


def test_a_line_is_named_relative_to_the_file(tmp_path: Path) -> None:
    scenario = load(data()).scenario
    text = scenario.line.model_dump_json(by_alias=True)
    (tmp_path / "other.yaml").write_text(text.replace('"short-line"', '"other-line"', 1))
    inner = "values: [other.yaml, ac-simple-55]"
    file = changed(tmp_path, "range: [18 kN, 26 kN], count: 5", inner)
    file.write_text(file.read_text().replace("line.contact_wire.tension", "line"))
    found = load(file)
    changes = {variant(found, number).values["tension"]: number for number in range(1, 9)}
    assert set(changes) == {"other.yaml", "ac-simple-55"}
    made = variant(found, changes["other.yaml"]).changes["line"]
    assert made["name"] == "other-line"


def test_elements_are_swept_from_what_the_scheme_needs() -> None:
    element = {"field": "solver.contact_wire_element", "values": ["auto", "0.6 m"]}
    made = study(variables={"element": element}, set={**QUICK, "solver.scheme": EXPLICIT})
    assert made.base.solver.contact_wire_element == "auto"
    (axis,) = made.axes
    assert (axis.levels, axis.unit) == (("auto", 0.6), "m")
    steps = [scenario(made, n).stepping for n in (1, 2)]
    assert [one.contact_wire_element_m for one in steps] == [steps[0].contact_wire_element_m, 0.6]
    assert steps[0].contact_wire_element_m <= 0.45
    ranged = {"field": "solver.contact_wire_element", "range": ["0.3 m", "60 cm"], "count": 2}
    (axis,) = study(variables={"element": ranged}).axes
    assert (axis.levels, axis.unit) == ((0.3, 0.6), "m")


def test_one_field_by_two_paths_is_refused() -> None:
    mass = {"field": "pantographs.0.masses.0.mass", "values": [15]}
    same = {"field": "pantographs.0.model.masses.0.mass", "values": [16]}
    with pytest.raises(ModelError, match=r"two values for one field.*variable a has it already"):
        study(variables={"a": mass, "b": same})


def test_a_field_inside_of_a_varied_group_keeps_its_value() -> None:
    made = study(
        set={"line.contact_wire.tension": "23 kN"},
        variables={
            "messenger": {"field": "line.messenger_wire.tension", "values": ["15 kN"]},
            "line": {"field": "line", "values": ["ac-simple-55", "ac-simple-55-3d"]},
        },
    )
    one = made.base.with_(**variant(made, 2).changes).line
    assert one.name == "ac-simple-55-3d"
    assert (one.contact_wire.tension, one.messenger_wire.tension) == (23e3, 15e3)


def test_variants_that_share_a_line_stand_together() -> None:
    found = study()
    tensions = [variant(found, n).values["tension"] for n in in_order(found, range(1, 7))]
    assert tensions == sorted(tensions)
    by_force = study(
        variables={
            "force": {"field": "pantographs.0.static_force", "values": [70, 80]},
            "tension": {"field": "line.contact_wire.tension", "values": [18e3, 20e3]},
        }
    )
    assert in_order(by_force, range(1, 5)) == [1, 3, 2, 4]
    assert in_order(by_force, [4, 3]) == [3, 4]


def test_identity_is_that_of_the_changes() -> None:
    one, again = variant(study(), 2), variant(study(name="other"), 2)
    assert one.key == again.key
    assert one.key != variant(study(), 3).key
    assert one.changes == {"line.contact_wire.tension": 18e3, "pantographs.0.static_force": 90.0}
