"""Hints of the package in words of the page, which has no options of a command line."""

import re

_MAKES_ONE = re.compile(r"`arcless run SCENARIO --out [^`]*` makes one")
# In the page a measured run is aligned by itself.
_ALIGNED = "`arcless compare` takes an offset"
# Longer ones before those that they hold.
_WORDS = (
    (", or choose another folder with `--out`", ""),
    (", or name its folder with `--out`", ""),
    ("choose another folder with `--out NEW_FOLDER`", "give the study another name"),
    ("choose another folder with `--out`, on a", "open the studio on a folder of a"),
    (
        "choose another one with `--out`",
        "give it another name, or open the studio on another folder",
    ),
    ("choose another folder with `--out`", "open the studio on another folder"),
    ("restart in another folder with `--out`", "start it under another name"),
    ("restart with `--out NEW_FOLDER`", "start it under another name"),
    ("restart with `--out`", "start it under another name"),
    ("if it has a folder of its own, name that with `--out`", "continue the study first"),
    ("resume without --retry-failed", "continue it without the failed variants"),
    (
        "`--overwrite` replaces it, `--out FOLDER` keeps both",
        "another name of the scenario keeps both",
    ),
    ("widen the search (--search), or give the offset by hand (--offset)", _ALIGNED),
    ("give the offset by hand: --offset", _ALIGNED),
    ("use --align correlation, or --offset", _ALIGNED),
    ("give the offset of the first sample (--offset)", _ALIGNED),
    ("give another offset (--offset)", _ALIGNED),
    ("give `--head-mass`, or call", "call"),
)
# Parts of hints that name options → what the page offers instead; nothing where it offers nothing.
_INSTEAD = (
    (r", or another folder with `?--to`?", ""),
    (r"leave the ending out; `?--to`? names a folder", "leave the ending out"),
    (r"`?--to`? names a folder", "leave the folder out"),
    (r"leave `?--with-pantographs`? out, or begin", "begin"),
    (r"with `--out NEW_FOLDER`", "with another name"),
    (r" \(`?--[a-z-]+`?\)", ""),
)
_OPTION = re.compile(r"(?<![\w-])--[a-z]")
_HINT = "; hint: "


def in_page_words(text: str) -> str:
    """Return a sentence without options of the command line; a hint that needs one is left out.

    Parameters
    ----------
    text
        A hint, a whole message with its hint behind it, or a remark.
    """
    for typed, words in _WORDS:
        text = text.replace(typed, words)
    text = _MAKES_ONE.sub("running a scenario makes one", text)
    for found, instead in _INSTEAD:
        text = re.sub(found, instead, text)
    message, mark, hint = text.partition(_HINT)
    return message if mark and _OPTION.search(hint) else text
