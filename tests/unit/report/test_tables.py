"""Numbers as text, and the model's data with their sources."""

import pytest

from arcless.assess import assess
from arcless.assess.quantities import OF_PANTOGRAPH, WEAR
from arcless.figures.run.run_data import RunData
from arcless.model import Scenario, load
from arcless.report.model_data import MAX_ROWS, Row, groups, marks_used
from arcless.report.tables import (
    computation,
    criterion_rows,
    indicator_rows,
    line_rows,
    number_rows,
    reference_cells,
)
from tests.support.synthetic import SPAN_M, scenario_data, synthetic_dataset


def test_a_word_in_place_of_a_number_gets_no_unit() -> None:
    found = {row.path: row for group in groups(load("praks-340")) for row in group.rows}
    assert found["solver.time_step"].source == "K"
    assert found["solver.contact_wire_element"].value == "0.25 m"
    assert found["solver.wire_model"].value == "lumped"
    assert found["output.around"].value == "auto"
    assert found["steady_arm.kind"].value == "none"


@pytest.mark.parametrize(
    ("scheme", "shown"),
    [
        ("trapezoidal", ("auto (hermite)", "auto (0.5 m)", "auto (0.5 m)")),
        ("central-difference", ("auto (lumped)", "auto (0.3 m)", "auto (0.35 m)")),
    ],
)
def test_what_a_run_takes_for_a_word_stands_beside_it(scheme: str, shown: tuple[str, ...]) -> None:
    scenario = load("en50318-ac-simple-320-planar").with_(**{"solver.scheme": scheme})
    found = {row.path: row.value for group in groups(scenario) for row in group.rows}
    names = ("wire_model", "contact_wire_element", "messenger_wire_element")
    assert tuple(found[f"solver.{name}"] for name in names) == shown
    by_element = {row.path: row.value for group in groups(load("praks-340")) for row in group.rows}
    assert by_element["solver.time_step"] == "one element (0.0026470588 s)"


def test_every_indicator_has_a_row_and_every_pantograph_a_column() -> None:
    two = assess(synthetic_dataset(pantographs=("P1", "P2")))
    rows = indicator_rows(two)
    assert len(rows) == len(OF_PANTOGRAPH)
    numbers = set(vars(two.pantographs[0])) - {"name", "certainty"}
    assert numbers == set(OF_PANTOGRAPH) | set(WEAR)
    assert all(len(values) == 2 for _, _, values in rows)


def test_numbers_stand_in_two_parts_of_which_the_first_has_the_forces() -> None:
    dataset = synthetic_dataset(pantographs=("P1", "P2"))
    run = RunData(dataset, assess(dataset))
    forces, others = number_rows(run)
    assert {unit for _, unit, _ in forces} == {"N"}
    shown = [label for label, _, _ in (*forces, *others)]
    every = [row[0] for row in (*indicator_rows(run.assessment), *line_rows(run))]
    assert sorted(shown) == sorted(every)
    assert all(len(values) == 2 for _, _, values in forces)
    assert len(others[-1][2]) == 1  # of the line, not of a pantograph


def test_criteria_say_title_and_source_once() -> None:
    rows = criterion_rows(assess(synthetic_dataset(pantographs=("P1", "P2"))))
    first, second = rows[:2]
    assert (first["title"] != "", second["title"]) == (True, "")
    assert [first["pantograph"], second["pantograph"]] == ["P1", "P2"]


def test_reference_cells_are_text() -> None:
    [row] = reference_cells([{"quantity": "σ", "value": 31.94444, "low": None, "high": -2.0}])
    assert (row["value"], row["low"], row["high"], row["mark"]) == ("31.94", "–", "−2", "–")


def test_model_data_carry_unit_mark_source_and_note() -> None:
    line, pantograph, scenario = groups(load(scenario_data()))
    rows = {row.path: row for row in line.rows}
    tension = rows["contact_wire.tension"]
    assert (tension.value, tension.si) == ("10 kN", "10\u202f000 N")
    assert (tension.mark, tension.source, tension.note) == ("A", "S1", "drawn")
    assert rows["contact_wire.mass"].mark == ""
    assert rows["span_types.all.length"].value == f"{SPAN_M:g} m"
    assert rows["span_types.all.droppers.positions"].value == "5, 45 m"
    assert line.sources == {"S1": "a drawing"}
    assert [row.value for row in pantograph.rows if row.path == "masses.0.mass"] == ["8 kg"]
    assert not any("contact_wire." in row.path for row in scenario.rows)
    assert marks_used([line, pantograph, scenario]) == {"A"}


def test_equal_pantographs_are_listed_once() -> None:
    data = scenario_data()
    data["pantographs"] += [{**data["pantographs"][0], "name": "P2", "distance": 100.0}]
    titles = [group.title for group in groups(load(data))]
    assert titles == ["Line drawn line", "Pantograph drawn", "Scenario synthetic"]


def test_a_line_with_hundreds_of_span_types_is_cut_and_says_so() -> None:
    data = scenario_data()
    span = data["line"]["span_types"]["all"]
    data["line"]["span_types"] = {f"t{i}": span for i in range(MAX_ROWS)}
    data["line"]["spans"] = [{"type": "t0", "count": 12}]
    line = groups(load(data))[0]
    assert len(line.rows) == MAX_ROWS
    assert line.left_out > 0


def test_values_are_those_of_the_run_even_after_a_change() -> None:
    changed = load(scenario_data()).with_(**{"line.contact_wire.tension": "12 kN"})
    rows = {row.path: row for row in groups(changed)[0].rows}
    assert rows["contact_wire.tension"].value == "12 kN"


def test_a_value_inherits_the_source_of_the_mapping_it_was_given_in() -> None:
    damping = {"value": {"alpha": 0.01, "beta": "0.1 ms"}, "mark": "C", "note": "remembered"}
    data = scenario_data(line__contact_wire__damping=damping)
    rows = {row.path: row for row in groups(load(data))[0].rows}
    assert rows["contact_wire.damping.beta"].value == "0.0001 s"
    assert rows["contact_wire.damping.beta"].mark == "C"
    assert rows["messenger_wire.damping.beta"].mark == ""


def test_an_empty_list_is_none() -> None:
    rows = {row.path: row for row in groups(load(scenario_data()))[-1].rows}
    assert rows["output.points"].value == "none"


def test_defaults_stand_apart_from_values_that_were_given() -> None:
    line = groups(load("en50318-ac-simple-320"))[0]
    given, defaults = ({row.path for row in rows} for rows in (line.given, line.defaults))
    assert "contact_wire.tension" in given
    assert "design.uplift_limited" in defaults
    assert given.isdisjoint(defaults)
    assert len(line.given) + len(line.defaults) == len(line.rows)


def _forces_of(scenario: Scenario, forces: dict[str, float] | None) -> dict[str, Row]:
    found = [row for group in groups(scenario, forces) for row in group.rows]
    return {row.path: row for row in found if row.path.endswith("static_force")}


def test_the_static_force_of_the_run_is_listed_with_its_origin() -> None:
    own = load("norway-s25-250")
    rows = _forces_of(own, {"P1": 73.25})
    found = rows["pantographs.0.static_force"]
    assert (found.value, found.mark) == ("73.25 N", "D")
    assert found.note == "Of this run: found for a mean contact force of 130.6 N."
    # The pantograph's own, 120 N, was not used.
    assert rows["static_force"].value == "120 N"
    assert rows["static_force"].note.startswith(
        "Not used in this run: the scenario sets the force."
    )


def test_a_static_force_that_is_used_has_no_remark() -> None:
    data = scenario_data()
    data["pantographs"][0].pop("static_force")
    data["pantographs"][0]["model"]["static_force"] = 60.0
    rows = _forces_of(load(data), {"P1": 60.0})
    assert list(rows) == ["static_force"]
    assert rows["static_force"].note == ""
    # A statement without a run, of a line at rest, says nothing about forces.
    assert "pantographs.0.static_force" not in _forces_of(load("norway-s25-250"), None)


def test_the_computation_says_why_it_has_a_matrix() -> None:
    dataset = synthetic_dataset()
    run = RunData(dataset, assess(dataset))
    facts = {"simulated_time_s": 1.0, "scheme": "generalised-alpha"}
    why = "solver.time_step of 2 ms is too long for explicit steps"
    told = dict(computation(run, {**facts, "why_matrix": why}))
    assert told["scheme"] == f"generalised-alpha; a matrix because {why}"
    assert dict(computation(run, {**facts, "why_matrix": ""}))["scheme"] == "generalised-alpha"
