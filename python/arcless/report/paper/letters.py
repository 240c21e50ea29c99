"""Letters that can be set: those of the typeface, and none that only steer a text."""

import re
import unicodedata
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path
from typing import Any

# Set in place of a letter that cannot be.
INSTEAD = "\ufffd"
# Categories of Unicode that are no letters: they steer, are private, or nothing. PDF/A refuses some
# of them, and a name in which the order of letters is turned round could be read as another one.
_NO_LETTERS = {"Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp"}
_NO_ASCII = re.compile(r"[^ -~]")


class MissingLettersWarning(UserWarning):
    """Some letters of a document are not in its typeface."""


def fonts() -> Path:
    """Return the folder of DejaVu, which comes with matplotlib: texts and figures have one face."""
    import matplotlib

    return Path(matplotlib.get_data_path()) / "fonts" / "ttf"


def settable(data: Any) -> Any:
    """Return plain data in which each text can be set."""
    if isinstance(data, str):
        return settable_text(data)
    if isinstance(data, dict):
        return {key: settable(value) for key, value in data.items()}
    if isinstance(data, list | tuple):
        return [settable(value) for value in data]
    return data


def settable_text(text: str) -> str:
    """Return a text with `INSTEAD` in place of each letter that cannot be set."""
    return _NO_ASCII.sub(_set, text)


def _set(found: re.Match[str]) -> str:
    letter = found[0]
    if letter in "\t\n\r":
        return "\n" if letter == "\n" else " "
    is_letter = unicodedata.category(letter) not in _NO_LETTERS and ord(letter) in _known()
    return letter if is_letter else INSTEAD


def lacking(texts: Iterable[str]) -> str:
    """Return the letters of some texts that are not in the typeface, each once, in order."""
    known, found = _known(), set[str]()
    for text in texts:
        found.update("" if text.isascii() else text)
    return "".join(sorted(c for c in found if c.isprintable() and ord(c) not in known))


def texts_of(data: Any) -> Iterator[str]:
    """Yield all texts of plain data."""
    if isinstance(data, str):
        yield data
    elif isinstance(data, dict):
        for value in data.values():
            yield from texts_of(value)
    elif isinstance(data, list | tuple):
        for value in data:
            yield from texts_of(value)


@cache
def _known() -> frozenset[int]:
    """Return the letters of DejaVu Sans."""
    from matplotlib.ft2font import FT2Font

    return frozenset(FT2Font(str(fonts() / "DejaVuSans.ttf")).get_charmap())
