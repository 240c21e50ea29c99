"""Tokens of the design, read from `tokens.json`: sizes, spacing, and colours by meaning.

Pages get them as properties of CSS, figures by name. Nothing else in the package names a colour.
"""

import json
from functools import cache
from pathlib import Path
from typing import Any, Literal

Scheme = Literal["light", "dark"]

# Colours of pantographs and of series of equal rank, in turn.
_PANTOGRAPHS, _SERIES = 4, 8
_SHADES = 256


@cache
def tokens() -> dict[str, Any]:
    """Return all tokens by group and name."""
    found: dict[str, Any] = json.loads(Path(__file__).with_suffix(".json").read_text("utf-8"))
    return found


def colour(name: str, scheme: Scheme = "light") -> str:
    """Return a colour as ``#rrggbb``.

    Raises
    ------
    KeyError
        There is no such token.
    """
    found: str = tokens()[scheme][name]
    return found


def of_pantograph(index: int) -> str:
    """Return the token of a pantograph, the leading one at 0."""
    return f"pantograph_{index % _PANTOGRAPHS + 1}"


def of_series(index: int) -> str:
    """Return the token of one of several curves of equal rank."""
    return f"series_{index % _SERIES + 1}"


@cache
def shades(order: str, count: int = _SHADES) -> tuple[str, ...]:
    """Return so many colours of an order, evenly spaced between those of the tokens."""
    given = [_channels(text) for text in tokens()["orders"][order]]
    found = []
    for place in range(count):
        along = place / (count - 1) * (len(given) - 1)
        left = min(int(along), len(given) - 2)
        part = along - left
        mixed = (
            round(a + part * (b - a)) for a, b in zip(given[left], given[left + 1], strict=True)
        )
        found.append("#" + "".join(f"{channel:02x}" for channel in mixed))
    return tuple(found)


def css() -> str:
    """Return the tokens as properties of CSS: light, dark where the reader's system is, and chosen.

    A page in print is light whatever the screen was.
    """
    plain = [
        *(f"--font-{name}: {value};" for name, value in tokens()["font"].items()),
        *(f"--size-{name}: {value};" for name, value in tokens()["size"].items()),
        *(f"--space-{name}: {value};" for name, value in tokens()["space"].items()),
    ]
    light, dark = (_properties(scheme) for scheme in ("light", "dark"))
    return "\n".join(
        [
            f":root {{ color-scheme: light; {' '.join(plain)} {light} }}",
            f"@media screen {{ :root[data-scheme=dark] {{ color-scheme: dark; {dark} }}",
            "@media (prefers-color-scheme: dark) {",
            f":root:not([data-scheme=light]) {{ color-scheme: dark; {dark} }} }} }}",
        ]
    )


def _properties(scheme: str) -> str:
    given = tokens()[scheme].items()
    return " ".join(f"--{name.replace('_', '-')}: {value};" for name, value in given)


def _channels(text: str) -> tuple[int, ...]:
    return tuple(int(text[place : place + 2], 16) for place in (1, 3, 5))
