"""Words of the page for options of the command line, which nobody types there."""

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
    ("begin anew in another folder with `--out`", "begin it anew under another name"),
    ("begin anew with `--out NEW_FOLDER`", "begin it anew under another name"),
    ("begin anew with `--out`", "begin it anew under another name"),
    ("if it has a folder of its own, name that with `--out`", "continue the study first"),
    ("resume without --retry-failed", "continue it without the failed variants"),
    (
        "`--overwrite` replaces it, `--out FOLDER` keeps both",
        "another name of the scenario keeps both",
    ),
    (" (`--search`)", ""),
    ("widen the search (--search), or give the offset by hand (--offset)", _ALIGNED),
    ("give the offset by hand: --offset", _ALIGNED),
    ("use --align correlation, or --offset", _ALIGNED),
    ("give the offset of the first sample (--offset)", _ALIGNED),
    ("give another offset (--offset)", _ALIGNED),
    ("give `--head-mass`, or call", "call"),
)


def in_words_of_the_page(text: str) -> str:
    """Return a message without options of the command line."""
    for typed, words in _WORDS:
        text = text.replace(typed, words)
    return _MAKES_ONE.sub("running a scenario makes one", text)
