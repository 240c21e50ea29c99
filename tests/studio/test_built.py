"""The built page: its size over a wire, and that it needs nothing from outside."""

import gzip
import re
from pathlib import Path

import pytest
from page.build import BUILT, missing

# In bytes, compressed by gzip -9. A first paint within half a second; all of it within a few
# seconds over a slow tunnel.
FIRST_CHUNK = 120_000
ALL = 700_000
ADDRESS = re.compile(r"(?:https?:)?//[a-z0-9.-]+\.[a-z]{2,}[^\s\"'`)<>\\]*", re.IGNORECASE)
# Names of vocabularies, which nobody loads, and pages that messages of libraries point at.
NAMES = re.compile(r"https?://(www\.w3\.org/|jcgt\.org/|www\.khronos\.org/)")
LOADED = re.compile(r"(?:src|href)=\"([^\"]+)\"")
IMPORTED = re.compile(r"""(?:\bimport|\bfrom)\s*["'](\./[^"']+)["']""")


@pytest.fixture(scope="module")
def built() -> Path:
    if reason := missing():
        pytest.skip(f"the page of the studio is not built: {reason}")
    assert (BUILT / "index.html").is_file(), "`make page` has not been run"
    return BUILT


def first(built: Path) -> set[Path]:
    """Return what is loaded before anything is shown: index.html, and what that needs at once."""
    index = built / "index.html"
    found = {index}
    ahead = [built / name for name in LOADED.findall(index.read_text("utf-8"))]
    while ahead:
        file = ahead.pop()
        if file in found:
            continue
        found.add(file)
        if file.suffix == ".js":
            names = IMPORTED.findall(file.read_text("utf-8"))
            ahead += [file.parent / name for name in names]
    return {file.resolve() for file in found}


def compressed(files: set[Path]) -> int:
    return sum(len(gzip.compress(file.read_bytes(), 9)) for file in files)


def test_sizes(built: Path) -> None:
    everything = {file for file in built.rglob("*") if file.is_file()}
    assert len(first(built)) >= 3, "a page, a script and a style sheet"
    assert compressed(first(built)) <= FIRST_CHUNK
    assert compressed(everything) <= ALL


def test_nothing_is_loaded_from_outside(built: Path) -> None:
    for file in built.rglob("*"):
        if file.suffix in {".html", ".css"}:
            # No data addresses: the content policy of the server refuses them.
            assert "data:" not in file.read_text("utf-8"), file.name
        if file.suffix in {".html", ".css", ".js"}:
            found = ADDRESS.findall(file.read_text("utf-8"))
            assert [one for one in found if not NAMES.match(one)] == [], file.name


def test_no_script_and_no_style_stands_in_the_page(built: Path) -> None:
    index = (built / "index.html").read_text("utf-8")
    assert not re.search(r"<script(?![^>]*\ssrc=)|<style|\sstyle=|\son[a-z]+=", index)


def test_an_address_is_found() -> None:
    assert ADDRESS.findall('import("https://cdn.example.org/a.js")')
    assert ADDRESS.findall("@import url(//fonts.example.org/b.css)")
    assert not NAMES.match("https://www.example.org/")
