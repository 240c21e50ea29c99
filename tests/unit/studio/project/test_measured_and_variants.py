"""Measured runs that are dropped onto the page, and variants of a scenario."""

import asyncio
from collections.abc import AsyncIterator

import pytest

import arcless
from arcless.errors import ArclessError, OutputError
from arcless.studio.answers.answers import Refused
from arcless.studio.project import measured, variants
from arcless.studio.project.project import Project


async def pieces(*given: bytes, fails: bool = False) -> AsyncIterator[bytes]:
    for piece in given:
        yield piece
    if fails:
        raise Refused(413, "too long")


def keep(project: Project, name: str, content: AsyncIterator[bytes]) -> str:
    return asyncio.run(measured.keep(project, name, content))


def test_kept_as_it_comes_beside_what_is_there(project: Project) -> None:
    assert keep(project, "run 1.csv", pieces(b"a,", b"b\n")) == "measured/run 1.csv"
    assert keep(project, "run 1.csv", pieces(b"c")) == "measured/run 1 (2).csv"
    assert keep(project, "run 1.csv", pieces(b"d")) == "measured/run 1 (3).csv"
    assert (project.folder / "measured" / "run 1.csv").read_bytes() == b"a,b\n"


def test_one_that_breaks_off_leaves_nothing(project: Project) -> None:
    with pytest.raises(Refused):
        keep(project, "a.csv", pieces(b"x" * 1000, fails=True))
    assert list((project.folder / "measured").iterdir()) == []


@pytest.mark.parametrize(
    "name",
    ["", "a", "a.py", ".a.csv", "../a.csv", "a/b.csv", "a\0.csv", "a\n.csv", "x" * 200 + ".csv",
     "a.csv.exe", "\u202egnp.csv", ".csv"],
    ids=ascii,
)  # fmt: skip
def test_names(project: Project, name: str) -> None:
    with pytest.raises(OutputError):
        keep(project, name, pieces(b"x"))


def test_a_folder_that_leads_out(project: Project) -> None:
    (project.folder / "measured").symlink_to(project.folder.parent / "outside")
    with pytest.raises(OutputError):
        keep(project, "a.csv", pieces(b"x"))
    assert not (project.folder.parent / "outside" / "a.csv").exists()


def test_a_variant_holds_only_the_difference(project: Project) -> None:
    changes = {"speed": "300 km/h", "line.contact_wire.tension": "24 kN"}
    path = variants.make(project, "my.yaml", "my-24kN", changes)
    assert path == "my-24kN.yaml"
    assert (project.folder / path).read_text() == (
        "format: arcless-scenario/1\nname: my-24kN\nbase: my.yaml\nset:\n"
        "  speed: 300 km/h\n  line.contact_wire.tension: 24 kN\n"
    )
    made = arcless.load(project.folder / path)
    assert made.line.contact_wire.tension == 24_000
    assert made.top_speed == pytest.approx(300 / 3.6)


def test_a_variant_of_a_shipped_scenario_and_of_one_in_a_folder(project: Project) -> None:
    shipped = "shipped:scenario/en50318-ac-simple-320"
    assert variants.make(project, shipped, "faster", {"speed": "330 km/h"}) == "faster.yaml"
    assert "base: en50318-ac-simple-320\n" in (project.folder / "faster.yaml").read_text()
    (project.folder / "deep").mkdir()
    for name in ("my.yaml", "my-line.yaml"):
        (project.folder / "deep" / name).write_bytes((project.folder / name).read_bytes())
    assert variants.make(project, "deep/my.yaml", "b", {}) == "deep/b.yaml"
    assert arcless.load(project.folder / "deep" / "b.yaml").name == "b"


@pytest.mark.parametrize(
    ("name", "changes"),
    [("../x", {}), ("", {}), (".x", {}), ("my", {}), ("en50318-ac-simple-320", {}), ("a/b", {}),
     ("x", {"spam": 1}), ("x", {"speed": "300 kg"}), ("x", {"line": "../outside/secret.yaml"}),
     ("x", {"line": "/etc/hostname"}), ("x", {"speed": float("nan")})],
)  # fmt: skip
def test_variants_that_are_refused(project: Project, name: str, changes: dict[str, object]) -> None:
    before = {one.name: one.read_bytes() for one in project.folder.iterdir()}
    with pytest.raises((ArclessError, Refused)) as refused:
        variants.make(project, "my.yaml", name, changes)
    assert "canary" not in str(refused.value)
    assert {one.name: one.read_bytes() for one in project.folder.iterdir()} == before


@pytest.mark.parametrize("given", [(None, "x", {}), ("my.yaml", None, {}), ("my.yaml", "x", [])])
def test_questions_that_are_none(project: Project, given: tuple[object, object, object]) -> None:
    with pytest.raises(Refused):
        variants.make(project, *given)
