"""Checks of the built pages: inner links lead somewhere, and nothing is loaded from elsewhere."""

import re
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote

# Attributes by which a browser loads a file; a link to another site is loaded by a click only.
LOADING = {"src", "srcset", "poster", "data", "background", "formaction"}
LOADING_LINKS = {
    "stylesheet", "icon", "preload", "prefetch", "modulepreload", "preconnect", "manifest",
}  # fmt: skip
ELSEWHERE = re.compile(r"^\s*(?:[a-z]+:)?//", re.IGNORECASE)
# Addresses in style sheets, and requests that a script names.
IN_STYLE = re.compile(r"(?:url\(|@import)\s*[\"']?\s*((?:https?:)?//[^\s\"')]+)", re.IGNORECASE)
REQUEST = r"(?:fetch|import|importScripts|\.src\s*=|\.open)\s*\(?\s*"
IN_SCRIPT = re.compile(REQUEST + r"[\"'`]((?:https?:)?//[^\"'`]+)")


class Page(HTMLParser):
    """One built page: its anchors, its links, and what a browser loads with it."""

    def __init__(self, text: str) -> None:
        super().__init__(convert_charrefs=True)
        self.anchors: set[str] = set()
        self.links: list[str] = []
        self.loaded: list[str] = []
        self.raw = ""
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Keep what a tag names."""
        given = {name: value or "" for name, value in attrs}
        self.anchors |= {given[name] for name in ("id", "name") if name in given}
        if tag == "a" and "href" in given:
            self.links.append(given["href"])
        if tag == "link" and LOADING_LINKS & set(given.get("rel", "").lower().split()):
            self.loaded.append(given.get("href", ""))
        if tag in ("image", "use"):  # of SVG
            self.loaded += [given[name] for name in ("href", "xlink:href") if name in given]
        self.loaded += [given[name] for name in LOADING & set(given)]
        self.loaded += IN_STYLE.findall(given.get("style", ""))

    def handle_data(self, data: str) -> None:
        """Keep addresses in style sheets and scripts that stand in the page."""
        patterns = {"style": IN_STYLE, "script": IN_SCRIPT}
        if pattern := patterns.get(self.cdata_elem or ""):
            self.loaded += pattern.findall(data)


def complaints(folder: Path) -> list[str]:
    """Return what is wrong with the built pages in a folder."""
    pages = {path: Page(path.read_text("utf-8")) for path in sorted(folder.rglob("*.html"))}
    found = [text for path, page in pages.items() for text in _of_page(folder, path, pages, page)]
    for path in sorted([*folder.rglob("*.css"), *folder.rglob("*.svg"), *folder.rglob("*.js")]):
        pattern = IN_SCRIPT if path.suffix == ".js" else IN_STYLE
        name = path.relative_to(folder)
        text = path.read_text("utf-8")
        found += [f"{name}: loads {address}" for address in pattern.findall(text)]
    return found


def _of_page(folder: Path, path: Path, pages: dict[Path, Page], page: Page) -> Iterator[str]:
    name = path.relative_to(folder)
    for address in page.loaded:
        if ELSEWHERE.match(address):
            yield f"{name}: loads {address}"
    for link in page.links:
        if re.match(r"[a-z]+:|//", link):
            continue
        target, _, anchor = unquote(link).partition("#")
        there = (path.parent / target.partition("?")[0]).resolve() if target else path
        if there.is_dir():
            there /= "index.html"
        if not there.exists():
            yield f"{name}: a link to {target}, which is not there"
        elif anchor and there in pages and anchor not in pages[there].anchors:
            yield f"{name}: a link to {link}, where {anchor} is no place"
