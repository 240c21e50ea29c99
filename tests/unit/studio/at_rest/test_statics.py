"""Answers about a line at rest: the numbers of `arcless statics`, and who gets one."""

import asyncio
import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.errors import ModelError
from arcless.model import load_line
from arcless.model.scenario.overrides import apply_to_line
from arcless.studio.answers.answers import Refused
from arcless.studio.at_rest.bench import Bench
from arcless.studio.at_rest.question import PARTS, Question, question_of
from arcless.studio.at_rest.worker import DROPPED, Desk, Worker
from arcless.studio.project.project import Project

LINES = Path(arcless.__file__).parent / "models" / "lines"
LINE = LINES / "ac-simple-55-3d.yaml"
TENSION = "contact_wire.tension"
WIRE = "format: arcless-line/1\n"


def asked(file: Path = LINE, number: int = 1, **more: Any) -> Question:
    parts = {"changes": {}, "want": frozenset({"droppers"}), "text": file.read_text("utf-8")}
    return Question(file=file, within=file.parent, number=number, **{**parts, **more})


@pytest.mark.parametrize("name", ["ac-simple-55-3d", "norway-s25", "trolley-bridles"])
def test_an_answer_has_the_numbers_of_statics(name: str) -> None:
    expected = arcless.statics(load_line(name)).to_dict()
    want = frozenset({"droppers", "supports", "elasticity", "frequencies"})
    found = Bench().answer(asked(LINES / f"{name}.yaml", want=want))
    assert found["droppers"] == expected["droppers"]
    assert found["supports"] == expected["supports"]
    curve = found["elasticity"]
    pairs = zip(curve["x_m"], curve["mm_per_N"], strict=True)
    assert [{"x_m": x, "mm_per_N": e} for x, e in pairs] == expected["elasticity"]
    assert found["nonuniformity"] == expected["elasticity_nonuniformity"]
    assert found["sag_m"] == expected["contact_wire_sag_m"]
    assert found["wave_speed_m_s"] == expected["wave_speed_m_s"]
    assert found["frequencies_Hz"] == expected["natural_frequencies_Hz"]
    assert found["middle_span"] == expected["middle_span"]


def test_changes_of_a_line_and_of_a_scenario_are_those_of_the_command_line(tmp_path: Path) -> None:
    line = load_line("ac-simple-55-3d")
    changed = Bench().answer(asked(changes={TENSION: "20 kN"}))
    assert changed["droppers"] == arcless.statics(apply_to_line(line, {TENSION: "20 kN"})).droppers
    scenario = LINES.parent / "scenarios" / "en50318-ac-simple-320.yaml"
    changes = {f"line.{TENSION}": "20 kN"}
    found = Bench().answer(asked(scenario, changes=changes))
    known = arcless.load("en50318-ac-simple-320").with_(**changes)
    assert found["droppers"] == arcless.statics(known).droppers


@pytest.mark.parametrize("name", ["ac-simple-55-3d", "norway-s35"])
def test_a_moving_slider_changes_no_number_beyond_rounding(name: str) -> None:
    """From the line before; norway-s35 needs smaller corrections than the first ones tried."""
    bench, want = Bench(), frozenset({"droppers", "supports", "elasticity"})
    line = load_line(name)
    for share in (1.0, 1.01, 0.97):
        changes = {TENSION: f"{share * line.contact_wire.tension} N"}
        question = asked(LINES / f"{name}.yaml", changes=changes, want=want, moving=True)
        moving = bench.answer(question)
        rested = bench.answer(replace(question, moving=False))
        expected = arcless.statics(apply_to_line(line, changes))
        assert rested["droppers"] == expected.droppers
        assert rested["supports"] == expected.supports
        # Both are balanced to 5e-5 N at each node; a dropper takes that of the nodes around it.
        found, known = ([one["force_N"] for one in a["droppers"]] for a in (moving, rested))
        np.testing.assert_allclose(found, known, rtol=0.0, atol=1e-3)
        # Of 0.2 to 0.5 mm/N; elasticity follows shape and tension, which are the same to 1e-8.
        found, known = (a["elasticity"]["mm_per_N"] for a in (moving, rested))
        np.testing.assert_allclose(found, known, rtol=1e-6, atol=0.0)


def test_a_line_of_other_elements_is_no_start() -> None:
    bench = Bench()
    bench.answer(asked(LINES / "norway-s25.yaml", moving=True))
    moving = bench.answer(asked(moving=True))
    assert moving["droppers"] == Bench().answer(asked())["droppers"]


def test_a_bench_that_was_asked_before_answers_as_a_new_one() -> None:
    """Nothing that is kept from question to question changes a number."""
    bench = Bench()
    want = frozenset({"droppers", "elasticity"})
    for tension in ("20 kN", "25 kN", "20 kN"):
        question = asked(changes={TENSION: tension}, want=want)
        assert bench.answer(question) == Bench().answer(question)
    text = LINE.read_text("utf-8").replace("value: 22 kN", "value: 21 kN")
    assert bench.answer(asked(text=text)) == Bench().answer(asked(changes={TENSION: "21 kN"}))
    with pytest.raises(ModelError):
        bench.answer(asked(changes={TENSION: "-1 kN"}))
    assert bench.answer(asked()) == Bench().answer(asked())


def test_the_schedule_is_the_file_of_statics(tmp_path: Path) -> None:
    line = load_line("ac-simple-55-3d")
    arcless.statics(line).write_droppers(tmp_path / "droppers.csv", "30 mm")
    found = Bench().answer(asked(want=frozenset({"schedule"}), allowance="30 mm"))
    assert found["schedule"] == (tmp_path / "droppers.csv").read_text("utf-8")


def test_only_what_is_wanted_is_computed_and_sent() -> None:
    found = Bench().answer(asked(want=frozenset()))
    assert not {"line", "droppers", "supports", "elasticity", "schedule"} & found.keys()
    assert found["frequencies_Hz"] is None


@pytest.mark.parametrize("name", ["lines/norway-s25", "scenarios/en50318-ac-simple-320"])
def test_a_draft_says_so_and_is_near_the_line(name: str) -> None:
    bench, file = Bench(), LINES.parent / f"{name}.yaml"
    draft, line = bench.answer(asked(file, draft=True)), bench.answer(asked(file))
    assert (draft["draft"], line["draft"]) == (True, False)
    assert draft["droppers"] != line["droppers"]
    for one, other in zip(draft["droppers"], line["droppers"], strict=True):
        # A drawing of 500 pixels a metre shows 2 mm; what is stated in `bench` is less by far.
        assert one["length_m"] == pytest.approx(other["length_m"], abs=1e-4)
        assert one["force_N"] == pytest.approx(other["force_N"], abs=0.5)


def test_a_line_as_built_has_no_draft() -> None:
    scenario = LINES.parent / "scenarios" / "en50318-ac-simple-320.yaml"
    changes = {"as_built.temperature_difference": "10 K"}
    assert not Bench().answer(asked(scenario, changes=changes, draft=True))["draft"]


def test_a_pantograph_has_no_line_at_rest() -> None:
    with pytest.raises(ModelError, match="no line at rest"):
        Bench().answer(asked(LINES.parent / "pantographs" / "dsa-380.yaml"))


@pytest.mark.parametrize(
    "wrong",
    [
        {"path": 1},
        {"text": 1},
        {"changes": []},
        {"changes": {str(n): 1 for n in range(2000)}},
        {"want": "line"},
        {"want": ["all"]},
        {"want": [["line"]]},
        {"question": True},
        {"question": None},
    ],
)
def test_a_question_that_is_none_is_refused(tmp_path: Path, wrong: dict[str, Any]) -> None:
    path = "shipped:line/ac-simple-55"
    right: dict[str, Any] = {"path": path, "text": None, "changes": {}, "want": [], "question": 1}
    project = Project.of(tmp_path)
    assert question_of(project, right).text.startswith(WIRE)
    with pytest.raises(Refused):
        question_of(project, right | wrong)


def test_the_parts_of_a_question_are_those_of_the_page() -> None:
    assert {"line", "elasticity", "droppers", "frequencies", "supports", "schedule"} == PARTS


async def _answers(questions: list[Question]) -> list[Any]:
    worker = Worker()
    try:
        return await asyncio.gather(*map(worker.ask, questions), return_exceptions=True)
    finally:
        worker.close()


def test_of_questions_that_wait_the_newest_is_answered() -> None:
    first, *dropped, last = asyncio.run(_answers([asked(number=n) for n in range(4)]))
    # The first one runs when the others come.
    assert [json.loads(one)["question"] for one in (first, last)] == [0, 3]
    assert dropped == [DROPPED, DROPPED]


def test_what_follows_a_slider_does_not_wait_for_natural_frequencies() -> None:
    order: list[int] = []

    async def ask(desk: Desk, number: int, *want: str) -> None:
        await desk.ask(asked(number=number, want=frozenset(want)))
        order.append(number)

    async def all_of_them() -> None:
        desk = Desk()
        try:
            # Both processes start and have read the line before it counts who is first.
            await asyncio.gather(ask(desk, -1, "frequencies"), ask(desk, -1))
            order.clear()
            slow = asyncio.create_task(ask(desk, 0, "frequencies"))
            await asyncio.sleep(0)
            await ask(desk, 1, "droppers")
            await ask(desk, 2, "droppers")
            await slow
        finally:
            desk.close()

    asyncio.run(all_of_them())
    assert order[:1] == [1]


def test_a_wrong_model_and_a_process_that_broke_down_are_told_and_the_next_one_is_answered() -> (
    None
):
    async def ask() -> tuple[Any, Any, Any]:
        worker = Worker()
        try:
            wrong = await worker.ask(asked(text="format: arcless-line/1\nspans: 3\n"))
            assert worker.process is not None
            worker.process.process.kill()
            broken = await asyncio.gather(worker.ask(asked()), return_exceptions=True)
            return wrong, broken[0], await worker.ask(asked())
        finally:
            worker.close()

    wrong, broken, last = asyncio.run(ask())
    assert json.loads(wrong)["errors"][0]["text"]
    assert isinstance(broken, Refused)
    assert json.loads(last)["droppers"]
