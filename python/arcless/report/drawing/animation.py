"""An animation as a page of a run carries it: script, style, data, and what is said of it."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Animation:
    """An animation that needs nothing but the page.

    Attributes
    ----------
    script, style
        One classic script, and the style of what it draws.
    data
        What the script shows, as JSON in which nothing ends an element of HTML.
    caption
        What is seen, and what was thinned, in whole sentences.
    """

    script: str
    style: str
    data: str
    caption: str
