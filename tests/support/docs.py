"""The modules of docs/validation, which make tables of its pages."""

import importlib
import sys
from pathlib import Path
from types import ModuleType

DOCS = Path(__file__).parents[2] / "docs"


def from_docs(name: str) -> ModuleType:
    """Import `docs/validation/NAME.py`, as `docs/make_pages.py` does."""
    if str(DOCS) not in sys.path:
        sys.path.append(str(DOCS))
    return importlib.import_module(f"validation.{name}")
