"""Spools: rows are found by their time, a full disk ends the motion alone."""

import os
from pathlib import Path

import numpy as np
import pytest

from arcless.platforms.shared_files import new_file
from arcless.studio.motion import spool
from arcless.studio.motion.channels import MotionSource, Piece, moves_wires
from arcless.studio.motion.spool import SpooledMotion, SpoolWriter
from tests.support.studio_tasks import EVERY_S, GEOMETRY, LAYOUT, NODES, rows_of


def spooled(count: int) -> tuple[SpoolWriter, SpooledMotion]:
    file = new_file()
    motion = SpooledMotion(file, LAYOUT, GEOMETRY, every_s=EVERY_S, estimated_end_s=9.0)
    writer = SpoolWriter(file.fileno(), LAYOUT.type, lambda n, t, f: motion.grow(n, t, final=f))
    writer.append(rows_of(0, count))
    writer.finish()
    return writer, motion


def numbers(motion: MotionSource, *asked: float) -> list[float]:
    return [float(moment[0].values[0]) for moment in motion.moments(*asked)]


@pytest.mark.parametrize(
    ("asked", "found"),
    [
        ((0.0, 9.0, 0.0), range(100)),
        ((0.1, 0.2, 0.0), range(10, 21)),  # both ends are inside
        ((0.101, 0.199, 0.0), range(11, 20)),
        ((0.0, 1.0, 5 * EVERY_S), range(0, 100, 5)),
        ((0.0, 1.0, EVERY_S / 3), range(100)),
        ((-5.0, 0.02, 0.0), range(3)),
        ((0.98, 50.0, 0.0), range(98, 100)),
        ((2.0, 3.0, 0.0), range(0)),
        ((0.5, 0.4, 0.0), range(0)),
    ],
)
def test_rows_by_time(asked: tuple[float, float, float], found: range) -> None:
    _, motion = spooled(100)
    assert numbers(motion, *asked) == list(found)


def test_what_a_row_holds() -> None:
    _, motion = spooled(100)
    [[wire, pantograph]] = motion.moments(0.42, 0.42, 0.0)
    assert (wire.channel, wire.first, wire.values.tolist()) == (0, 0, [42.0] * NODES)
    assert motion.channels[pantograph.channel].name == "pantograph.0"
    assert pantograph.values.tolist() == [42.0] * 5
    assert moves_wires(motion)
    assert (motion.start_s, motion.end_s, motion.final) == (0.0, pytest.approx(0.99), True)
    assert motion.size == os.fstat(motion._file.fileno()).st_size


def test_few_reads_find_a_row(monkeypatch: pytest.MonkeyPatch) -> None:
    _, motion = spooled(5000)
    reads = []
    read = spool.read_at
    monkeypatch.setattr(spool, "read_at", lambda *given: reads.append(given) or read(*given))
    numbers(motion, 31.41, 31.41, 0.0)
    # First row, up to six around the guess for each end, and the row itself.
    assert len(reads) < 20


def test_a_full_disk_ends_the_motion_and_not_the_run(monkeypatch: pytest.MonkeyPatch) -> None:
    writer, motion = spooled(10)

    def full(*_: object) -> int:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(spool, "write_at", full)
    writer.append(rows_of(10, 10))
    monkeypatch.undo()
    writer.append(rows_of(20, 10))  # a gap would be worse than an early end
    writer.finish()
    assert writer.full
    assert numbers(motion, 0.0, 9.0, 0.0) == list(range(10))


def test_a_spool_has_a_largest_size(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(spool, "LARGEST", 15 * LAYOUT.type.itemsize)
    writer, motion = spooled(10)
    writer.append(rows_of(10, 10))
    assert writer.full
    assert motion.size == 10 * LAYOUT.type.itemsize


def test_a_spool_has_no_name(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    with new_file() as file:
        file.write(b"something")
        assert not list(tmp_path.iterdir())


def test_a_frame() -> None:
    frame = Piece(3, 7, 1.5, np.array([1.0, -2.0], np.float32)).frame(9)
    assert frame[:8] == (9).to_bytes(4, "little") + (7).to_bytes(4, "little")
    assert np.frombuffer(frame[8:16], "<f8") == 1.5
    assert np.frombuffer(frame[16:], "<f4").tolist() == [1.0, -2.0]
