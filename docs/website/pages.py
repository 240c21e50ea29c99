"""Sources of the site: pages of docs, and files of the repository that they link to.

Pages stay plain Markdown in docs. Their copies in the build folder differ in two things: links that
lead out of docs lead to copies of those files, and each index page gets a table of contents from
its own links.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath
from posixpath import normpath, relpath

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
# Files outside of docs that are pages of the site under other names.
PAGES = {
    "README.md": "index.md",
    "CHANGELOG.md": "changelog.md",
    "CONTRIBUTING.md": "contributing.md",
}
INDEX = "index.md"
LINK = re.compile(r"(?<!\\)\]\(([^()\s]+)\)")
NAMED_LINK = re.compile(r"\[([^][]+)\]\(([^()\s:]+)\)")
# Fenced code, indented code after a blank line, inline code: no link stands in it.
CODE = re.compile(r"^```(?s:.*?)^```$|(?<=\n\n)(?:    .*\n)+|`[^`\n]+`", re.MULTILINE)
HEADING = re.compile(r"(?=^## )", re.MULTILINE)
DATA = (".csv",)  # is downloaded, not shown
LANGUAGES = {
    ".py": "python", ".rs": "rust", ".c": "c", ".h": "c", ".m": "matlab", ".yaml": "yaml",
    ".json": "json",
}  # fmt: skip


def outside_of_code(text: str) -> Iterator[tuple[bool, str]]:
    """Yield the parts of a page in order: whether each is prose, and its text."""
    place = 0
    for code in CODE.finditer(text):
        yield True, text[place : code.start()]
        yield False, code[0]
        place = code.end()
    yield True, text[place:]


def links(text: str) -> list[str]:
    """Return the targets of all links of a page, in their order."""
    prose = (part for is_prose, part in outside_of_code(text) if is_prose)
    return [target for part in prose for target in LINK.findall(part)]


def is_inner(target: str) -> bool:
    """Return whether a link leads to a file of the repository."""
    return not re.match(r"[a-z]+:|#", target)


@dataclass
class Staging:
    """Copies of pages in a folder that Sphinx reads.

    Attributes
    ----------
    folder
        Where the copies are.
    sources
        Paths in the repository, of files and folders outside of docs, that pages link to.
    index_changed
        Whether an index page was written: the navigation of all pages follows from those.
    """

    folder: Path
    sources: set[str] = field(default_factory=set)
    index_changed: bool = False

    def place(self, path: str) -> str:
        """Return where a file of the repository is in the site."""
        if path in PAGES:
            return PAGES[path]
        if path.startswith("docs/") and (path.endswith(".md") or (ROOT / path).is_file()):
            return path.removeprefix("docs/")
        self.sources.add(path)
        if PurePosixPath(path).suffix in DATA:
            return f"sources/{path}"
        return f"sources/{path}/{INDEX}" if (ROOT / path).is_dir() else f"sources/{path}.md"

    def linked(self, text: str, path: str) -> str:
        """Return the text of a file of the repository with links as they are in the site."""
        here = PurePosixPath(self.place(path)).parent

        def renamed(match: re.Match[str]) -> str:
            name, hash_sign, anchor = match[1].partition("#")
            if not is_inner(match[1]) or not name:
                return match[0]
            there = self.place(normpath(str(PurePosixPath(path).parent / name)))
            return f"]({relpath(there, here)}{hash_sign}{anchor})"

        parts = outside_of_code(text)
        return "".join(LINK.sub(renamed, part) if prose else part for prose, part in parts)

    def write(self, name: str, text: str) -> None:
        """Write a page of the site, unless it is there as it should be: Sphinx reads it again."""
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.exists() or path.read_text("utf-8") != text:
            path.write_text(text, "utf-8")
            self.index_changed |= path.name == INDEX


def contents(text: str, page: str, pages: set[str]) -> str:
    """Return the tables of contents of an index page: one for each heading that has links.

    An index has the pages of its own folder, and the index pages of the folders below. The first
    page of the site names its parts by the words of its links.
    """
    folder = PurePosixPath(page).parent
    is_first = str(folder) == "."
    tables, seen = [], {page}
    for section in HEADING.split(text):
        entries = []
        for words, target in NAMED_LINK.findall(section):
            there = normpath(str(folder / target.partition("#")[0]))
            parent = PurePosixPath(there).parent
            own = parent == folder or (there.endswith(INDEX) and parent.parent == folder)
            if own and there in pages and there not in seen:
                seen.add(there)
                place = "/" + there.removesuffix(".md")
                entries.append(f"{words} <{place}>" if is_first else place)
        title = section.partition("\n")[0]
        # A heading that is a link is the title of that page already.
        named = title.startswith("## ") and not LINK.search(title) and not is_first
        caption = [f":caption: {title.removeprefix('## ')}"] if named else []
        if entries:
            tables.append("\n".join(["```{toctree}", ":hidden:", *caption, "", *entries, "```"]))
    return "\n\n".join(tables)


def stage(staging: Staging, made: dict[str, str]) -> None:
    """Write the sources of the site.

    Parameters
    ----------
    staging
        Where they are written.
    made
        Pages that the program makes, by their place in the site. Where docs has a page at this
        place, the text follows its text.
    """
    texts = {f"docs/{path.relative_to(DOCS).as_posix()}": path for path in DOCS.rglob("*.md")}
    texts |= {path: ROOT / path for path in PAGES if path != "README.md"}
    texts = {path: staging.linked(file.read_text("utf-8"), path) for path, file in texts.items()}
    pages = {staging.place(path): text for path, text in texts.items()}
    # Links were looked for in the repository; these pages are in the site alone.
    pages |= {name: f"{pages.get(name, '')}\n{text}".lstrip() for name, text in made.items()}
    todo = set(staging.sources)
    while todo:  # a folder adds its files
        for path in todo:
            if PurePosixPath(path).suffix not in DATA:
                pages[staging.place(path)] = _source(staging, path)
        todo = {path for path in staging.sources - todo if staging.place(path) not in pages}
        todo -= {path for path in todo if PurePosixPath(path).suffix in DATA}
    for name, text in pages.items():
        if PurePosixPath(name).name == INDEX and not name.startswith("sources/"):
            text = f"{text}\n\n{contents(text, name, set(pages))}\n"  # noqa: PLW2901
        staging.write(name, text)
    _copy_files(staging)
    gone = {path.relative_to(staging.folder).as_posix() for path in staging.folder.rglob("*.md")}
    for name in gone - set(pages):
        (staging.folder / name).unlink()


def _source(staging: Staging, path: str) -> str:
    """Return the page of a file of the repository, or the list of those in a folder."""
    head = "---\norphan: true\nnosearch: true\n---\n\n"
    file = ROOT / path
    if file.is_dir():
        listed = sorted(p for p in file.iterdir() if p.is_file() and p.suffix in LANGUAGES)
        for one in listed:
            staging.place(f"{path}/{one.name}")
        rows = [f"- [{one.name}]({one.name}.md)" for one in listed]
        return "\n".join([f"{head}# `{path}`\n", *rows, ""])
    language = LANGUAGES.get(file.suffix, "text")
    return f"{head}# `{path}`\n\n~~~~~{language}\n{file.read_text('utf-8').rstrip()}\n~~~~~\n"


def _copy_files(staging: Staging) -> None:
    """Copy pictures, and files of docs that pages link to."""
    pictures = [p for p in (DOCS / "images").rglob("*") if p.suffix in (".svg", ".webp", ".png")]
    wanted = {file: staging.folder / file.relative_to(DOCS) for file in pictures}
    for page in DOCS.rglob("*.md"):
        for target in filter(is_inner, links(page.read_text("utf-8"))):
            file = (page.parent / target.partition("#")[0]).resolve()
            if file.is_file() and file.is_relative_to(DOCS) and file.suffix != ".md":
                wanted[file] = staging.folder / file.relative_to(DOCS)
    for path in staging.sources:
        if PurePosixPath(path).suffix in DATA:
            wanted[ROOT / path] = staging.folder / staging.place(path)
    for file, copy in wanted.items():
        copy.parent.mkdir(parents=True, exist_ok=True)
        if not copy.exists() or copy.read_bytes() != file.read_bytes():
            copy.write_bytes(file.read_bytes())
