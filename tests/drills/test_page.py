"""The page about the drills names each of them."""

import re
from pathlib import Path

from tests.drills.conftest import ROOT

PAGE = ROOT / "docs" / "validation" / "failure-drills.md"


def test_every_file_of_drills_is_on_the_page() -> None:
    drills = {path.stem for path in Path(__file__).parent.glob("test_*.py")} - {Path(__file__).stem}
    assert drills
    assert drills == set(re.findall(r"^\| `(test_\w+)` \|", PAGE.read_text("utf-8"), re.MULTILINE))
