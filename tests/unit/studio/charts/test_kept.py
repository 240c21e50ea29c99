"""Things made of files: made once, made again when a file changes, forgotten beyond the memory."""

from dataclasses import dataclass
from pathlib import Path
from threading import Barrier, Thread

from arcless.studio.charts.kept import Kept


@dataclass(eq=False)
class Thing:
    bytes: int
    text: str


class Maker:
    def __init__(self, size: int = 10) -> None:
        self.made: list[str] = []
        self.size = size

    def __call__(self, *files: Path) -> Thing:
        self.made.append(" ".join(one.name for one in files))
        return Thing(self.size, " ".join(one.read_text() for one in files))


def written(folder: Path, name: str, text: str) -> Path:
    file = folder / name
    file.write_text(text)
    return file


def test_a_thing_is_made_once(tmp_path: Path) -> None:
    make, file = Maker(), written(tmp_path, "a", "1")
    kept = Kept(make)
    assert kept.of(file) is kept.of(file)
    assert make.made == ["a"]


def test_a_file_that_changed_is_read_again_and_its_past_forgotten(tmp_path: Path) -> None:
    make, file = Maker(), written(tmp_path, "a", "1")
    kept = Kept(make)
    kept.of(file)
    # Written as all files of the package are: another file takes the place.
    written(tmp_path, "b", "2").replace(file)
    assert kept.of(file).text == "2"
    assert len(kept._things) == 1


def test_the_oldest_are_forgotten_beyond_the_memory(tmp_path: Path) -> None:
    make = Maker(size=40)
    kept = Kept(make, most_bytes=100)
    files = [written(tmp_path, name, name) for name in "abc"]
    for file in (files[0], files[1], files[0], files[2]):
        kept.of(file)
    # b was used longest ago.
    assert [one.text for one in kept._things.values()] == ["a", "c"]
    kept.of(files[1])
    assert make.made == ["a", "b", "c", "b"]


def test_a_thing_larger_than_the_memory_is_kept_alone(tmp_path: Path) -> None:
    kept = Kept(Maker(size=1000), most_bytes=100)
    files = [written(tmp_path, name, name) for name in "ab"]
    for file in files:
        kept.of(file)
    assert [one.text for one in kept._things.values()] == ["b"]


def test_threads_that_ask_at_once_make_one(tmp_path: Path) -> None:
    make, file = Maker(), written(tmp_path, "a", "1")
    kept, together = Kept(make), Barrier(4)

    def ask() -> None:
        together.wait()
        kept.of(file)

    threads = [Thread(target=ask) for _ in range(4)]
    for one in threads:
        one.start()
    for one in threads:
        one.join()
    assert make.made == ["a"]
