"""The code of the guide on figures runs as it is printed."""

import re
from pathlib import Path

import pytest

from arcless.results import Result
from tests.support.docs import DOCS


def test_code_of_the_guide(
    two: Result, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    text = (DOCS / "guide" / "figures.md").read_text("utf-8")
    pieces = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    assert len(pieces) == 4
    monkeypatch.chdir(tmp_path)
    folder = Path("runs/en50318-ac-simple-320")
    folder.mkdir(parents=True)
    two.save(folder / "result.nc")
    names: dict[str, object] = {}
    for piece in pieces:
        exec(piece, names)
    assert {path.name for path in tmp_path.iterdir()} == {"runs", "lead.svg", "lead.pdf", "two.png"}
    assert two.figures["lead"][0].alt in capsys.readouterr().out
