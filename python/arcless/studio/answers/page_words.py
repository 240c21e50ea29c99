"""Hints of the package in words of the page, which has no options of a command line."""

import re

# Parts of hints that name options → what the page offers instead; nothing where it offers nothing.
_INSTEAD = (
    (r", or another folder with `?--to`?", ""),
    (r"leave the ending out; `?--to`? names a folder", "leave the ending out"),
    (r"`?--to`? names a folder", "leave the folder out"),
    (r"leave `?--with-pantographs`? out, or begin", "begin"),
    (r"`--overwrite` replaces it, `--out FOLDER` keeps both", "give the scenario another name"),
    (r"choose another (folder|one) with `--out`", "give the scenario or the study another name"),
    (r"in another folder with `--out`", "with another name"),
    (r"with `--out NEW_FOLDER`", "with another name"),
    (r"give `--head-mass`, or call", "call"),
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
    for found, instead in _INSTEAD:
        text = re.sub(found, instead, text)
    message, mark, hint = text.partition(_HINT)
    return message if mark and _OPTION.search(hint) else text
