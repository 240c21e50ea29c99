"""The beginning of the long search, and that it tells of what it is there for."""

import os
import signal
import time
from pathlib import Path

import pytest

from tests.hostile.campaign import blocks, border, models, receptances, texts
from tests.hostile.campaign.blocks import Kind, Place
from tests.support.hostile import FACTOR


@pytest.mark.parametrize(
    ("module", "count"), [(texts, 60), (models, 4), (receptances, 60), (border, 150)]
)
def test_the_first_cases(module: object, count: int) -> None:
    for seed in range(count * FACTOR):
        assert module.case(seed)  # type: ignore[attr-defined]


def strange(seed: int) -> str:
    """A case of each kind that must be told."""
    if seed == 3:
        raise RuntimeError("a panic, say")
    if seed == 5:
        os.kill(os.getpid(), signal.SIGKILL)
    if seed == 7:
        time.sleep(60)
    return "even" if seed % 2 == 0 else "odd"


def test_what_fails_hangs_or_kills_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(blocks, "LONGEST_S", 1.0)
    kind, place = Kind("strange", strange, 4), Place(tmp_path)
    for block in kind.blocks(range(10)):
        place.search(kind, block)
    counts, findings = place.told(kind, range(10))
    assert counts == {"even": 5, "odd": 2, "found": 3}
    assert findings == [
        "3: RuntimeError: a panic, say", "5: took its process down", "7: not done within 1 s",
    ]  # fmt: skip


def test_it_goes_on_where_it_was(tmp_path: Path) -> None:
    tried: list[int] = []

    def case(seed: int) -> str:
        with (tmp_path / "tried").open("a") as file:
            file.write(f"{seed}\n")
        return "done"

    kind, place = Kind("some", case, 5), Place(tmp_path)
    for seeds in (range(10), range(15), range(15)):
        for block in kind.blocks(seeds):
            place.search(kind, block)
    tried = [int(line) for line in (tmp_path / "tried").read_text().split()]
    assert tried == list(range(15))
    assert place.told(kind, range(15))[0] == {"done": 15}
