"""Spoilt tables of frequency responses are refused with the file, or fitted by a pantograph."""

from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.hostile.campaign import receptances
from tests.support.hostile import searching, spoilt_text


@pytest.mark.parametrize("quantity", receptances.QUANTITIES)
def test_the_tables_are_sound(tmp_path: Path, quantity: str) -> None:
    path = tmp_path / "bench.csv"
    path.write_text(receptances.sound(quantity), encoding="utf-8")
    for order, damping in ((1, "joints"), (2, "full")):
        assert receptances.answered(path, order, damping) == "fitted"


@searching(60)
@given(data=st.data())
def test_spoilt_bytes(data: Any, tmp_path_factory: pytest.TempPathFactory) -> None:
    path = tmp_path_factory.getbasetemp() / "receptance.csv"
    text = receptances.sound(data.draw(st.sampled_from(list(receptances.QUANTITIES))))
    path.write_bytes(data.draw(spoilt_text(text.encode())))
    receptances.answered(path, data.draw(st.sampled_from([1, 2])), "joints")
