"""Ends of processes in words, of POSIX and of Windows, wherever this runs."""

import pytest

from arcless.platforms.ends import why_ended


@pytest.mark.parametrize(
    ("code", "words", "hint"),
    [
        (-9, "it was killed, by a user or because", "record less"),
        (-11, "it crashed (segmentation fault)", "please report it"),
        (-8, "it crashed (division by zero)", "please report it"),
        (-63, "signal 63", None),
        (7, "it ended with code 7", "please report it"),
        (0xC0000005, "it crashed (access violation)", "please report it"),
        (0xC0000094, "it crashed (division by zero)", "please report it"),
        (0xC0000017, "the memory of the machine was used up", "record less"),
        (0xC000013A, "it was ended by Ctrl-C", None),
        (0xC0001234, "it ended with code 0xC0001234", "please report it"),
    ],
)
def test_words_and_hint(code: int, words: str, hint: str | None) -> None:
    found, told = why_ended(code)
    assert words in found
    assert (told is None) if hint is None else (told is not None and hint in told)
