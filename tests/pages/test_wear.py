"""The picture of wear over uplift force, from a table that is written down."""

from pathlib import Path

import make_wear

KEYS = ("wear_total_mm3_km", "wear_mechanical_mm3_km", "wear_joule_mm3_km", "wear_arc_mm3_km")


def row(speed: float, force: float, *wear: float) -> dict[str, float]:
    given = dict(zip(KEYS, wear, strict=True))
    return {"speed": speed, "uplift_force": force, "contact_loss_percent": 0.5, **given}


ROWS = [
    row(kmh / 3.6, force, *wear)
    for kmh in (200, 250, 300, 350)
    for force, wear in ((200, (8, 7, 1, 0)), (50, (9, 1, 2, 6)), (100, (4, 2, 1, 1)))
]


def test_minima_at_each_speed() -> None:
    lines = make_wear.minima(ROWS).splitlines()
    assert lines[2:] == [
        f"| {kmh} | 100 | 4.00 | 2.00 | 1.00 | 1.00 | 0.50 |" for kmh in (200, 250, 300, 350)
    ]


def test_drawn_twice_it_is_the_same_file(tmp_path: Path) -> None:
    one, other = tmp_path / "one.svg", tmp_path / "other.svg"
    make_wear.draw(ROWS, str(one))
    make_wear.draw(ROWS, str(other))
    assert one.read_bytes() == other.read_bytes()
    assert "illustrative" in one.read_text("utf-8")
