"""All places that break a rule of what is written, one a line."""

import sys
from collections.abc import Callable, Iterator
from pathlib import Path

from tests.prose.comments import NOMENCLATURE, ROOT, in_python, in_rust, unknown_names
from tests.prose.messages import in_program
from tests.prose.pages import in_page
from tests.prose.words import STYLE

Check = Callable[[Path], Iterator[tuple[int, str]]]

PAGES = (
    "README.md", "docs/*.md", "docs/tutorial/*.md", "docs/gallery/*.md", "docs/guide/*.md",
    "docs/theory/*.md", "docs/reference/*.md",
)  # fmt: skip


def checks() -> Iterator[tuple[Path, Check]]:
    """Yield each file with each check that it must pass."""
    for path in (ROOT / "python" / "arcless").rglob("*.py"):
        yield path, in_program
    for folder in ("python", "tests"):
        for path in (ROOT / folder).rglob("*.py"):
            yield path, in_python
    for path in (ROOT / "crates").rglob("*.rs"):
        yield path, in_rust
    for pattern in PAGES:
        for path in ROOT.glob(pattern):
            if path != STYLE:  # it quotes what it refuses
                yield path, in_page


def main() -> None:
    """Name what is wrong in all files; end with 1 if anything is."""
    code = [*(ROOT / "python").rglob("*.py"), *(ROOT / "crates").rglob("*.rs")]
    sources = "\n".join(path.read_text(encoding="utf-8") for path in code)
    lines = [
        f"{path.relative_to(ROOT)}:{number}: {text}"
        for path, check in sorted(checks(), key=lambda entry: entry[0])
        for number, text in sorted(check(path))
    ]
    name = NOMENCLATURE.relative_to(ROOT)
    lines += [f"{name}:{number}: {text}" for number, text in unknown_names(sources)]
    sys.exit("\n".join(lines) or None)


if __name__ == "__main__":
    main()
