"""Files as large as they may be are taken or refused soon, whatever they are made of.

The worst found are here, those that once took from 6 s to two minutes; the page on hostile input
has their times. The limit leaves room for a slow machine, not for work that grows with the square.
"""

import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import pytest

from arcless.errors import ModelError
from arcless.model import load_any
from arcless.model.files.yaml_reader import MAX_BYTES
from tests.unit.model.conftest import LINE

MOST_S = 25.0  # of this process; 1 s to 7 s are usual
HEAD = "format: arcless-line/1\nname: x\n"
SCENARIO = "format: arcless-scenario/1\nname: x\nline: ac-simple-55\n"
RUNNING = f"{SCENARIO}pantographs: [{{model: dsa-380}}]\nspeed: 50\n"

LARGE: dict[str, Callable[[], str]] = {
    "unknown fields": lambda: HEAD + "".join(f"key{i}: 1\n" for i in range(149_000)),
    "fields beside a value": lambda: (
        f"{HEAD}contact_wire:\n  tension:\n    value: 1\n"
        + "".join(f"    key{i}: 1\n" for i in range(149_000))
    ),
    "a text of 1.2 million lines": lambda: f"{HEAD}description:\n" + "  a\n" * 1_240_000,
    "empty lines in quotes": lambda: f'{HEAD}description: "' + "\n" * 4_900_000 + '"\n',
    "halves of characters": lambda: f'{HEAD}description: "' + r"\ud83d\ude00" * 415_000 + '"\n',
    "halves in keys": lambda: (
        '{"format": "arcless-line/1", "name": {'
        + ",".join(rf'"\ud83d\ude00{i}": "\ud83d\ude00"' for i in range(74_000))
        + "}}"
    ),
    "anchors": lambda: f"{HEAD}b: [" + "".join(f"&a{i} 1," for i in range(149_000)) + "1]\n",
    "pantographs": lambda: f"{SCENARIO}pantographs:\n" + "- {model: dsa-380}\n" * 49_000,
    "span types": lambda: (
        LINE.replace("spans:\n", "")
        .replace("  - {type: standard, count: 8}\n", "")
        .replace("span_types:\n", "spans: [{type: x}]\nspan_types:\n")
        + "".join(f"  a{i}: {{length: 50}}\n" for i in range(45_000))
    ),
    "wrong pre-sags": lambda: LINE.replace(
        "positions: [10, 20, 35, 45]", "positions: [1]\n      presag: [" + "x, " * 140_000 + "x]"
    ),
    "wrong errors of droppers": lambda: (
        f"{RUNNING}as_built:\n  dropper_length_errors:\n"
        + "  - {span: x, droper: 1, length_error: 1 kg}\n" * 37_000
    ),
    "a name of 5 MB": lambda: HEAD + "? " + "a" * 4_900_000 + "\n: 1\n",
    "a unit of 5 MB": lambda: LINE.replace("1.35 kg/m", "'1 " + "k·" * 1_600_000 + "'"),
}


# More of what others are made of: work that grows with the square shows there too.
ALIKE = ("fields beside a value", "halves in keys", "wrong errors of droppers")
KINDS = [pytest.param(kind, marks=pytest.mark.evidence if kind in ALIKE else ()) for kind in LARGE]


@pytest.mark.parametrize("kind", KINDS)
def test_large_files_are_answered_soon(kind: str, tmp_path: Path) -> None:
    path = tmp_path / "large.yaml"
    path.write_text(LARGE[kind](), encoding="utf-8")
    assert path.stat().st_size <= MAX_BYTES
    started = time.process_time()
    with suppress(ModelError):
        load_any(path)
    assert time.process_time() - started < MOST_S


def test_a_message_about_a_large_file_is_short(tmp_path: Path) -> None:
    path = tmp_path / "large.yaml"
    for kind in ("a name of 5 MB", "a unit of 5 MB"):
        path.write_text(LARGE[kind](), encoding="utf-8")
        with pytest.raises(ModelError) as caught:
            load_any(path)
        assert len(str(caught.value)) < 1000 + len(str(path))
