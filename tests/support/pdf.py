"""PDF files as tests read them: by poppler's programs where they are; texts of documents."""

import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

from arcless.report.paper.blocks import Document, Table


def text_of(file: Path) -> str:
    """Return the text of a PDF file in one line, as a reader copies it; skip without poppler."""
    return " ".join(_poppler("pdftotext", file, "-").replace("\u200b", "").split())


def facts_of(file: Path) -> dict[str, str]:
    """Return the properties of a PDF file; skip without poppler."""
    lines = _poppler("pdfinfo", file).splitlines()
    return {name: value.strip() for name, _, value in (line.partition(":") for line in lines)}


def fonts_of(file: Path) -> list[tuple[str, bool]]:
    """Return each font and whether it is embedded; skip without poppler."""
    rows = [line.split() for line in _poppler("pdffonts", file).splitlines()[2:]]
    return [(row[0], row[-5] == "yes") for row in rows]


def cells_of(document: Document) -> list[str]:
    """Return all texts of the tables of a document."""
    found: list[str] = []
    for section in (*document.sections, *document.appendices):
        for block in section.blocks:
            for row in block.rows if isinstance(block, Table) else ():
                for cell in row:
                    found += [cell] if isinstance(cell, str) else [cell.text, cell.small]
    return [text for text in found if text]


def blocks_of(document: Document, kind: type) -> list[Any]:
    """Return the blocks of a kind."""
    sections = (*document.sections, *document.appendices)
    return [one for section in sections for one in section.blocks if isinstance(one, kind)]


def _poppler(program: str, *words: object) -> str:
    if shutil.which(program) is None:
        pytest.skip(f"{program} of poppler is not installed")
    done = subprocess.run(
        [program, *map(str, words)], capture_output=True, text=True, timeout=60, check=True
    )
    return done.stdout
