"""The guide to damping prints what its script finds, and what the lines have."""

import re

import pytest

from arcless.model import load_line
from arcless.model.shipped.library import shipped
from tests.support.pages import DOCS, maker

make = maker("make_damping")
GUIDE = (DOCS / "guide" / "damping.md").read_text("utf-8")
REFERENCES = ("ac-simple", "en50318", "praks", "conductor-rail")
REAL = [name for name in shipped("line") if not name.startswith(REFERENCES)]


def rows(name: str) -> list[list[str]]:
    found = re.findall(rf"^\| {name}, \d+ m \| (.*) \|$", GUIDE, re.MULTILINE)
    return [row.split(" | ") for row in found]


@pytest.mark.parametrize("name", REAL)
def test_real_lines_have_the_damping_that_the_guide_says(name: str) -> None:
    line = load_line(name)
    for field in ("contact_wire", "messenger_wire", "auxiliary_wire", "stitch_wire", "bridle"):
        wire = getattr(line, field)
        if wire is not None:
            assert (wire.damping.alpha, wire.damping.beta) == (0.17, make.BETA)
            assert line.provenance[f"{field}.damping"].mark == "assumed"
    # 1 % where it was measured; the guide rounds to two digits.
    assert make.share(0.17, make.BETA, make.MEASURED) == pytest.approx(0.01, rel=0.02)


def test_shares_of_the_guide() -> None:
    for alpha, beta, said in (
        (0.17, 1e-4, "1.4, 1.0, 0.43, 0.70 %"),
        (0.0125, 1e-4, "0.13, 0.12, 0.18, 0.63 %"),
        (0.114, 2.9e-4, "1.0, 0.78, 0.64, 1.9 %"),
    ):
        found = [100 * make.share(alpha, beta, f) for f in (1.0, 1.4, 5.0, 20.0)]
        shown = [float(number) for number in said.removesuffix(" %").split(", ")]
        assert said in GUIDE
        assert found == pytest.approx(shown, abs=0.051)  # as printed, to one or two decimals


@pytest.mark.parametrize("name", make.LINES)
def test_rows_are_those_of_the_script(name: str) -> None:
    shares, betas = rows(name)[:4], rows(name)[4:]
    assert [float(row[0]) for row in shares] == [100 * share for share in make.SHARES]
    for row, share in zip(shares, make.SHARES, strict=True):
        assert float(row[1]) == pytest.approx(make.alpha_of(share), abs=5e-4)
    assert [float(row[0]) for row in betas] == list(make.BETAS)


def test_a_row_is_found_again() -> None:
    row = rows("spain-ca-220-220")[1]
    found = make.pair("spain-ca-220-220", make.alpha_of(0.01), make.BETA)
    # The last digit, and 1 % for another compiler's rounding, which waves of seconds carry on.
    assert found == pytest.approx([float(cell) for cell in row[2:]], rel=0.01, abs=0.06)
