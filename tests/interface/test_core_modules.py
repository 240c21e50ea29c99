"""Modules of the numerical core use one another one way, in the order of its rooms.

A room is a folder or a module that stands beside the folders in `crates/core/src`. Every path that
begins with `crate`, `self` or `super` counts, in `use` lines and elsewhere, but for unit tests.
"""

import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from tests.interface.test_imports import check_no_circle

SOURCE = Path(__file__).parents[2] / "crates" / "core" / "src"
# Each uses only itself and what stands to its left.
ORDER = (
    "lcp", "error", "scheme", "linalg", "filter", "checkpoint", "energy_terms", "structure",
    "structure_check", "element", "residual_flexibility", "statics", "slideline", "linear",
    "pantograph", "constraint", "integrator", "line", "simulation", "session",
)  # fmt: skip
MOST_FILES = 12
TESTS = re.compile(r"#\[cfg\(test\)\]\s*mod \w+ \{.*", re.DOTALL)
TOKEN = re.compile(r"\w+|::|[{},]")
ROOT = re.compile(r"\b(?:crate|self|super)::")


@cache
def modules() -> dict[str, Path]:
    """Return the modules by their paths, `constraint::row`; the top one has no name."""
    found = {}
    for path in sorted(SOURCE.rglob("*.rs")):
        parts = path.relative_to(SOURCE).with_suffix("").parts
        if parts[-1].endswith("tests"):
            continue
        found["::".join(parts).removesuffix("::mod")] = path
    return found


def paths(text: str) -> Iterator[list[str]]:
    """Yield the paths in a text, trees of braces as one path for each leaf."""
    for root in ROOT.finditer(text):
        # Of `super::super::x` the first one is the root.
        if text[: root.start()].endswith(("super::", "crate::", "self::")):
            continue
        stack: list[list[str]] = []
        path: list[str] = []
        for token in TOKEN.finditer(text, root.start()):
            if token[0] == "::":
                continue
            if token[0] == "{" and text[: token.start()].endswith("::"):
                stack.append(list(path))
            elif token[0] in "{},":
                if path:
                    yield path
                if token[0] == "}" and stack:
                    stack.pop()
                if not stack:
                    break
                # Behind an inner tree nothing follows but the next one.
                path = [] if token[0] == "}" else list(stack[-1])
            elif not stack and path and not text[: token.start()].endswith("::"):
                yield path
                break
            else:
                path.append(token[0])


def used(name: str) -> set[str]:
    """Return the modules that a module uses."""
    text = TESTS.sub("", modules()[name].read_text("utf-8"))
    text = re.sub(r"//[^\n]*", "", text)
    found = set()
    for path in paths(text):
        whole = [] if name == "lib" else name.split("::")
        for part in path:
            whole = {"crate": [], "self": whole, "super": whole[:-1]}.get(part, [*whole, part])
        for length in range(len(whole), 0, -1):
            target = "::".join(whole[:length])
            if target in modules():
                found.add(target)
                break
    return found - {name}


def test_paths_of_a_tree_of_braces_are_all_found() -> None:
    text = "use crate::a::{b::{C, d}, e};\nlet x = super::h::i(1);\nuse super::super::j::K as L;"
    assert ["::".join(path) for path in paths(text)] == [
        "crate::a::b::C",
        "crate::a::b::d",
        "crate::a::e",
        "super::h::i",
        "super::super::j::K",
    ]


def test_modules_of_the_core_use_one_another_in_one_direction() -> None:
    check_no_circle({name: used(name) for name in modules()})


def test_rooms_of_the_core_stand_in_order() -> None:
    for name in modules().keys() - {"lib"}:
        room = name.split("::")[0]
        allowed = set(ORDER[: ORDER.index(room) + 1])
        others = {each.split("::")[0] for each in used(name)}
        assert others <= allowed, f"{name} uses {sorted(others - allowed)}"


def test_no_folder_of_the_core_has_more_than_a_dozen_files() -> None:
    for folder in {path.parent for path in modules().values()} - {SOURCE}:
        own = [path for path in modules().values() if path.parent == folder]
        assert len([path for path in own if path.stem != "mod"]) <= MOST_FILES, folder
