"""Patterns for editors accept the texts that are read, and refuse those that are not."""

import json
import re
import subprocess

import pytest
from hypothesis import given
from hypothesis import strategies as st

from arcless.errors import ModelError
from arcless.units import KINDS, pattern, spell, to_si
from arcless.units.kinds import ALIASES
from tests.browser.tools import node

UNITS = sorted(KINDS)
NAMES = sorted({*(name for kind in KINDS.values() for name in kind.units), *ALIASES})
numbers = st.sampled_from(["22", "-1.5e3", ".5", "2.", "+0", "1e-300"])


def is_read(text: str, unit: str) -> bool:
    try:
        to_si(text, unit)
    except ModelError:
        return False
    return True


@given(number=numbers, gap=st.sampled_from(["", " "]), data=st.data())
def test_it_accepts_what_is_read(number: str, gap: str, data: st.DataObject) -> None:
    unit, name = data.draw(st.sampled_from(UNITS)), data.draw(st.sampled_from(NAMES))
    power = data.draw(st.sampled_from(["^{}", "**{}", "{}"]))
    product = data.draw(st.sampled_from([" ", "*", " · ", "⋅"]))
    raised = re.sub("(?<=[mnt)])[23]", lambda found: power.format(found[0]), name)
    for spelled in (name, spell(name), raised.replace("·", product)):
        text = f"{number}{gap}{spelled}"
        assert bool(re.search(pattern(unit), text)) == is_read(text, unit), text


@given(text=st.text(max_size=12) | st.from_regex(r"\A[0-9., _'e+-]{1,6} ?[kmN°/ s·*^2]{0,5}\Z"))
def test_it_refuses_what_is_not_read(text: str) -> None:
    for unit in UNITS:
        # Products and quotients may be written with more than one sign, which is not read; neither
        # are numbers beyond 1e308, which no pattern tells.
        if re.search(pattern(unit), text) and not re.search(r"[\s·⋅*/]{2}|[eE]\+?\d{3}", text):
            assert is_read(text, unit), (text, unit)


def test_editors_read_the_same_patterns() -> None:
    """JSON Schema has the regular expressions of ECMA-262, which are not those of Python."""
    place = node()
    if place is None:
        pytest.skip("there is no Node here")
    cases = [(pattern(unit), f"3 {spell(name)}") for unit, kind in KINDS.items()
             for name in kind.units]  # fmt: skip
    cases.append((pattern("1/s"), "3 s⁻¹"))
    script = (
        "const cases = JSON.parse(require('fs').readFileSync(0, 'utf8'));"
        "console.log(JSON.stringify(cases.map(([p, t]) => new RegExp(p, 'u').test(t))));"
    )
    done = subprocess.run(
        [place / "bin" / "node", "-e", script], input=json.dumps(cases),
        capture_output=True, text=True, check=True, timeout=60,
    )  # fmt: skip
    assert json.loads(done.stdout) == [True] * len(cases)
