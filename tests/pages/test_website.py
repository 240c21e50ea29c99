"""The site of the documentation: copies of pages, their contents, and the checks of built pages."""

import re
from pathlib import Path

import pytest
from reference import names
from website import checks, commands, pages, python, schemas

import arcless


def test_links_that_lead_out_of_docs_lead_to_copies(tmp_path: Path) -> None:
    staging = pages.Staging(tmp_path)
    text = "[a](../../examples/one_run.py) `[b](c.md)` [d](../index.md#e) [f](../../README.md)\n"
    assert staging.linked(text, "docs/guide/figures.md") == (
        "[a](../sources/examples/one_run.py.md) `[b](c.md)` [d](../index.md#e) [f](../index.md)\n"
    )
    assert staging.sources == {"examples/one_run.py"}


@pytest.mark.parametrize(
    "code", ["```sh\n[a](b.md)\n```\n", "x\n\n    [a](b.md)\n\n    [c](d.md)\n", "`[a](b.md)`\n"]
)
def test_code_has_no_links(code: str) -> None:
    assert pages.links(code) == []
    assert pages.links(f"{code}\n[e](f.md)\n") == ["f.md"]


def test_an_index_lists_the_pages_of_its_folder() -> None:
    text = "# T\n\n## One\n\n- [a](a.md), [b](../x/b.md), [c](c.md#d)\n\n## [D](d.md)\n"
    known = {"f/index.md", "f/a.md", "x/b.md", "f/c.md", "f/d.md"}
    assert re.findall(r"^(?::|/).*$", pages.contents(text, "f/index.md", known), re.M) == [
        ":hidden:", ":caption: One", "/f/a", "/f/c", ":hidden:", "/f/d",
    ]  # fmt: skip
    first = pages.contents("- [Guides](f/index.md)\n", "index.md", known)
    assert "Guides </f/index>" in first


def test_every_page_is_copied_and_listed(tmp_path: Path) -> None:
    made = commands.pages() | schemas.pages() | python.pages()
    pages.stage(pages.Staging(tmp_path), made)
    copies = {path.relative_to(tmp_path).as_posix() for path in tmp_path.rglob("*.md")}
    originals = {path.relative_to(pages.DOCS).as_posix() for path in pages.DOCS.rglob("*.md")}
    assert originals | set(made) <= copies
    listed = set()
    for path in tmp_path.rglob("*.md"):
        for table in re.findall(r"```\{toctree\}\n(.*?)```", path.read_text("utf-8"), re.S):
            for entry in re.findall(r"^(?!:)[^<\n]*?<?([\w/.-]+)>?$", table, re.M):
                place = tmp_path if entry.startswith("/") else path.parent
                listed.add((place / f"{entry.lstrip('/')}.md").relative_to(tmp_path).as_posix())
    own = {name for name in copies if not name.startswith("sources/")}
    assert own - listed == {"index.md"}
    (tmp_path / "gone.md").write_text("# Gone\n", "utf-8")
    pages.stage(pages.Staging(tmp_path), made)
    assert not (tmp_path / "gone.md").exists()


def test_every_command_type_and_public_name_has_its_place() -> None:
    options = commands.pages()[commands.PAGE]
    for command in names.commands():
        assert re.search(rf"^### `arcless {command}(?: .*)?`$", options, re.M), command
    types = schemas.pages()
    assert {f"{schemas.FOLDER}/{name}.md" for name in ("Line", "Scenario", "Study")} <= set(types)
    assert "number of m (" in types[f"{schemas.FOLDER}/Geometry.md"]
    top = python.pages()[f"{python.FOLDER}/arcless.md"]
    for name in arcless.__all__:
        thing = getattr(arcless, name)
        if not re.match(r"<module|'?\d", repr(thing)):
            assert re.search(rf"^\.\. auto\w+:: {name}$", top, re.M), name


OUTSIDE = [
    '<script src="https://example.org/a.js"></script>',
    '<img src="//example.org/a.png" alt="">',
    '<link rel="stylesheet" href="http://example.org/a.css">',
    '<p style="background: url(https://example.org/a.png)">',
    "<style>@import 'https://example.org/a.css';</style>",
    '<script>fetch("https://example.org/a.json")</script>',
]


@pytest.mark.parametrize("loaded", OUTSIDE)
def test_a_page_that_loads_something_from_elsewhere_is_refused(tmp_path: Path, loaded: str) -> None:
    page = tmp_path / "a.html"
    page.write_text(f"<html>{loaded}</html>", "utf-8")
    (found,) = checks.complaints(tmp_path)
    assert found.startswith("a.html: loads ") and "example.org" in found
    page.write_text('<a href="https://example.org/">a link is loaded by a click</a>', "utf-8")
    assert checks.complaints(tmp_path) == []


def test_style_sheets_are_looked_at(tmp_path: Path) -> None:
    (tmp_path / "a.css").write_text("@font-face {src: url(https://example.org/a.woff2)}", "utf-8")
    assert checks.complaints(tmp_path) == ["a.css: loads https://example.org/a.woff2"]


@pytest.mark.parametrize(
    ("link", "complaint"),
    [
        ("b.html", []), ("b.html#here", []), ("#there", []), ("mailto:a@b", []),
        ("c.html", ["a.html: a link to c.html, which is not there"]),
        ("b.html#gone", ["a.html: a link to b.html#gone, where gone is no place"]),
    ],
)  # fmt: skip
def test_links_lead_somewhere(tmp_path: Path, link: str, complaint: list[str]) -> None:
    (tmp_path / "a.html").write_text(f'<p id="there"><a href="{link}">x</a></p>', "utf-8")
    (tmp_path / "b.html").write_text('<p id="here">', "utf-8")
    assert checks.complaints(tmp_path) == complaint
