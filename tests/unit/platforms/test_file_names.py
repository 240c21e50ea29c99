"""Names that Windows takes for no file, or for another one."""

from pathlib import PureWindowsPath

import pytest

from arcless.platforms.file_names import refused_by_windows

DEVICES = [
    "con", "CON", "nul", "NUL.yaml", "aux.tar.gz", "prn", "com1", "COM0", "lpt9.yaml", "com\u00b2",
    "conin$", "CONOUT$", "nul .yaml", "con  ", "con.",
]  # fmt: skip
FILES = [
    "console", "null.yaml", "com10", "com", "lpt", "auxiliary.yaml", "my-con", "con-1.yaml", ".con",
    "Fahrleitung-Süd.yaml", "線路.yaml", "a b.csv", "a.b.c",
]  # fmt: skip


@pytest.mark.parametrize("name", DEVICES)
def test_devices(name: str) -> None:
    assert "the name of a device on Windows" in str(refused_by_windows(name))


@pytest.mark.parametrize("name", FILES)
def test_files(name: str) -> None:
    assert refused_by_windows(name) is None
    assert not PureWindowsPath(name).is_reserved()


# Of CONIN$ and COM0 Microsoft says so, and Python 3.11 does not.
@pytest.mark.parametrize("name", [name for name in DEVICES if "$" not in name and "0" not in name])
def test_python_says_so_too(name: str) -> None:
    assert PureWindowsPath(name).is_reserved()


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("line.", "a dot at the end"),
        ("line.yaml ", "a blank at the end"),
        ("line.yaml:stream", "':', which Windows has in no name"),
        ("a<b", "'<'"),
        ("what?.csv", "'?'"),
        ("a\tb", "'\\t'"),
        ("a\\b", "'\\\\'"),
    ],
)
def test_what_else_is_refused(name: str, words: str) -> None:
    assert words in str(refused_by_windows(name))
