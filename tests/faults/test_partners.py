"""Every verification file has a partner that shows what its checks notice, and the other way."""

import ast
from pathlib import Path

import pytest

from arcless.validate.evidence import GROUPS
from tests.support import records

TESTS = Path(__file__).parents[1]


def topics(folder: str) -> set[str]:
    files = (file for group in GROUPS for file in (TESTS / folder / group).glob("test_*.py"))
    return {f"{file.parent.name}/{file.name}" for file in files}


def test_every_topic_has_its_faults() -> None:
    assert topics("verification") == topics("faults")
    assert len(topics("faults")) > 20


@pytest.mark.parametrize("topic", sorted(topics("faults")))
def test_a_partner_breaks_the_checks_of_its_own_topic(topic: str) -> None:
    group, name = topic.removesuffix(".py").split("/")
    tree = ast.parse((TESTS / "faults" / topic).read_text(encoding="utf-8"))
    imported = {
        f"{node.module}.{alias.name}"
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }
    own = f"tests.verification.{group}.{name}"
    assert any(found == own or found.startswith(f"{own}.") for found in imported)
    calls = [ast.unparse(n.func) for n in ast.walk(tree) if isinstance(n, ast.Call)]
    assert any(call.startswith("noticed") or call == "notice" for call in calls)


@pytest.mark.parametrize("topic", sorted(topics("verification")))
def test_every_topic_and_its_faults_are_recorded(topic: str) -> None:
    group, name = topic.removesuffix(".py").split("/")
    record = records.load(group, name.removeprefix("test_"))
    assert record.rows, "nothing recorded: run the file with --publish"
    assert record.faults, "no fault recorded: run its partner with --publish"
    assert record.title and record.text


def test_no_record_is_without_its_test() -> None:
    known = {topic.replace("test_", "").removesuffix(".py") for topic in topics("verification")}
    files = {
        f"{file.parent.name}/{file.stem}"
        for group in GROUPS
        for file in (records.RECORDS / group).glob("*.json")
    }
    assert files <= known
